#version 430 core
// Copies the picture's radiance; 0 outside the viewport. Variant: GI_VISIBLE_SKY (a skybox is behind everything).
#include "shared/view.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D colorTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(rgba32f, binding = 0) uniform writeonly image2D kept; // a: whether a surface or the sky covers the pixel

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(kept))))
  {
    return;
  }
  vec4 radiance = texelFetch(colorTexture, pixel, 0);
#ifdef GI_VISIBLE_SKY
  radiance.a = 1.0;
#else
  radiance.a = min(radiance.a, texelFetch(albedoTexture, pixel, 0).a); // a catcher covers its pixels partly
#endif
  ivec2 place = pixel - ivec2(view.Viewport.xy);
  bool inside = all(greaterThanEqual(place, ivec2(0))) && all(lessThan(place, ivec2(view.Viewport.zw)));
  imageStore(kept, pixel, inside ? radiance : vec4(0.0));
}
