// Whether two pixels show the same surface. Needs shared/view.h, lib/octahedral.glsl and
// lib/reconstruct.glsl.
struct GiSurfel
{
  float depth; // of the window
  vec2 slope;  // of its plane, depth per pixel
  vec2 normal; // octahedral
  float sharpness; // per depth off the plane
};

// `stride`: pixels between neighbours.
GiSurfel giSurfel(vec2 place, float depth, vec2 normal, float stride)
{
  vec3 P = giViewPosition(place, depth);
  vec3 N = giDecodeOctahedral(normal);
  // In window coordinates a plane is a plane: the one of the surface, moved there.
  vec4 plane = vec4(N, -dot(N, P)) * view.ClipToView;
  vec3 window = plane.xyz * vec3(2.0 / view.Viewport.zw, 2.0);
  GiSurfel surfel;
  surfel.depth = depth;
  surfel.normal = normal;
  // Seen from the side depth says little.
  float across = length(window.xy);
  surfel.slope = -window.xy / (abs(window.z) > 1e-4 * across ? window.z : 1e-4 * across);
  // Off by as much as a pixel is wide; a bent surface leaves its plane faster per pixel where it is
  // seen from the side.
  float pixel = length(giViewPosition(place + vec2(stride, 0.0), depth) - P);
  float toEye = clamp(abs(dot(N, giToEye(P))), 0.2, 1.0);
  float w = view.ClipToView[2].w * (2.0 * depth - 1.0) + view.ClipToView[3].w;
  surfel.sharpness = abs(window.z / w) * toEye / pixel;
  return surfel;
}

float giAlike(GiSurfel here, vec2 offset, float depth, vec2 normal)
{
  float off = abs(depth - here.depth - dot(here.slope, offset)) * here.sharpness;
  vec2 turned = normal - here.normal;
  // Nothing of what is turned by more than about 60 degrees.
  return clamp(2.0 - off, 0.0, 1.0) * clamp(1.0 - 10.0 * dot(turned, turned), 0.0, 1.0);
}
