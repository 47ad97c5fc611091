// A ray through the depth buffer. In window coordinates a straight line stays straight, and its depth
// grows evenly along it, in perspective too; so it is walked from cell to cell of the depth pyramid:
// over large cells where it is clear of all that is in them, down to pixels where it may meet something
// (McGuire and Mara 2014, "Efficient GPU Screen-Space Ray Tracing"; Uludag 2014, "Hi-Z Screen-Space
// Cone-Traced Reflections"). Needs shared/view.h, shared/reflection.h, lib/octahedral.glsl,
// lib/reconstruct.glsl, and the textures of lobe.glsl.
layout(binding = 5) uniform sampler2D pyramidTexture;

uniform ivec2 levelOffset[GI_PYRAMID_LEVELS + 1];
uniform int maximumSteps;
uniform float reach;     // world units: no ray finds anything farther
uniform float thickness; // world units
uniform float edgeFade;  // of the picture's smaller side

// Surfaces seen by a ray more edge-on than this are trusted less: the eye sees little of them.
const float GRAZING = 0.1;

struct Found
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

// World units.
float pixelSize(float z)
{
  return 2.0 * (view.Scene.y > 0.5 ? 1.0 : -z) / (view.Viewport.w * view.ViewToClip[1].y);
}

// Depth of an unseen back over the width of what hides it. Balls have 0.5, thin things less.
const float BULGE = 0.4;

// Whether a ray meets the unseen side of what hides a stretch of it, which is taken to be half an
// ellipse over that stretch. Its line begins by a gap behind the ellipse's middle and falls m over the
// half-width a; it clears an ellipse of half-depth b if the gap is more than sqrt(b^2 + m^2) - m.
bool meetsBack(float gap, float falls, float wide)
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

float trust(vec2 window, float facing)
{
  vec2 inside = min(window, view.Viewport.zw - window) / min(view.Viewport.z, view.Viewport.w);
  float edge = edgeFade > 0.0 ? smoothstep(0.0, edgeFade, min(inside.x, inside.y)) : 1.0;
  return edge * smoothstep(0.0, GRAZING, facing);
}

// Whether the ray meets the surface that is seen at a pixel: it must come to its front, and cross it
// there, no deeper than the surface reaches. Where the ray was before the last pixel's surface and is
// behind this one's, by no more than the thickness, it met what is between them. surface: where that
// begins and ends; from: the ray's depth where it comes to the pixel; before: whether it was before the
// surface so far, and then whether it still is.
bool meets(vec3 O, vec3 D, vec2 way, ivec2 cell, vec2 surface, float from, inout bool before, inout Found found)
{
  ivec2 pixel = cell + ivec2(view.Viewport.xy);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    return false; // what was not captured has no normal to go by
  }
  vec2 center = vec2(cell) + 0.5;
  vec3 there = giViewPosition(vec2(pixel) + 0.5, surface.x);
  vec3 normal = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  float facing = -dot(normal, D);
  float t = dot(normal, O - there) / (abs(facing) > 1e-6 ? facing : 1e-6);
  vec3 crossing = O + t * D;
  vec3 place = toWindow(crossing);
  vec2 off = place.xy - center;
  float apart = t > 0.0 && place.z <= surface.y ? max(abs(off.x), abs(off.y)) : 1e30;
  if (facing <= 0.0)
  {
    found.end = apart <= 0.5 ? GI_REFLECTION_BACK : found.end;
    return false;
  }
  // Half a pixel more than its own: neighbours' planes do not join exactly. One more where the last
  // pixel's surface was taken to be as deep all over as in its middle.
  float margin = before ? 1.5 : 1.0;
  bool crosses = apart <= margin;
  bool later = t > 0.0 && dot(off, way) > 0.0;
  if (!crosses)
  {
    bool edge = before && !later && giViewDepth(surface.x) - giViewDepth(from) <= thickness;
    before = before && later;
    if (!edge)
    {
      return false;
    }
    crossing = there;
    place.xy = center;
  }
  found.end = GI_REFLECTION_HIT;
  found.position = crossing;
  found.window = place.xy;
  found.confidence = trust(place.xy, facing);
  return true;
}

// From the surface of a pixel of the viewport, at this depth, along a unit vector.
Found march(ivec2 start, float depth, vec3 O, vec3 D, vec3 V)
{
  Found found = Found(GI_REFLECTION_EMPTY, O + reach * D, vec2(-1.0), 0.0);
  float nearest = giViewDepth(0.0);
  float range = D.z > 0.0 ? min(reach, 0.999 * (nearest - O.z) / D.z) : reach;
  vec3 from = vec3(vec2(start) + 0.5, depth);
  vec3 along = toWindow(O + range * D) - from;
  ivec2 ahead = ivec2(greaterThan(along.xy, vec2(0.0)));
  vec2 leave = (vec2(ahead) * view.Viewport.zw - from.xy) * reciprocal(along.xy);
  float end = min(min(leave.x, leave.y), 1.0);
  bool leaves = end < 1.0;
  end = along.z > 0.0 ? min(end, (1.0 - depth) / along.z) : end; // nothing is drawn beyond
  along *= end;
  float pixels = max(abs(along.x), abs(along.y));
  vec2 perPixel = reciprocal(along.xy);
  vec2 first = (vec2(start + ahead) - from.xy) * perPixel;
  float u = min(first.x, first.y);
  // A cell is looked up a little ahead on both axes: where the ray comes to it, rounding could find the
  // one before.
  const float AHEAD = 2e-3;
  vec2 nudged = from.xy + AHEAD * vec2(ahead * 2 - 1);
  float stop = 1.0 - 2.0 * AHEAD / max(pixels, 1.0);
  ivec2 last = ivec2(view.Viewport.zw) - 1;
  int level = 0;
  float extent = length(along.xy);
  bool hidden = pixels < 1.0 && D.z <= 0.0;
  bool blocked = false;
  bool before = true;
  float since = -1.0; // where the ray went behind what hides it now
  vec2 entry = vec2(0.0); // view depths of the ray and of what hides it, there
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
        meetsBack(entry.y - entry.x, entry.x - z, (u - since) * extent * pixelSize(entry.y));
      since = -1.0;
      if (blocked)
      {
        break;
      }
    }
    if (!clear && !behind && meets(O, D, along.xy, cell, surface, ray.x, before, found))
    {
      return found;
    }
    hidden = hidden || behind;
    before = clear || (before && !behind);
    u = next;
    // Up where the next cell is another one of the level above.
    bool over = bounds.x < bounds.y ? (cell.x & 1) == ahead.x : (cell.y & 1) == ahead.y;
    level += over && (clear || behind) && level < GI_PYRAMID_LEVELS ? 1 : 0;
  }
  bool back = found.end == GI_REFLECTION_BACK;
  found.end = i == maximumSteps ? GI_REFLECTION_STEPS
    : blocked ? GI_REFLECTION_HIDDEN : back ? GI_REFLECTION_BACK
    : hidden ? GI_REFLECTION_HIDDEN : dot(D, V) > 0.0 ? GI_REFLECTION_FACING
    : leaves ? GI_REFLECTION_LEFT : GI_REFLECTION_EMPTY;
  return found;
}
