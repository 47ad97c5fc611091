// Uniform surroundings, seen from a surface of which a part is open to them, with all reflections
// between surfaces: what closes the rest is taken for as bright as the surface itself, as in a
// hollow of one colour, E = openness + (1 - openness) albedo E. Exact in a spherical hollow.
vec3 giInterreflected(float openness, vec3 albedo)
{
  return openness / (1.0 - clamp(albedo, 0.0, 0.99) * (1.0 - openness));
}
