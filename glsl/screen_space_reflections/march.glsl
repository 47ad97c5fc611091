// Marches a ray through the depth buffer. In window coordinates a straight line stays straight, and its depth
// is linear along it, in perspective too. The ray therefore advances from cell to cell of the depth pyramid:
// across large cells where it is clear of everything in them, down to pixels where it may hit something
// (McGuire and Mara 2014, "Efficient GPU Screen-Space Ray Tracing"; Uludag 2014, "Hi-Z Screen-Space
// Cone-Traced Reflections"). Needs shared/view.h, shared/reflection.h, lib/octahedral.glsl,
// lib/reconstruct.glsl, and the textures of lobe.glsl.
layout(binding = 5) uniform sampler2D pyramidTexture;

uniform ivec2 levelOffset[GI_PYRAMID_LEVELS + 1];
uniform int maximumSteps;
uniform float reach;     // maximum length of a ray, world units
uniform float thickness; // world units
uniform float edgeFade;  // width of the fade at the borders, as a share of the picture's smaller side

// Cosine to the ray below which a surface is trusted less, as the eye sees little of it.
const float GRAZING = 0.1;

struct MarchResult
{
  int end;
  vec3 position;    // view coordinates
  vec2 window;      // pixels of the viewport
  float confidence;
};

vec3 toWindow(vec3 position)
{
  vec4 clip = view.ViewToClip * vec4(position, 1.0);
  vec3 ndc = clip.xyz / clip.w * 0.5 + 0.5;
  return vec3(ndc.xy * view.Viewport.zw, ndc.z);
}

// Size of a pixel in world units at view depth z.
float pixelSize(float z)
{
  return 2.0 * (view.Scene.y > 0.5 ? 1.0 : -z) / (view.Viewport.w * view.ViewToClip[1].y);
}

// Assumed ratio of an occluder's depth to its width. Spheres have 0.5, thin objects less.
const float BULGE = 0.4;

// Whether a ray hits the back of an occluder that hides a stretch of it. The back is assumed to be half an
// ellipse over that stretch. The ray begins at a gap behind the ellipse's middle and falls by m over the
// half-width. It clears an ellipse of half-depth b if the gap is more than sqrt(b^2 + m^2) - m.
bool hitsBack(float gap, float falls, float wide)
{
  float b = BULGE * wide;
  float m = 0.5 * max(falls, 0.0);
  return gap < sqrt(b * b + m * m) - m;
}

vec2 reciprocal(vec2 v)
{
  vec2 size = max(abs(v), vec2(1e-6));
  return vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0) / size;
}

float confidenceAt(vec2 window, float facing)
{
  vec2 inside = min(window, view.Viewport.zw - window) / min(view.Viewport.z, view.Viewport.w);
  float edge = edgeFade > 0.0 ? smoothstep(0.0, edgeFade, min(inside.x, inside.y)) : 1.0;
  return edge * smoothstep(0.0, GRAZING, facing);
}

// Whether the ray hits the surface that is visible at a pixel. It must approach its front and cross it
// within the pixel and within the surface's depth range. If the ray was in front of the previous pixel's surface and is
// behind this one, by no more than the thickness, it hit the surface between the two. surface: depth range of the
// surface; from: depth of the ray where it enters the pixel; before: whether the ray has been in front of the surfaces
// so far; updated.
bool hitsSurface(vec3 O, vec3 D, vec2 direction2D, ivec2 cell, vec2 surface, float from, inout bool before,
  inout MarchResult result)
{
  ivec2 pixel = cell + ivec2(view.Viewport.xy);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    return false; // props that are not captured have no normal
  }
  vec2 center = vec2(cell) + 0.5;
  vec3 surfacePosition = giViewPosition(vec2(pixel) + 0.5, surface.x);
  vec3 normal = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  float facing = -dot(normal, D);
  float t = dot(normal, O - surfacePosition) / (abs(facing) > 1e-6 ? facing : 1e-6);
  vec3 crossing = O + t * D;
  vec3 crossingWindow = toWindow(crossing);
  vec2 offset = crossingWindow.xy - center;
  float distanceToCenter = t > 0.0 && crossingWindow.z <= surface.y ? max(abs(offset.x), abs(offset.y)) : 1e30;
  if (facing <= 0.0)
  {
    result.end = distanceToCenter <= 0.5 ? GI_REFLECTION_BACK : result.end;
    return false;
  }
  // Tolerance of half a pixel beyond the pixel's own half, as the planes of neighbours do not join exactly, and of
  // another half if the ray passed in front of the previous pixel, whose depth was taken from its centre.
  float margin = before ? 1.5 : 1.0;
  bool crosses = distanceToCenter <= margin;
  bool later = t > 0.0 && dot(offset, direction2D) > 0.0;
  if (!crosses)
  {
    bool edge = before && !later && giViewDepth(surface.x) - giViewDepth(from) <= thickness;
    before = before && later;
    if (!edge)
    {
      return false;
    }
    crossing = surfacePosition;
    crossingWindow.xy = center;
  }
  // The crossing may lie in the next pixel, which may be background.
  ivec2 crossed = clamp(ivec2(floor(crossingWindow.xy)), ivec2(0), ivec2(view.Viewport.zw) - 1);
  bool shown = texelFetch(albedoTexture, crossed + ivec2(view.Viewport.xy), 0).a > 0.0;
  crossingWindow.xy = shown ? crossingWindow.xy : center;
  result.end = GI_REFLECTION_HIT;
  result.position = crossing;
  result.window = crossingWindow.xy;
  result.confidence = confidenceAt(crossingWindow.xy, facing);
  return true;
}

// Marches from the surface O of a pixel of the viewport, at this depth, along the unit vector D.
MarchResult march(ivec2 start, float depth, vec3 O, vec3 D, vec3 V)
{
  MarchResult result = MarchResult(GI_REFLECTION_EMPTY, O + reach * D, vec2(-1.0), 0.0);
  float nearest = giViewDepth(0.0);
  float range = D.z > 0.0 ? min(reach, 0.999 * (nearest - O.z) / D.z) : reach;
  vec3 from = vec3(vec2(start) + 0.5, depth);
  vec3 along = toWindow(O + range * D) - from;
  ivec2 ahead = ivec2(greaterThan(along.xy, vec2(0.0)));
  vec2 leave = (vec2(ahead) * view.Viewport.zw - from.xy) * reciprocal(along.xy);
  float end = min(min(leave.x, leave.y), 1.0);
  bool leaves = end < 1.0;
  end = along.z > 0.0 ? min(end, (1.0 - depth) / along.z) : end; // stop at the far plane
  along *= end;
  float pixels = max(abs(along.x), abs(along.y));
  vec2 perPixel = reciprocal(along.xy);
  vec2 first = (vec2(start + ahead) - from.xy) * perPixel;
  float u = min(first.x, first.y);
  // Cells are looked up slightly ahead on both axes. Exactly at the boundary, rounding could return the
  // previous cell.
  const float AHEAD = 2e-3;
  vec2 nudged = from.xy + AHEAD * vec2(ahead * 2 - 1);
  float stop = 1.0 - 2.0 * AHEAD / max(pixels, 1.0);
  ivec2 last = ivec2(view.Viewport.zw) - 1;
  int level = 0;
  float extent = length(along.xy);
  bool hidden = pixels < 1.0 && D.z <= 0.0;
  bool blocked = false;
  bool before = true;
  float since = -1.0; // parameter at which the ray went behind its current occluder
  vec2 entry = vec2(0.0); // view depths of the ray and of the occluder at that point
  int i = 0;
  for (; i < maximumSteps && u < stop && pixels >= 1.0; ++i)
  {
    ivec2 cell = clamp(ivec2(nudged + u * along.xy), ivec2(0), last) >> level;
    vec2 bounds = (vec2((cell + ahead) << level) - from.xy) * perPixel;
    float next = min(min(bounds.x, bounds.y), 1.0);
    vec2 ray = from.z + vec2(u, next) * along.z;
    vec2 surface = texelFetch(pyramidTexture, levelOffset[level] + cell, 0).rg;
    bool clear = max(ray.x, ray.y) < surface.x;
    bool behind = !clear && min(ray.x, ray.y) > surface.y;
    if (!clear && !behind && level > 0)
    {
      --level;
      continue;
    }
    float z = giViewDepth(ray.x);
    if (behind && since < 0.0)
    {
      since = u;
      entry = vec2(z, giViewDepth(surface.y));
    }
    else if (!behind && since >= 0.0)
    {
      blocked =
        hitsBack(entry.y - entry.x, entry.x - z, (u - since) * extent * pixelSize(entry.y));
      since = -1.0;
      if (blocked)
      {
        break;
      }
    }
    if (!clear && !behind && hitsSurface(O, D, along.xy, cell, surface, ray.x, before, result))
    {
      return result;
    }
    hidden = hidden || behind;
    before = clear || (before && !behind);
    u = next;
    // Go up a level where the next cell has a different parent.
    bool over = bounds.x < bounds.y ? (cell.x & 1) == ahead.x : (cell.y & 1) == ahead.y;
    level += over && (clear || behind) && level < GI_PYRAMID_LEVELS ? 1 : 0;
  }
  bool back = result.end == GI_REFLECTION_BACK;
  result.end = i == maximumSteps ? GI_REFLECTION_STEPS
    : blocked ? GI_REFLECTION_HIDDEN : back ? GI_REFLECTION_BACK
    : hidden ? GI_REFLECTION_HIDDEN : dot(D, V) > 0.0 ? GI_REFLECTION_FACING
    : leaves ? GI_REFLECTION_LEFT : GI_REFLECTION_EMPTY;
  return result;
}
