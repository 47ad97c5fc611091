#version 430 core
// Finds out what covers the pixels at edges: a ray through each of some points of the pixel meets a surface or nothing, and
// the point takes the colour of a pixel nearby that shows the same. Variants: GI_RAY_EDGES (some surfaces show the edges of
// their cells), and those of rays/passage.glsl.
#define GI_RAY_OPAQUE 1
#include "shared/view.h"
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/sampling.glsl"
#include "lib/alike.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#ifdef GI_RAY_EDGES
#include "path_tracing/edges.glsl"
#endif
#include "anti_aliasing/picks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r32ui, binding = 0) uniform writeonly uimage2D picks;

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;

uniform mat3 viewToScene;
uniform vec3 eye; // relative to the scene's origin
uniform vec2 jitter; // of the frame, in pixels
uniform vec2 turn;   // by which the points are shifted within the pixel, from frame to frame

// A rotated grid.
const vec2 PICK_PLACES[PICK_POINTS] =
  vec2[](vec2(0.125, 0.375), vec2(0.375, 0.875), vec2(0.625, 0.125), vec2(0.875, 0.625));

const float ALIKE = 0.5;      // least similarity of neighbours between which there is no edge
const float CONTRAST = 0.05;  // most difference of their colours
const float SAME = 1.5;       // unlikeness of a point and its own pixel from which others may suit better, in pixels off the plane
const float MOST = 4.0;       // unlikeness from which no pixel suits
const float BEND = 4.0;       // that of normals at a right angle
const float COLORED = 4.0;    // that of black and white
const float FARTHER = 0.25;   // that of a pixel one pixel farther away

ivec2 low, high;

ivec2 within(ivec2 pixel)
{
  return clamp(pixel, low, high);
}

bool isCaptured(ivec2 pixel)
{
  return texelFetch(albedoTexture, pixel, 0).a > 0.0;
}

// Whether rays see the surface of a captured pixel.
bool isTraced(ivec2 pixel)
{
  int material = int(texelFetch(normalTexture, pixel, 0).z * 65535.0 + 0.5);
  return material != GI_MATERIAL_AS_DRAWN && (materials[material].Model.y & GI_MATERIAL_THIN) == 0;
}

vec3 colorAt(ivec2 pixel)
{
  return texelFetch(albedoTexture, pixel, 0).rgb;
}

float contrast(vec3 one, vec3 other)
{
  vec3 apart = abs(one - other);
  return max(max(apart.r, apart.g), apart.b);
}

// What is around a pixel.
struct Around
{
  bool edge;    // whether it differs from the pixel
  bool unknown; // whether rays do not see all of it
};

Around around(ivec2 pixel)
{
  bool captured = isCaptured(pixel);
  GiSurfel here;
  if (captured)
  {
    here = giSurfel(vec2(pixel) + 0.5, texelFetch(depthTexture, pixel, 0).r, texelFetch(normalTexture, pixel, 0).xy, 1.0);
  }
  Around found = Around(false, false);
  for (int i = 0; i < 9; ++i)
  {
    ivec2 other = within(pixel + ivec2(i % 3, i / 3) - 1);
    bool covered = isCaptured(other);
    bool alike = covered == captured;
    if (captured && alike)
    {
      float similarity = giSimilarity(here, vec2(other - pixel), texelFetch(depthTexture, other, 0).r,
        texelFetch(normalTexture, other, 0).xy);
      alike = similarity > ALIKE && contrast(colorAt(pixel), colorAt(other)) < CONTRAST;
    }
    found.edge = found.edge || !alike;
    found.unknown = found.unknown || (covered && !isTraced(other));
  }
  return found;
}

// How little a pixel's colour suits a point where a ray has met a surface.
float unlikeness(ivec2 pixel, vec2 point, vec3 position, vec3 normal, vec3 color)
{
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec2 center = vec2(pixel) + 0.5;
  float depth = texelFetch(depthTexture, pixel, 0).r;
  vec3 P = giViewPosition(center, depth);
  float width = length(giViewPosition(center + vec2(1.0, 0.0), depth) - P);
  return abs(dot(N, position - P)) / width + BEND * (1.0 - dot(N, normal)) +
    COLORED * contrast(color, colorAt(pixel)) + FARTHER * length(point - center);
}

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(view.Viewport.xy);
  low = ivec2(view.Viewport.xy);
  high = low + ivec2(view.Viewport.zw) - 1;
  if (any(greaterThan(pixel, high)))
  {
    return;
  }
  bool captured = isCaptured(pixel);
  Around near = around(pixel);
  if (near.unknown || !near.edge)
  {
    imageStore(picks, pixel, uvec4(near.unknown ? PICK_UNKNOWN : PICK_ALL_OWN));
    return;
  }
  uint state = giHash(uint(pixel.x) + (uint(pixel.y) << 16));
  mat3 sceneToView = transpose(viewToScene);
  uint found = PICK_ALL_OWN;
  for (int i = 0; i < PICK_POINTS; ++i)
  {
    vec2 point = vec2(pixel) + fract(PICK_PLACES[i] + turn) + jitter;
    vec3 start = giViewPosition(point, 0.0);
    vec3 path = giViewPosition(point, 1.0) - start;
    Ray ray = Ray(eye + viewToScene * start, 0.0, viewToScene * normalize(path), length(path));
    RaySurfacePoint at;
    float first;
    RayHit hit = traceThrough(ray, at, first, state);
    bool met = hit.instance >= 0;
#ifdef GI_RAY_EDGES
    if (met)
    {
      at = withEdges(at, hit, sceneToView, eye, point);
    }
#endif
    vec3 position = sceneToView * (at.position - eye);
    vec3 normal = sceneToView * at.normal;
    uint pick = PICK_OWN;
    float least = captured == met ? (met ? unlikeness(pixel, point, position, normal, at.color.rgb) : 0.0) : MOST;
    least = min(least, MOST);
    for (int j = 0; j < 9 && least > SAME; ++j)
    {
      ivec2 offset = ivec2(j % 3, j / 3) - 1;
      ivec2 other = within(pixel + offset);
      bool suits = isCaptured(other) == met && (!met || isTraced(other));
      float unlike = !suits ? RAY_FAR
        : met ? unlikeness(other, point, position, normal, at.color.rgb) : length(point - vec2(other) - 0.5);
      pick = unlike < least ? pickOf(other - pixel) : pick;
      least = min(least, unlike);
    }
    found = bitfieldInsert(found, pick, i * int(PICK_BITS), int(PICK_BITS));
  }
  imageStore(picks, pixel, uvec4(found));
}
