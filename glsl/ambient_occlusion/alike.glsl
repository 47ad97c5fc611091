// Whether two pixels show the same surface. Needs shared/view.h and lib/reconstruct.glsl.
struct GiSurfel
{
  vec3 position;
  vec3 normal;
  float tolerance; // world units off the plane
};

// `stride`: pixels between neighbours.
GiSurfel giSurfel(vec2 window, float depth, vec3 N, float stride)
{
  vec3 P = giViewPosition(window, depth);
  float pixel = length(giViewPosition(window + vec2(stride, 0.0), depth) - P);
  // A bent surface leaves its plane faster per pixel where it is seen from the side.
  return GiSurfel(P, N, pixel / clamp(dot(N, giToEye(P)), 0.2, 1.0));
}

float giAlike(GiSurfel here, vec3 position, vec3 normal)
{
  float off = abs(dot(here.normal, position - here.position));
  // Nothing of what is turned by more than 60 degrees.
  return clamp(2.0 - off / here.tolerance, 0.0, 1.0) *
    clamp(2.0 * dot(here.normal, normal) - 1.0, 0.0, 1.0);
}
