// Similarity of two pixels: whether they show the same surface. Needs shared/view.h, lib/octahedral.glsl and
// lib/reconstruct.glsl.
struct GiSurfel
{
  float depth;     // window depth
  vec2 slope;      // change of the plane's depth per pixel
  vec2 normal;     // octahedral
  float sharpness; // loss of similarity per depth off the plane
  float bend;      // loss of similarity per squared difference of normals
};

// stride: pixels between neighbours.
GiSurfel giSurfel(vec2 place, float depth, vec2 normal, float stride)
{
  vec3 P = giViewPosition(place, depth);
  vec3 N = giDecodeOctahedral(normal);
  // A plane stays a plane in window coordinates: transform the surface's plane.
  vec4 plane = vec4(N, -dot(N, P)) * view.ClipToView;
  vec3 windowNormal = plane.xyz * vec3(2.0 / view.Viewport.zw, 2.0);
  GiSurfel surfel;
  surfel.depth = depth;
  surfel.normal = normal;
  // At grazing angles depth says little.
  float lateral = length(windowNormal.xy);
  surfel.slope = -windowNormal.xy / (abs(windowNormal.z) > 1e-4 * lateral ? windowNormal.z : 1e-4 * lateral);
  // The tolerance is a pixel's width. A curved surface departs from its plane faster per pixel at
  // grazing angles.
  float pixel = length(giViewPosition(place + vec2(stride, 0.0), depth) - P);
  float toEye = clamp(abs(dot(N, giToEye(P))), 0.2, 1.0);
  float w = view.ClipToView[2].w * (2.0 * depth - 1.0) + view.ClipToView[3].w;
  surfel.sharpness = abs(windowNormal.z / w) * toEye / pixel;
  surfel.bend = 10.0; // normals more than about 60 degrees apart have no similarity
  return surfel;
}

float giSimilarity(GiSurfel here, vec2 offset, float depth, vec2 normal)
{
  float distance = abs(depth - here.depth - dot(here.slope, offset)) * here.sharpness;
  vec2 difference = normal - here.normal;
  return clamp(2.0 - distance, 0.0, 1.0) * clamp(1.0 - here.bend * dot(difference, difference), 0.0, 1.0);
}
