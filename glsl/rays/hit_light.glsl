// Diffuse light on a surface where a ray ends, and the share of it that the surface reflects. Needs shared/light.h,
// rays/surface.glsl, rays/passage.glsl, rays/toward_light.glsl, rays/sky.glsl, lib/lights.glsl, lib/light_points.glsl.
// Variants: GI_RAY_SKY (the environment shines), GI_SKY_AT_HITS (and is looked for here), GI_SEEK_EMITTERS (emitters are
// looked for here; needs rays/emitters.glsl).
uniform int lightCount;
uniform vec3 eye; // relative to the scene's origin, for headlights

const float HIT_PI = 3.14159265;
const int HIT_LIGHTS = 4; // with more lights, a random one is sampled

// Irradiance from a light, divided by pi. A VTK light stands for an irradiance of pi times its colour on Phong
// materials, and of its colour on PBR materials.
vec3 hitLightFrom(LightData light, RaySurfacePoint at, bool pbr, inout uint state)
{
  RayArrival arrival = rayArrival(light, at.position, eye, state);
  float facing = dot(at.normal, arrival.L);
  if (facing <= 0.0 || arrival.share <= 0.0 || dot(light.Color.rgb, vec3(1.0)) <= 0.0)
  {
    return vec3(0.0);
  }
  if (!rayReaches(arrival.toward, at, state))
  {
    return vec3(0.0);
  }
  return light.Color.rgb * (arrival.share * facing * (pbr ? 1.0 / HIT_PI : 1.0));
}

vec3 hitDirectLight(RaySurfacePoint at, bool pbr, inout uint state)
{
  vec3 sum = vec3(0.0);
  bool all = lightCount <= HIT_LIGHTS;
  for (int i = 0; i < (all ? lightCount : 1); ++i)
  {
    int chosen = all ? i : min(int(giRandom(state) * float(lightCount)), lightCount - 1);
    sum += (all ? 1.0 : float(lightCount)) * hitLightFrom(lights[chosen], at, pbr, state);
  }
  return sum;
}

#if defined(GI_RAY_SKY) && defined(GI_SKY_AT_HITS)
// Irradiance from one direction of the sky, divided by pi.
vec3 hitSkyLight(RaySurfacePoint at, inout uint state)
{
  float density;
  vec3 L = raySkySample(vec2(giRandom(state), giRandom(state)), density);
  float facing = dot(at.normal, L);
  bool arrives = facing > 0.0 && density > 0.0 && rayReaches(vec4(L, RAY_FAR), at, state);
  return arrives ? raySkyRadiance(L) * (facing / (HIT_PI * density)) : vec3(0.0);
}
#endif

#ifdef GI_SEEK_EMITTERS
const float HIT_NEAREST = 8.0; // bound on a sample's share of the emission, where the true share is at most 1

// Irradiance from one point of the emitters, divided by pi.
vec3 hitEmitterLight(RaySurfacePoint at, inout uint state)
{
  vec2 u = vec2(giRandom(state), giRandom(state));
  EmitterChoice choice = emitterChoice(state);
  for (int i = 0; i < EMITTER_CANDIDATES; ++i)
  {
    EmitterPoint point = emitterPoint(emitterCandidate(u, i), at.position, at.normal, state);
    float facing = dot(at.normal, normalize(point.path));
    float share = facing > 0.0 && point.density > 0.0
      ? min(facing / (HIT_PI * point.density), HIT_NEAREST)
      : 0.0;
    emitterConsider(choice, point.path, share * point.emission);
  }
  bool arrives = choice.sum > 0.0 && rayReaches(vec4(choice.path, 1.0 - 1e-4), at, state);
  return arrives ? emitterArriving(choice) : vec3(0.0);
}
#endif

// Share of the light that a surface reflects; all reflection is diffuse here.
vec3 hitReflectance(RaySurfacePoint at)
{
  int model = raySurfaces[at.surface].Where.z & GI_SURFACE_MODEL;
  if (model == GI_SURFACE_UNLIT)
  {
    return vec3(0.0);
  }
  vec3 albedo = model == GI_SURFACE_PBR
    ? at.occlusion * mix(at.color.rgb * (1.0 - at.specular.w) + at.specular.w, at.color.rgb, at.metallic)
    : at.color.rgb;
  return min(albedo, vec3(1.0));
}

// Irradiance that arrives straight from lights, divided by pi; from the environment if GI_SKY_AT_HITS, and from emitters if
// GI_SEEK_EMITTERS.
vec3 hitStraightLight(RaySurfacePoint at, inout uint state)
{
  bool pbr = (raySurfaces[at.surface].Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PBR;
  vec3 light = hitDirectLight(at, pbr, state);
#if defined(GI_RAY_SKY) && defined(GI_SKY_AT_HITS)
  light += hitSkyLight(at, state);
#endif
#ifdef GI_SEEK_EMITTERS
  light += hitEmitterLight(at, state);
#endif
  return light;
}

// Radiance that a surface reflects of that.
vec3 hitReflected(RaySurfacePoint at, inout uint state)
{
  vec3 reflectance = hitReflectance(at);
  return reflectance == vec3(0.0) ? vec3(0.0) : reflectance * hitStraightLight(at, state);
}
