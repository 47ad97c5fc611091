// The surface that the rasterizer drew at a pixel, for rays that start there. Needs shared/view.h, rays/surface.glsl,
// lib/octahedral.glsl, lib/reconstruct.glsl, and samplers named depthTexture and normalTexture.
uniform mat3 viewToScene;

const float RAY_DEPTH_ERROR = 2.5e-7; // of a 24-bit depth buffer
const float RAY_REACH = 1e-3;         // half length of the ray that looks for the surface, as a share of the distance
const float RAY_TOWARD_EYE = 4.0;     // errors of the position; see below

// The surface that the rasterizer drew at a pixel. A ray that starts just in front of it finds it exactly.
RaySurfacePoint rayPixelSurface(ivec2 window)
{
  vec2 center = vec2(window) + 0.5;
  float depth = texelFetch(depthTexture, window, 0).r;
  vec3 surfacePosition = giViewPosition(center, depth);
  vec3 nearPosition = giViewPosition(center, 0.0);
  float distance = length(surfacePosition - nearPosition);
  float reach = RAY_REACH * distance +
    length(giViewPosition(center, min(depth + RAY_DEPTH_ERROR, 1.0)) - surfacePosition);
  vec3 direction = viewToScene * normalize(surfacePosition - nearPosition);
  vec3 position = eye + viewToScene * surfacePosition;
  vec3 N = viewToScene * giDecodeOctahedral(texelFetch(normalTexture, window, 0).xy);
  Ray ray = Ray(position - reach * direction, 0.0, direction, 2.0 * reach);
  RayHit hit = traceClosest(ray);
  RaySurfacePoint at;
  bool found = hit.instance >= 0;
  if (found)
  {
    at = raySurfaceAt(ray, hit);
    found = dot(at.geometric, N) > 0.1; // where two surfaces meet, the ray may find the other one
    // In a corner of a room the point may lie behind the other wall by a rounding error. Toward the eye it is in the open.
    at.position -= RAY_TOWARD_EYE * at.error * direction;
  }
  if (!found)
  {
    // Props that rays do not see receive light, too.
    at.position = hit.instance >= 0 ? position + reach * at.geometric : position;
    at.error = reach;
    at.geometric = N;
    at.bulge = vec3(0.0);
    at.bend = 0.0;
  }
  at.normal = N;
  return at;
}
