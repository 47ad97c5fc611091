// Tone curves: from linear radiance, where 1 is a white surface under full light, to 0..1. All clamp what is not a number
// to 0 and what is infinite to white.

// The largest radiance, that of a half float.
const float GI_BRIGHTEST = 65504.0;

vec3 giFinite(vec3 color)
{
  return mix(clamp(color, vec3(0.0), vec3(GI_BRIGHTEST)), vec3(0.0), isnan(color));
}

// Khronos 2024, "Khronos PBR Neutral Tone Mapper". Colours below the shoulder, which begins at 0.8 - fresnel, keep their
// hue and their saturation. fresnel: reflectance of the material's coat, which the curve takes away; 0.04 as published,
// 0 for materials without one, whose colours below the shoulder then stay unchanged.
vec3 giToneNeutral(vec3 color, float fresnel)
{
  const float desaturation = 0.15;
  float start = 0.8 - fresnel;
  float least = min(color.r, min(color.g, color.b));
  color -= least < 2.0 * fresnel ? least - least * least / (4.0 * fresnel) : fresnel;
  float peak = max(color.r, max(color.g, color.b));
  if (peak < start)
  {
    return color;
  }
  float range = 1.0 - start;
  float newPeak = 1.0 - range * range / (peak + range - start);
  color *= newPeak / peak;
  float share = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
  return mix(color, vec3(newPeak), share);
}

// Narkowicz 2015, "ACES Filmic Tone Mapping Curve": toe, shoulder, and more contrast in between.
vec3 giToneFilmic(vec3 x)
{
  return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

const int GI_TONE_NONE = 0;
const int GI_TONE_NEUTRAL = 1;
const int GI_TONE_FILMIC = 2;

// encoded: the material is a PBR material, which has a coat and whose values VTK encodes for display.
vec3 giTone(int curve, vec3 color, bool encoded)
{
  color = giFinite(color);
  return curve == GI_TONE_NEUTRAL ? giToneNeutral(color, encoded ? 0.04 : 0.0)
    : curve == GI_TONE_FILMIC ? giToneFilmic(color)
    : min(color, 1.0);
}
