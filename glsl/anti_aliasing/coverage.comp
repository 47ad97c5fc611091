#version 430 core
// Coverage of edge pixels: traces a ray through each sample of a pixel, and finds a neighbouring pixel that shows the surface or
// the background that the ray hits. Variants: GI_RAY_EDGES (some surfaces show the edges of their cells), and those of
// rays/passage.glsl.
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
#include "anti_aliasing/coverage.glsl"

const int SIDE = 8; // of a group of pixels
const int PIXELS = SIDE * SIDE;
layout(local_size_x = 8, local_size_y = 8) in;

// Few pixels are at edges. A group lists them, and traces all their samples side by side.
shared int edges;          // number of listed pixels
shared int places[PIXELS]; // of these pixels in the group
shared uint sources[PIXELS * COVERAGE_SAMPLES];

layout(r32ui, binding = 0) uniform writeonly uimage2D coverage;

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;

uniform mat3 viewToScene;
uniform vec3 eye; // relative to the scene's origin
uniform vec2 jitter; // of the frame, in pixels
uniform vec2 turn;   // offset of the samples within the pixel, modulo 1; varies from frame to frame

// Rotated grid.
const vec2 SAMPLE_PLACES[COVERAGE_SAMPLES] =
  vec2[](vec2(0.125, 0.375), vec2(0.375, 0.875), vec2(0.625, 0.125), vec2(0.875, 0.625));

const float MINIMUM_SIMILARITY = 0.2; // of neighbours on the same surface
const float MAXIMUM_CONTRAST = 0.05;  // between colours of neighbours without an edge
// Mismatch between a hit and a pixel, in pixels of distance from the pixel's plane.
const float GOOD_MATCH = 0.5;       // the pixel itself is accepted below this mismatch
const float MAXIMUM_MISMATCH = 4.0; // no pixel is accepted above it
const float NORMAL_WEIGHT = 8.0;    // mismatch of perpendicular normals
const float COLOR_WEIGHT = 4.0;     // mismatch of black and white
const float DISTANCE_WEIGHT = 0.25; // mismatch per pixel of distance in the picture

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

struct Neighbourhood
{
  bool edge;    // a neighbour differs in surface or colour
  bool unknown; // it contains surfaces that rays do not see
};

Neighbourhood neighbourhoodOf(ivec2 pixel)
{
  bool captured = isCaptured(pixel);
  GiSurfel here;
  if (captured)
  {
    here = giSurfel(vec2(pixel) + 0.5, texelFetch(depthTexture, pixel, 0).r, texelFetch(normalTexture, pixel, 0).xy, 1.0);
  }
  Neighbourhood found = Neighbourhood(false, false);
  for (int i = 0; i < 9; ++i)
  {
    ivec2 other = within(pixel + ivec2(i % 3, i / 3) - 1);
    bool covered = isCaptured(other);
    bool alike = covered == captured;
    if (captured && alike)
    {
      float similarity = giSimilarity(here, vec2(other - pixel), texelFetch(depthTexture, other, 0).r,
        texelFetch(normalTexture, other, 0).xy);
      alike = similarity > MINIMUM_SIMILARITY && contrast(colorAt(pixel), colorAt(other)) < MAXIMUM_CONTRAST;
    }
    found.edge = found.edge || !alike;
    found.unknown = found.unknown || (covered && !isTraced(other));
  }
  return found;
}

// Mismatch between a pixel's surface and a hit. point: place of the ray in the picture.
float mismatch(ivec2 pixel, vec2 point, vec3 position, vec3 normal, vec3 color)
{
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec2 center = vec2(pixel) + 0.5;
  float depth = texelFetch(depthTexture, pixel, 0).r;
  vec3 P = giViewPosition(center, depth);
  float width = length(giViewPosition(center + vec2(1.0, 0.0), depth) - P);
  return abs(dot(N, position - P)) / width + NORMAL_WEIGHT * (1.0 - dot(N, normal)) +
    COLOR_WEIGHT * contrast(color, colorAt(pixel)) + DISTANCE_WEIGHT * length(point - center);
}

// Neighbour from which a sample takes its colour.
uint sourceAt(ivec2 pixel, int number)
{
  uint state = giHash(giHash(uint(pixel.x) + (uint(pixel.y) << 16)) + uint(number));
  mat3 sceneToView = transpose(viewToScene);
  vec2 point = vec2(pixel) + fract(SAMPLE_PLACES[number] + turn) + jitter;
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
  uint source = COVERAGE_OWN;
  bool alike = isCaptured(pixel) == met;
  float least = alike && !met ? 0.0 : MAXIMUM_MISMATCH;
  if (alike && met)
  {
    least = min(mismatch(pixel, point, position, normal, at.color.rgb), MAXIMUM_MISMATCH);
  }
  for (int j = 0; j < 9 && least > GOOD_MATCH; ++j)
  {
    ivec2 offset = ivec2(j % 3, j / 3) - 1;
    ivec2 other = within(pixel + offset);
    bool suits = isCaptured(other) == met && (!met || isTraced(other));
    float candidate = !suits ? RAY_FAR
      : met ? mismatch(other, point, position, normal, at.color.rgb) : length(point - vec2(other) - 0.5);
    source = candidate < least ? sourceOf(other - pixel) : source;
    least = min(least, candidate);
  }
  return source;
}

ivec2 pixelAt(int place)
{
  return low + ivec2(gl_WorkGroupID.xy) * SIDE + ivec2(place % SIDE, place / SIDE);
}

void main()
{
  low = ivec2(view.Viewport.xy);
  high = low + ivec2(view.Viewport.zw) - 1;
  int own = int(gl_LocalInvocationIndex);
  if (own == 0)
  {
    edges = 0;
  }
  barrier();
  ivec2 pixel = pixelAt(own);
  if (all(lessThanEqual(pixel, high)))
  {
    Neighbourhood near = neighbourhoodOf(pixel);
    if (near.edge && !near.unknown)
    {
      places[atomicAdd(edges, 1)] = own;
    }
    else
    {
      imageStore(coverage, pixel, uvec4(near.unknown ? COVERAGE_UNKNOWN : COVERAGE_OWN_ONLY));
    }
  }
  barrier();
  for (int i = own; i < edges * COVERAGE_SAMPLES; i += PIXELS)
  {
    sources[i] = sourceAt(pixelAt(places[i / COVERAGE_SAMPLES]), i % COVERAGE_SAMPLES);
  }
  barrier();
  if (own < edges)
  {
    pixel = pixelAt(places[own]);
    uint found = COVERAGE_OWN_ONLY;
    for (int i = 0; i < COVERAGE_SAMPLES; ++i)
    {
      found = bitfieldInsert(found, sources[own * COVERAGE_SAMPLES + i], i * int(COVERAGE_BITS), int(COVERAGE_BITS));
    }
    imageStore(coverage, pixel, uvec4(found));
  }
}
