// Reflection lobe of a pixel's surface: the highlight of direct_light/resolve.frag as a distribution
// of directions. Needs shared/view.h, shared/material.h, lib/octahedral.glsl, lib/reconstruct.glsl,
// lib/pbr.glsl, lib/sampling.glsl. Variants: GI_EXTENDED (textures, PBR).
#include "lib/luminance.glsl"
#include "lib/compensation.glsl"
#include "lib/data_colors.glsl"
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
#ifdef GI_EXTENDED
layout(binding = 3) uniform sampler2D surfaceTexture;
#endif
layout(binding = 4) uniform sampler2D lobeTable;

uniform float maximumRoughness;
uniform float minimumReflectance;

// Width below which a lobe is a mirror, as its blur is less than a pixel.
const float MIRROR = 1e-3;

struct Lobe
{
  vec3 N;
  vec3 V;
  bool reflects;
  bool pbr;
  float roughness; // for Phong: roughness of a PBR lobe of the same width
  float width;     // GGX
  float power;     // Phong
  vec3 f0;         // PBR
  vec3 f90;        // PBR
  vec3 color;      // reflectance of the whole lobe
};

// Roughness of the GGX lobe that matches a Phong lobe. The half vectors of a Phong lobe with exponent p are distributed
// as the cosine to the power 4 p + 2. At its peak GGX has this distribution for a width of (2 / (4 p + 2))^(1/2)
// (Walter et al. 2007, equation 35).
float phongRoughness(float power)
{
  return pow(1.0 / (2.0 * power + 1.0), 0.25);
}

// x, y: reflectance of the metallic-roughness lobe under uniform light, the factors of f0 and f90; z: the part of a
// Phong lobe that is above the horizon.
vec3 lobeShares(float cosine, float roughness)
{
  vec2 size = vec2(textureSize(lobeTable, 0));
  return textureLod(lobeTable, (vec2(cosine, roughness) * (size - 1.0) + 0.5) / size, 0.0).xyz;
}

Lobe lobeAt(ivec2 window, vec3 P)
{
  Lobe lobe;
  vec4 normal = texelFetch(normalTexture, window, 0);
  MaterialData material = materials[int(normal.z * 65535.0 + 0.5)];
  lobe.N = giDecodeOctahedral(normal.xy);
  lobe.V = giToEye(P);
  float NdV = clamp(dot(lobe.N, lobe.V), 0.0, 1.0);
  lobe.pbr = material.Model.x == GI_MATERIAL_PBR;
  lobe.reflects = material.Model.x != GI_MATERIAL_AS_DRAWN && (material.Model.y & GI_MATERIAL_THIN) == 0;
  lobe.power = material.Specular.w;
  lobe.roughness = phongRoughness(lobe.power);
  lobe.f0 = vec3(0.0);
  lobe.f90 = vec3(0.0);
  float occlusion = 1.0;
  lobe.color = material.Specular.rgb * 2.0 / (lobe.power + 1.0);
#ifdef GI_EXTENDED
  vec4 surface = texelFetch(surfaceTexture, window, 0);
  if (lobe.pbr)
  {
    vec3 albedo = texelFetch(albedoTexture, window, 0).rgb;
    lobe.roughness = surface.b;
    lobe.f0 = mix(vec3(material.Specular.w), albedo, surface.r);
    lobe.f90 = mix(
      vec3(clamp(dot(lobe.f0, vec3(50.0 * 0.33)), 0.0, 1.0)), material.Specular.rgb, surface.r);
  }
  else
  {
    lobe.color *= surface.rgb;
  }
  occlusion = lobe.pbr ? surface.g : 1.0;
#endif
  vec3 shares = lobeShares(NdV, lobe.roughness);
  lobe.color = lobe.pbr ? occlusion * (lobe.f0 * shares.x + lobe.f90 * shares.y) : lobe.color * shares.z;
  lobe.color *= lobe.pbr && giCompensates ? giCompensation(lobe.f0, shares.x + shares.y) : vec3(1.0);
  lobe.width = lobe.roughness * lobe.roughness;
  return lobe;
}

bool isWeak(Lobe lobe)
{
  return max(lobe.color.r, max(lobe.color.g, lobe.color.b)) < minimumReflectance;
}

bool isRough(Lobe lobe)
{
  return lobe.roughness > maximumRoughness;
}

bool isMirror(Lobe lobe)
{
  return lobe.width < MIRROR;
}

bool isTraced(Lobe lobe)
{
  return lobe.reflects && !isWeak(lobe) && !isRough(lobe);
}

// Smith's masking of GGX for one direction (Walter et al. 2007, equation 34).
float maskingGGX(float cosine, float width)
{
  float a2 = width * width;
  return 2.0 * cosine / (cosine + sqrt(a2 + (1.0 - a2) * cosine * cosine));
}

// Samples a direction of the lobe.
vec3 sampleLobe(Lobe lobe, vec2 u)
{
  if (isMirror(lobe))
  {
    return reflect(-lobe.V, lobe.N);
  }
  if (!lobe.pbr)
  {
    return giBasis(reflect(-lobe.V, lobe.N)) * giSamplePower(u, lobe.power);
  }
  mat3 basis = giBasis(lobe.N);
  vec3 V = transpose(basis) * lobe.V;
  V.z = max(V.z, 1e-4);
  return reflect(-lobe.V, basis * giSampleVisibleGGX(u, normalize(V), lobe.width));
}

// Probability density per solid angle of sampleLobe().
float lobeDensity(Lobe lobe, vec3 L)
{
  if (!lobe.pbr)
  {
    return (lobe.power + 1.0) / (2.0 * GI_PI) *
      pow(max(dot(reflect(-lobe.V, lobe.N), L), 0.0), lobe.power);
  }
  float NdV = max(dot(lobe.N, lobe.V), 1e-4);
  float NdH = clamp(dot(lobe.N, normalize(lobe.V + L)), 0.0, 1.0);
  return giDistributionGGX(NdH, lobe.roughness) * maskingGGX(NdV, lobe.width) / (4.0 * NdV);
}

// Weight of light from a direction in the reflection: the value of the lobe, including the cosine, up to a factor that
// is the same for all directions.
float lobeValue(Lobe lobe, vec3 L)
{
  float NdL = dot(lobe.N, L);
  if (NdL <= 0.0)
  {
    return 0.0;
  }
  if (!lobe.pbr)
  {
    return lobeDensity(lobe, L);
  }
  vec3 H = normalize(lobe.V + L);
  float NdV = clamp(dot(lobe.N, lobe.V), 1e-4, 1.0);
  float NdH = clamp(dot(lobe.N, H), 0.0, 1.0);
  vec3 F = giFresnelSchlick(lobe.f0, lobe.f90, clamp(dot(H, L), 0.0, 1.0));
  return giDistributionGGX(NdH, lobe.roughness) * giVisibilitySmith(NdV, NdL, lobe.roughness) *
    giLuminance(F) * NdL;
}
