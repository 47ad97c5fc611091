// In place of a technique that knows what of a light arrives (see forward/lights.glsl): all of it.
float giVisibility(int shadow, vec3 P, vec3 N, vec3 facet, float bulge)
{
  return 1.0;
}

float giVisibility(int shadow, vec3 P)
{
  return 1.0;
}
