// Stands in for a technique that knows the visibility of lights (see forward/lights.glsl): nothing is occluded.
float giVisibility(int shadow, vec3 P, vec3 N, vec3 facet, float bulge)
{
  return 1.0;
}

float giVisibility(int shadow, vec3 P)
{
  return 1.0;
}
