#version 430 core
// Visibility of each light at a pixel, by rays to points of the light. Variants: those of
// rays/passage.glsl.
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/lights.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba8, binding = 0) uniform writeonly image2DArray visibility; // four lights per layer
layout(rgba16f, binding = 1) uniform writeonly image2DArray reach; // of the filter, in scene units

layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D depthTexture;

uniform vec3 eye; // relative to the scene's origin
uniform int lightCount;
uniform int layerCount;
uniform int samples;
uniform vec2 size;     // of lights without a shape: tangent of half the angle, or radius of positional ones

#include "rays/pixel_surface.glsl"

const float REACH = 0.45; // as a share of half the width of a penumbra; more blurs the edges
const int CELLS = 16; // parts of a light of which each ray chooses one

// A point of a light, in one of its cells along a Z-order curve, and how much it contributes to the irradiance.
vec4 cellPoint(LightData light, RaySurfacePoint at, int cell, vec2 within)
{
  ivec2 place = ivec2((cell & 1) | (cell >> 1 & 2), (cell >> 1 & 1) | (cell >> 2 & 2));
  vec4 point = giLightPoint(light, at.position, (vec2(place) + within) / 4.0);
  point.w *= max(dot(at.normal, normalize(point.xyz)), 0.0);
  return point;
}

// Half the width of a penumbra at a surface: of the light, as seen through the edge of an occluder. extent: half the light's
// width, or the tangent of half its angle; distance: of the occluder, see rayReaches().
float penumbraOf(float extent, vec4 toward, float distance)
{
  return extent * (toward.w <= 1.0 ? distance / max(1.0 - distance, 1e-3) : distance * length(toward.xyz));
}

float extentOf(LightData light)
{
  int shape = int(light.Side.w + 0.5);
  float fall = light.Up.w; // one minus the cosine
  return shape == GI_SHAPE_ANGLE ? sqrt(fall * (2.0 - fall)) / max(1.0 - fall, 1e-3)
    : (shape == GI_SHAPE_SPHERE ? light.Up.w : max(length(light.Side.xyz), length(light.Up.xyz)));
}

// Results of a light: share of its rays that arrive, and the mean half width of the penumbras of the others' occluders.
struct Shadow
{
  float open;
  float penumbra; // 0 if all arrive
};

void addRay(inout Shadow shadow, float extent, bool faces, vec4 toward, RaySurfacePoint at, inout uint state)
{
  float distance;
  bool open = faces && rayReaches(toward, at, distance, state);
  shadow.open += open ? 1.0 : 0.0;
  shadow.penumbra += faces && !open ? penumbraOf(extent, toward, distance) : 0.0;
}

Shadow meanOf(Shadow sum, int rays)
{
  return Shadow(sum.open / float(rays), sum.penumbra / max(float(rays) - sum.open, 1.0));
}

// Share of the light of a light with a shape that arrives. Each ray goes to a point of one of the light's cells, chosen
// with the probability that it contributes to the irradiance (resampling: Talbot, Cline and Egbert 2005, "Importance
// Resampling for Global Illumination").
Shadow shapeShadow(LightData light, RaySurfacePoint at, ivec2 pixel, uint seed, inout uint state)
{
  bool local = light.Kind.x == GI_LIGHT_POSITIONAL;
  float extent = extentOf(light);
  Shadow shadow = Shadow(0.0, 0.0);
  for (int i = 0; i < samples; ++i)
  {
    uint number = uint(view.Frame.x * samples + i);
    vec2 within = giTileSample2D(number, pixel, giHash(seed));
    float sum = 0.0;
    for (int cell = 0; cell < CELLS; ++cell)
    {
      sum += cellPoint(light, at, cell, within).w;
    }
    float left = giTileSample2D(number, pixel, seed).x * sum;
    vec4 point = vec4(0.0);
    for (int cell = 0; cell < CELLS && left >= 0.0 && sum > 0.0; ++cell)
    {
      vec4 candidate = cellPoint(light, at, cell, within);
      point = candidate.w > 0.0 ? candidate : point;
      left -= candidate.w;
    }
    addRay(shadow, extent, point.w > 0.0, vec4(point.xyz, local ? 1.0 : RAY_FAR), at, state);
  }
  return meanOf(shadow, samples);
}

// seed: of the light's samples; state: of other random numbers.
Shadow lightShadow(LightData light, RaySurfacePoint at, ivec2 pixel, uint seed, inout uint state)
{
  if (giHasShape(light))
  {
    return shapeShadow(light, at, pixel, seed, state);
  }
  vec4 toward = rayTowardLight(light, at.position, eye);
  mat3 across = giBasis(normalize(toward.xyz));
  float radius = toward.w <= 1.0 ? size.y : size.x;
  radius = light.Side.w > 0.5 ? 0.0 : radius; // a point
  int count = radius > 0.0 ? samples : 1;
  Shadow shadow = Shadow(0.0, 0.0);
  for (int i = 0; i < count; ++i)
  {
    vec2 disc = radius * giSampleDisc(giTileSample2D(uint(view.Frame.x * count + i), pixel, seed));
    vec4 direction = vec4(toward.xyz + across * vec3(disc, 0.0), toward.w);
    addRay(shadow, radius, dot(at.normal, direction.xyz) > 0.0, direction, at, state);
  }
  return meanOf(shadow, count);
}

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 window = pixel + ivec2(view.Viewport.xy);
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))) ||
    texelFetch(albedoTexture, window, 0).a == 0.0)
  {
    return;
  }
  RaySurfacePoint at = rayPixelSurface(window);
  uint state = giHash(giHash(uint(window.x) + (uint(window.y) << 16)) ^ giHash(uint(view.Frame.x)));
  for (int layer = 0; layer < layerCount; ++layer)
  {
    vec4 open = vec4(1.0);
    vec4 width = vec4(0.0);
    for (int i = 0; i < lightCount; ++i)
    {
      LightData light = lights[i];
      if (light.Kind.y >= 0 && light.Kind.y / 4 == layer)
      {
        Shadow shadow = lightShadow(light, at, pixel, uint(i), state);
        open[light.Kind.y & 3] = shadow.open;
        width[light.Kind.y & 3] = shadow.penumbra;
      }
    }
    imageStore(visibility, ivec3(window, layer), open);
    imageStore(reach, ivec3(window, layer), min(REACH * width, vec4(6e4)));
  }
}
