// Light from uniform surroundings at a partly occluded surface, with all interreflections. Occluders are assumed to be
// as bright as the surface itself, as in a cavity of one colour: E = openness + (1 - openness) albedo E. Exact in a
// spherical cavity. The gain is the ratio to the light that arrives straight from the surroundings.
vec3 giReflectedGain(float openness, vec3 albedo)
{
  return 1.0 / (1.0 - clamp(albedo, 0.0, 0.99) * (1.0 - openness));
}

vec3 giInterreflected(float openness, vec3 albedo)
{
  return openness * giReflectedGain(openness, albedo);
}
