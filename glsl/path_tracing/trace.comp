#version 430 core
// Traces one path per pixel and adds it to the sums. Variants: GI_VISIBLE_SKY (a skybox is behind everything), and those of
// path_tracing/paths.glsl and path_tracing/first_surface.glsl.
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "shared/material.h"
#include "rays/trace.glsl"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/lights.glsl"
#include "lib/luminance.glsl"
#include "lib/phong.glsl"
#include "lib/pbr.glsl"
#include "lib/sampling.glsl"
#include "lib/light_points.glsl"
#include "rays/surface.glsl"
#include "rays/passage.glsl"
#include "rays/toward_light.glsl"
#include "path_tracing/paths.glsl"
#include "path_tracing/first_surface.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

// Sums over samples.
layout(rgba32f, binding = 0) uniform image2D sumShown;   // rgb for display; a: number of PBR samples
layout(rgba32f, binding = 1) uniform image2D sumEncoded; // linear rgb of PBR samples; a: squared luminance
layout(rgba32f, binding = 2) uniform image2D sumAlbedo;  // rgb; a: samples that hit a surface
layout(rgba32f, binding = 3) uniform image2D sumNormal;  // xyz in world coordinates; w: depth
layout(rgba32f, binding = 4) uniform image2D sumUnlit;  // rgb for display of what is not lit; a: number of samples

layout(binding = 3) uniform sampler2D colorTexture;
#ifdef GI_VISIBLE_SKY
#include "lib/sky.glsl"
layout(binding = 4) uniform sampler2D skyTexture;
#endif

uniform int sampleIndex; // number of samples in the sums

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 window = pixel + ivec2(view.Viewport.xy);
  if (any(greaterThanEqual(pixel, ivec2(view.Viewport.zw))))
  {
    return;
  }
  uint state = startPath(window, sampleIndex);

  Ray ray;
  RaySurfacePoint at;
  bool met = firstSurface(window, vec2(0.0), ray, at, state);
  bool encoded = false;
  bool lit = false;
  vec3 value = texelFetch(colorTexture, window, 0).rgb; // lines and points, background
#ifdef GI_VISIBLE_SKY
  if (!drawnAt(window))
  {
    vec4 sky = texelFetch(skyTexture, window, 0);
    encoded = sky.a > 0.5;
    value = giSkyRadiance(sky);
  }
#endif
  vec4 albedo = vec4(0.0);
  vec4 normal = vec4(0.0);
  if (met)
  {
    albedo = vec4(at.color.rgb, 1.0);
    normal = vec4(at.normal, dot(at.position - eye, viewToScene * vec3(0.0, 0.0, -1.0)));
    RaySurface surface = raySurfaces[at.surface];
    encoded = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PBR;
    lit = (surface.Where.z & GI_SURFACE_MODEL) != GI_SURFACE_UNLIT;
    value = pathRadiance(ray, at, 0.0, state);
    value = any(isnan(value)) || any(isinf(value)) ? vec3(0.0) : value;
    value = lit && rayColoredByData(surface) ? mix(at.color.rgb, value, giDataLit(encoded)) : value;
  }
  float luminance = giLuminance(value);
  bool more = sampleIndex > 0;
  vec4 none = vec4(0.0);
  vec4 shown = more ? imageLoad(sumShown, window) : none;
  vec4 linear = more ? imageLoad(sumEncoded, window) : none;
  vec4 albedos = more ? imageLoad(sumAlbedo, window) : none;
  vec4 unlit = more ? imageLoad(sumUnlit, window) : none;
  vec4 normals = more ? imageLoad(sumNormal, window) : none;
  imageStore(sumShown, window, shown + (encoded ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(value, 0.0)));
  imageStore(sumEncoded, window,
    linear + vec4(encoded ? value : vec3(0.0), luminance * luminance));
  imageStore(sumAlbedo, window, albedos + albedo);
  // A sky that VTK encodes is in sumEncoded alone.
  imageStore(sumUnlit, window, unlit + (lit || encoded ? none : vec4(value, 1.0)));
  imageStore(sumNormal, window, normals + normal);
}
