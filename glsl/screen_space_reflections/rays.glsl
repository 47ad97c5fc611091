// Radiance along a ray through the scene, for reflections that the screen does not show: the direct light on the
// surface that the ray hits and, if the environment lights PBR surfaces, one sample of the environment, unshadowed as
// in VTK. Variants: GI_RAY_SKY (the environment shines), and those of rays/passage.glsl. Needs shared/light.h,
// lib/lights.glsl with GI_POSITIONAL, lib/light_points.glsl, lib/phong.glsl, rays/passage.glsl, path_tracing/reflection.glsl.
#ifdef GI_RAY_SKY
#include "rays/sky.glsl"
#endif
uniform mat3 viewToScene;
uniform vec3 eye;          // relative to the scene's origin
uniform int lightCount;
uniform float lampShare;   // share of the lights' strength that is not spread over all directions
uniform vec3 ambientLight; // radiance that a white diffuse surface reflects from the rest

// Only lights that cast shadows in the picture cast shadows here.
bool isUnoccluded(LightData light, vec4 toward, RaySurfacePoint at, inout uint state)
{
  if (light.Kind.y < 0)
  {
    return true;
  }
  return rayReaches(toward, at, state);
}

// Returns false if the ray hits nothing. P, N, L: in view coordinates.
bool rayRadiance(vec3 P, vec3 N, vec3 L, inout uint state, out vec3 radiance)
{
  // The depth buffer is precise to about a millionth of the distance. Slopes need a larger offset.
  vec3 origin = eye + viewToScene * (P + 1e-4 * length(P) * N);
  Ray ray = Ray(origin, 0.0, viewToScene * L, RAY_FAR);
  RaySurfacePoint at;
  float first;
  radiance = vec3(0.0);
  if (traceThrough(ray, at, first, state).instance < 0)
  {
    return false;
  }
  radiance = at.emission;
  int model = raySurfaces[at.surface].Where.z & GI_SURFACE_MODEL;
  if (model == GI_SURFACE_UNLIT)
  {
    return true;
  }
  GiReflector r = giReflector(at, model, -ray.direction);
  radiance += ambientLight * (r.pbr ? (1.0 - r.metallic) * r.occlusion / GI_PI : 1.0) * r.albedo;
  for (int i = 0; i < lightCount; ++i)
  {
    RayArrival arrival = rayArrival(lights[i], at.position, eye, state);
    vec3 reflected = lights[i].Color.rgb * arrival.share * (r.pbr ? 1.0 : GI_PI) *
      giReflectPointLight(r, arrival.L);
    if (dot(reflected, vec3(1.0)) > 0.0 && isUnoccluded(lights[i], arrival.toward, at, state))
    {
      radiance += lampShare * reflected;
    }
  }
#ifdef GI_RAY_SKY
  if (r.pbr)
  {
    float density;
    vec3 S = raySkySample(vec2(giRandom(state), giRandom(state)), density);
    float share = density > 0.0 ? (1.0 - r.metallic) * r.occlusion / (GI_PI * density) : 0.0;
    radiance += share * max(dot(r.N, S), 0.0) * (1.0 - r.f0) * r.albedo * raySkyRadiance(S);
  }
#endif
  return true;
}
