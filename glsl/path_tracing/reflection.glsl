// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Reflection of a surface, by the same formulas as direct_light/resolve.frag, and importance sampling of its
// directions. Needs rays/surface.glsl, lib/pbr.glsl, lib/phong.glsl,
// lib/sampling.glsl.
#include "lib/compensation.glsl"
#include "lib/data_colors.glsl"

// Below this roughness a lobe is as good as a mirror: its width, the square of the roughness, is less than a pixel, and
// floats no longer distinguish its half vectors.
const float GI_MIRROR_ROUGHNESS = 0.0316;

struct GiReflector
{
  vec3 N;
  vec3 V;
  vec3 albedo;
  vec3 specular; // Phong
  float power;   // Phong
  bool pbr;
  float metallic;
  float roughness;
  float lobe; // roughness of the lobe for sampling, at least GI_MIRROR_ROUGHNESS
  vec3 f0;
  vec3 f90;
  vec3 boost; // factor of the highlight
  float occlusion;
  float gloss; // probability of sampling the highlight
  bool data;   // indirect light is reflected as on surfaces coloured by data
};

GiReflector giReflector(RaySurfacePoint at, int model, vec3 V)
{
  GiReflector r;
  vec3 N = at.normal;
  r.N = N;
  r.V = V;
  r.albedo = at.color.rgb;
  r.pbr = model == GI_SURFACE_PBR;
  r.specular = r.pbr ? vec3(0.0) : at.specular.rgb;
  r.power = r.pbr ? 1.0 : at.specular.w;
  r.metallic = at.metallic;
  r.roughness = at.roughness;
  r.lobe = max(at.roughness, GI_MIRROR_ROUGHNESS);
  r.occlusion = at.occlusion;
  r.f0 = mix(vec3(at.specular.w), at.color.rgb, r.metallic);
  r.f90 = mix(vec3(clamp(dot(r.f0, vec3(50.0 * 0.33)), 0.0, 1.0)), at.specular.rgb, r.metallic);
  r.boost = vec3(1.0);
  if (r.pbr && giCompensates)
  {
    r.boost = giCompensation(r.f0, giHighlightShare(clamp(dot(N, V), 1e-5, 1.0), r.roughness));
  }
  r.data = false;
  float matte = dot(r.albedo, vec3(1.0)) * (r.pbr ? 1.0 - r.metallic : 1.0);
  vec3 fresnel = giFresnelSchlick(r.f0, r.f90, clamp(dot(N, V), 0.0, 1.0));
  float shiny = r.pbr ? dot(fresnel, vec3(1.0)) : 2.0 * dot(r.specular, vec3(1.0)) / (r.power + 1.0);
  r.gloss = shiny > 0.0 ? clamp(shiny / (matte + shiny), matte > 0.0 ? 0.1 : 1.0, 1.0) : 0.0;
  return r;
}

// Radiance toward V for unit radiance from a unit solid angle about L, including the cosine. roughness: of a PBR lobe.
// diffuseShare: as in giReflectPBR().
vec3 giReflect(GiReflector r, vec3 L, float roughness, float diffuseShare)
{
  float facing = dot(r.N, L);
  if (facing <= 0.0)
  {
    return vec3(0.0);
  }
  if (r.pbr)
  {
    return r.occlusion * giReflectPBR(r.N, r.V, L, r.albedo, r.metallic, roughness, r.f0, r.f90, r.boost, diffuseShare);
  }
  return (diffuseShare * r.albedo * facing + r.specular * giPhongSpecular(r.N, -L, r.V, r.power)) / GI_PI;
}

// Reflection of extended sources: emitters, surfaces, the environment.
vec3 giReflect(GiReflector r, vec3 L)
{
  return giReflect(r, L, r.lobe, 1.0);
}

// The highlight's part of giReflect().
vec3 giReflectGloss(GiReflector r, vec3 L)
{
  return giReflect(r, L, r.lobe, 0.0);
}

// Reflection of a point light. As in VTK, a perfect mirror shows nothing of it.
vec3 giReflectPointLight(GiReflector r, vec3 L)
{
  return giReflect(r, L, r.roughness, 1.0);
}

// Indirect light as it arrives for reflection.
vec3 giArriving(GiReflector r, vec3 light)
{
  return r.data ? giDataLight(light) : light;
}

vec3 giSampleReflection(GiReflector r, float lobe, vec2 u)
{
  if (lobe >= r.gloss)
  {
    return giBasis(r.N) * giSampleCosine(u);
  }
  if (r.pbr)
  {
    vec3 H = giBasis(r.N) * giSampleGGX(u, r.lobe * r.lobe);
    return reflect(-r.V, H);
  }
  return giBasis(reflect(-r.V, r.N)) * giSamplePower(u, r.power);
}

// Probability density per solid angle of giSampleReflection().
float giReflectionDensity(GiReflector r, vec3 L)
{
  float matte = max(dot(r.N, L), 0.0) / GI_PI;
  float shiny = 0.0;
  if (r.pbr)
  {
    vec3 H = normalize(r.V + L);
    float NdH = max(dot(r.N, H), 0.0);
    shiny = giDistributionGGX(NdH, r.lobe) * NdH / max(4.0 * abs(dot(r.V, H)), 1e-6);
  }
  else if (r.gloss > 0.0)
  {
    shiny = (r.power + 1.0) / (2.0 * GI_PI) *
      pow(max(dot(reflect(-r.V, r.N), L), 0.0), r.power);
  }
  return mix(matte, shiny, r.gloss);
}
