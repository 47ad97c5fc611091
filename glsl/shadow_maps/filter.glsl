// What of a light reaches a point of a plane: the share of a disc in that plane. Needs
// shadow_maps/sheet.glsl and lib/noise.glsl. Variants, as software renderers run the branches that are
// not taken too: GI_CUBE (a light with six maps), GI_SOFT (a light that has a size).
uniform int filterSamples;
uniform int blockerSamples;
uniform int penumbraSamples;
uniform float filterRadius; // in texels
uniform float pixelRadius;  // and no less than this, in pixels

// The map of six that a direction from the light falls into, in the order +x -x +y -y +z -z.
int giFaceOf(vec3 fromLight)
{
  vec3 d = mat3(view.ViewToWorld) * fromLight;
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z)
  {
    return d.x > 0.0 ? 0 : 1;
  }
  if (a.y >= a.z)
  {
    return d.y > 0.0 ? 2 : 3;
  }
  return d.z > 0.0 ? 4 : 5;
}

struct GiReceiver
{
  vec3 P;         // moved by the bias
  vec3 U;         // two points of the plane, one unit across the light from P
  vec3 V;
  vec3 L;         // toward the light
  vec2 rise;      // how much farther toward the light U and V go in the plane of what is around
  float texel;    // width of the map's there, in world units
  float pixel;    // and the picture's
};

// The place of a point of the disc, on another face of a cube where it lies beyond the first.
vec3 giTap(ShadowLightData lamp, GiReceiver receiver, vec2 offset, inout GiSheet sheet)
{
  vec3 at = giPlace(sheet, offset);
#if defined(GI_CUBE) && defined(GI_SOFT)
  if (lamp.Maps.z == GI_SHADOW_CUBE && giIsOutside(sheet, at))
  {
    vec3 Q = receiver.P + offset.x * receiver.U + offset.y * receiver.V;
    Q += receiver.L * max(dot(offset, receiver.rise), 0.0);
    sheet = giSheet(lamp.Maps.x + giFaceOf(Q - lamp.Position.xyz), Q, receiver.U, receiver.V, receiver.L,
      receiver.rise);
    at = sheet.middle;
  }
#endif
  return at;
}

float giFiltered(ShadowLightData lamp, GiReceiver receiver, GiSheet sheet, float radius, int samples,
  float angle)
{
  float sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    GiSheet there = sheet;
    vec3 at = giTap(lamp, receiver, radius * giVogelDisc(i, samples, angle), there);
    sum += giOpen(there, at);
  }
  return sum / float(samples);
}

#ifdef GI_SOFT
// By how much the light's disc spreads over the receiver behind what stands at a depth of the map.
float giSpread(ShadowLightData lamp, int map, vec2 depths)
{
  vec2 range = shadowMaps[map].Scale.yz;
  if (lamp.Position.w < 0.5)
  {
    return lamp.Size.x * (depths.y - depths.x) * (range.y - range.x);
  }
  vec2 distances = range.x * range.y / mix(vec2(range.y), vec2(range.x), depths);
  return lamp.Size.x * (distances.y / distances.x - 1.0);
}

// Percentage-closer soft shadows (Fernando 2005): the mean spread behind what may block the light, of
// samples ever closer toward the middle, so that low blockers are found as well as high ones. What
// stands too low to hide the light from so far off counts for nothing. Negative where nothing blocks.
float giPenumbra(ShadowLightData lamp, GiReceiver receiver, GiSheet sheet, float angle)
{
  vec3 center = giPlace(sheet, vec2(0.0));
  float widest = giSpread(lamp, sheet.map, vec2(0.0, center.z));
  // No farther than half the map: there it tells little of what stands between.
  widest = min(widest,
    0.5 * receiver.texel * (sheet.area.z - sheet.area.x) * float(textureSize(atlas, 0).x));
  float sum = 0.0;
  float found = 0.0;
  for (int i = 0; i < blockerSamples; ++i)
  {
    float radius = widest * (float(i) + 0.5) / float(blockerSamples);
    float turn = float(i) * 2.39996323 + angle;
    GiSheet there = sheet;
    vec3 at = giTap(lamp, receiver, radius * vec2(cos(turn), sin(turn)), there);
    vec2 depths = giDepths(there, at);
    float spread = depths.x < depths.y ? giSpread(lamp, there.map, depths) : 0.0;
    if (spread > radius)
    {
      sum += spread;
      found += 1.0;
    }
  }
  return found > 0.0 ? min(sum / found, widest) : -1.0;
}
#endif

float giReaching(ShadowLightData lamp, GiReceiver receiver, int map, float angle)
{
  GiSheet sheet = giSheet(map, receiver.P, receiver.U, receiver.V, receiver.L, receiver.rise);
  float radius = max(filterRadius * receiver.texel, pixelRadius * receiver.pixel);
  int samples = filterSamples;
#ifdef GI_SOFT
  float penumbra = lamp.Size.x > 0.0 ? giPenumbra(lamp, receiver, sheet, angle) : -1.0;
  if (penumbra > radius)
  {
    radius = penumbra;
    samples = penumbraSamples;
  }
#endif
  return giFiltered(lamp, receiver, sheet, radius, samples, angle);
}
