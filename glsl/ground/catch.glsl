// The pixels of a catcher. Needs ground/plane.glsl, shared/material.h, lib/luminance.glsl.
layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D before; // the picture

uniform float strength;

bool giCatches(ivec2 pixel)
{
  int material = int(texelFetch(normalTexture, pixel, 0).z * 65535.0 + 0.5);
  return texelFetch(albedoTexture, pixel, 0).a > 0.0 && materials[material].Model.x == GI_MATERIAL_CATCHER;
}

// The background, darkened by the light that arrives, divided by the light that would arrive without the props (Debevec
// 1998, Rendering Synthetic Objects into Real Scenes).
vec4 giCaught(vec4 background, GiGround ground, vec3 arriving, vec3 whole)
{
  vec3 kept = mix(vec3(1.0), min(arriving / max(whole, vec3(1e-30)), 1.0), greaterThan(whole, vec3(0.0)));
  kept = mix(vec3(1.0), kept, strength * ground.opacity);
  // A grey shadow has the same effect if it is blended over another background later.
  return vec4(background.rgb * kept, 1.0 - (1.0 - background.a) * giLuminance(kept));
}
