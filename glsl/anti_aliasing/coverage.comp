#version 430 core
// Coverage of edge pixels: traces a ray through each sample of a pixel, and finds a neighbouring pixel that shows the surface or
// the background that the ray hits. Variants: GI_RAY_EDGES (some surfaces show the edges of their cells), GI_DIRECT_VISIBILITY,
// GI_IRRADIANCE (indirect light is known), GI_POSITIONAL (some positional lights), and those of rays/passage.glsl.
#define GI_RAY_OPAQUE 1
#include "shared/view.h"
#include "shared/light.h"
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/sampling.glsl"
#include "lib/alike.glsl"
#include "lib/lights.glsl"
#include "lib/luminance.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#ifdef GI_RAY_EDGES
#include "path_tracing/edges.glsl"
#endif
#include "anti_aliasing/coverage.glsl"

const int SIDE = 8; // of a group of pixels
const int PIXELS = SIDE * SIDE;
layout(local_size_x = 8, local_size_y = 8) in;

// The surfaces of a group's pixels and of those around them.
const int TILE = SIDE + 2;
shared float tileDepths[TILE * TILE]; // in the window
shared uint tileNormals[TILE * TILE]; // octahedral
shared uint tileColors[TILE * TILE];  // a: one of the following
const float BACKGROUND = 0.0;
const float UNTRACED = 1.0 / 255.0; // rays do not see the surface
const float TRACED = 1.0;

// Few pixels are at edges. A group lists them, and traces all their samples side by side.
shared int edges;          // number of listed pixels
shared int places[PIXELS]; // of these pixels in the group
shared uint samples[PIXELS * COVERAGE_SAMPLES];

layout(rg32ui, binding = 0) uniform writeonly uimage2D coverage;

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;
layout(binding = 3) uniform sampler2DArray directVisibility;
layout(binding = 4) uniform sampler2D irradianceTexture;
#include "lib/direct_visibility.glsl"

uniform int lightCount;
uniform mat3 viewToScene;
uniform vec3 eye; // relative to the scene's origin
uniform vec2 jitter; // of the frame, in pixels
uniform vec2 turn;   // offset of the samples within the pixel, modulo 1; varies from frame to frame

// Rotated grid.
const vec2 SAMPLE_PLACES[COVERAGE_SAMPLES] =
  vec2[](vec2(0.125, 0.375), vec2(0.375, 0.875), vec2(0.625, 0.125), vec2(0.875, 0.625));

const float MINIMUM_SIMILARITY = 0.6; // of neighbours on the same surface
const float MAXIMUM_CONTRAST = 0.02;  // between colours of neighbours without an edge
// Mismatch between a hit and a pixel, in pixels of distance from the pixel's plane.
const float GOOD_MATCH = 0.5;       // the pixel itself is accepted below this mismatch
const float MAXIMUM_MISMATCH = 4.0; // no pixel is accepted above it
const float NORMAL_WEIGHT = 4.0;    // mismatch of perpendicular normals
const float COLOR_WEIGHT = 4.0;     // mismatch of black and white
const float DISTANCE_WEIGHT = 0.25; // mismatch per pixel of distance in the picture

const float PI = 3.14159265;

ivec2 low, high;

ivec2 within(ivec2 pixel)
{
  return clamp(pixel, low, high);
}

ivec2 pixelAt(int place)
{
  return low + ivec2(gl_WorkGroupID.xy) * SIDE + ivec2(place % SIDE, place / SIDE);
}

// Index of a pixel's surface in the tile. The pixel is in the group or beside it.
int tileIndex(ivec2 pixel)
{
  ivec2 place = pixel - low - ivec2(gl_WorkGroupID.xy) * SIDE + 1;
  return place.y * TILE + place.x;
}

int materialAt(ivec2 pixel)
{
  return int(texelFetch(normalTexture, pixel, 0).z * 65535.0 + 0.5);
}

bool isPBR(ivec2 pixel)
{
  return materials[materialAt(pixel)].Model.x == GI_MATERIAL_PBR;
}

void loadTile(int index)
{
  ivec2 pixel = within(low + ivec2(gl_WorkGroupID.xy) * SIDE + ivec2(index % TILE, index / TILE) - 1);
  vec4 albedo = texelFetch(albedoTexture, pixel, 0);
  int material = materialAt(pixel);
  bool traced = material != GI_MATERIAL_AS_DRAWN && (materials[material].Model.y & GI_MATERIAL_THIN) == 0;
  tileDepths[index] = texelFetch(depthTexture, pixel, 0).r;
  tileNormals[index] = packSnorm2x16(texelFetch(normalTexture, pixel, 0).xy);
  tileColors[index] = packUnorm4x8(vec4(albedo.rgb, albedo.a == 0.0 ? BACKGROUND : traced ? TRACED : UNTRACED));
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
  int own = tileIndex(pixel);
  vec4 color = unpackUnorm4x8(tileColors[own]);
  bool captured = color.a != BACKGROUND;
  GiSurfel here = giSurfel(vec2(pixel) + 0.5, tileDepths[own], unpackSnorm2x16(tileNormals[own]), 1.0);
  Neighbourhood found = Neighbourhood(false, color.a == UNTRACED);
  for (int i = 0; i < 9; ++i)
  {
    ivec2 offset = ivec2(i % 3, i / 3) - 1;
    int other = own + offset.y * TILE + offset.x;
    vec4 there = unpackUnorm4x8(tileColors[other]);
    float similarity = giSimilarity(here, vec2(offset), tileDepths[other], unpackSnorm2x16(tileNormals[other]));
    bool alike = (there.a != BACKGROUND) == captured &&
      (!captured || (similarity > MINIMUM_SIMILARITY && contrast(color.rgb, there.rgb) < MAXIMUM_CONTRAST));
    found.edge = found.edge || !alike;
    found.unknown = found.unknown || there.a == UNTRACED;
  }
  return found;
}

// Mismatch between the surface of a pixel and a hit. point: place of the ray in the picture.
float mismatch(ivec2 pixel, vec2 point, vec3 position, vec3 normal, vec3 color)
{
  int index = tileIndex(pixel);
  vec3 N = giDecodeOctahedral(unpackSnorm2x16(tileNormals[index]));
  vec2 center = vec2(pixel) + 0.5;
  vec2 ndc = (center - view.Viewport.xy) / view.Viewport.zw * 2.0 - 1.0;
  vec4 P = view.ClipToView * vec4(ndc, tileDepths[index] * 2.0 - 1.0, 1.0);
  float width = length(view.ClipToView[0].xyz) * 2.0 / view.Viewport.z; // of a pixel, times P.w
  return abs(dot(N, position * P.w - P.xyz)) / width + NORMAL_WEIGHT * (1.0 - dot(N, normal)) +
    COLOR_WEIGHT * contrast(color, unpackUnorm4x8(tileColors[index]).rgb) + DISTANCE_WEIGHT * length(point - center);
}

// Diffuse radiance of a hit, as a multiple of what it would be with the normal of a pixel's surface. Of shadows and of indirect light
// only those of the pixel are known.
float gainAt(ivec2 pixel, RaySurfacePoint at, vec3 position, vec3 normal)
{
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec3 here = vec3(0.0);
  vec3 there = vec3(0.0);
  for (int i = 0; i < lightCount; ++i)
  {
    LightData light = lights[i];
    GiIncident incident = giIncident(light, position);
    vec3 strength = incident.Attenuation * giDirectVisibility(pixel, light.Kind.y) * light.Color.rgb;
    here += max(dot(N, -incident.Travel), 0.0) * strength;
    there += max(dot(normal, -incident.Travel), 0.0) * strength;
  }
  float share = isPBR(pixel) ? 1.0 / PI : 1.0;
  vec3 indirect = vec3(0.0);
#ifdef GI_IRRADIANCE
  indirect = texelFetch(irradianceTexture, pixel, 0).rgb;
#endif
  float before = giLuminance(at.color.rgb * (share * here + indirect) + at.emission);
  float after = giLuminance(at.color.rgb * (share * there + indirect) + at.emission);
  return before > 0.0 ? after / before : 1.0;
}

// A sample, see coverageSample().
uint sampleAt(ivec2 pixel, int number)
{
  uint state = giHash(giHash(uint(pixel.x) + (uint(pixel.y) << 16)) + uint(number));
  mat3 sceneToView = transpose(viewToScene);
  vec2 place = fract(SAMPLE_PLACES[number] + turn) + jitter;
  vec2 point = vec2(pixel) + place;
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
  int source = int(COVERAGE_OWN);
  float least = MAXIMUM_MISMATCH;
  // The pixel itself is the first.
  for (int j = 0; j < 9 && least > GOOD_MATCH; ++j)
  {
    int candidate = j == 0 ? int(COVERAGE_OWN) : j <= int(COVERAGE_OWN) ? j - 1 : j;
    ivec2 offset = ivec2(candidate % 3, candidate / 3) - 1;
    bool background = unpackUnorm4x8(tileColors[tileIndex(pixel + offset)]).a == BACKGROUND;
    float found = background == met ? RAY_FAR
      : met ? mismatch(pixel + offset, point, position, normal, at.color.rgb)
            : candidate == int(COVERAGE_OWN) ? 0.0 : length(place - vec2(offset) - 0.5);
    source = found < least ? candidate : source;
    least = min(least, found);
  }
  ivec2 taken = within(pixel + ivec2(source % 3, source / 3) - 1);
  float gain = 1.0;
  if (met && least < MAXIMUM_MISMATCH)
  {
    gain = gainAt(taken, at, position, normal);
  }
  return coverageSample(sourceOf(taken - pixel), gain, met && isPBR(taken));
}

void main()
{
  low = ivec2(view.Viewport.xy);
  high = low + ivec2(view.Viewport.zw) - 1;
  int own = int(gl_LocalInvocationIndex);
  for (int i = own; i < TILE * TILE; i += PIXELS)
  {
    loadTile(i);
  }
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
      imageStore(coverage, pixel, uvec4(near.unknown ? COVERAGE_UNKNOWN : COVERAGE_OWN_ONLY, COVERAGE_NO_GAIN, 0u, 0u));
    }
  }
  barrier();
  for (int i = own; i < edges * COVERAGE_SAMPLES; i += PIXELS)
  {
    samples[i] = sampleAt(pixelAt(places[i / COVERAGE_SAMPLES]), i % COVERAGE_SAMPLES);
  }
  barrier();
  if (own < edges)
  {
    uvec2 found = uvec2(COVERAGE_OWN_ONLY, COVERAGE_NO_GAIN);
    for (int i = 0; i < COVERAGE_SAMPLES; ++i)
    {
      setSample(found, i, samples[own * COVERAGE_SAMPLES + i]);
    }
    imageStore(coverage, pixelAt(places[own]), uvec4(found, 0u, 0u));
  }
}
