// The pixels of a catcher. Needs ground/plane.glsl, lib/luminance.glsl.
layout(binding = 0) uniform sampler2D albedoTexture;
layout(binding = 1) uniform sampler2D normalTexture;

uniform float strength;
uniform int catcher; // material

bool giCatches(ivec2 pixel)
{
  int material = int(texelFetch(normalTexture, pixel, 0).z * 65535.0 + 0.5);
  return texelFetch(albedoTexture, pixel, 0).a > 0.0 && material == catcher;
}

// Opacity of a grey shadow that has the same effect if it is blended over another background later.
float giShadowAlpha(vec3 kept)
{
  return 1.0 - giLuminance(kept);
}

// The factor of what is behind the ground: the light that arrives, divided by the light that would arrive without the
// props (Debevec 1998, Rendering Synthetic Objects into Real Scenes).
vec3 giKept(GiGround ground, vec3 arriving, vec3 whole)
{
  vec3 kept = mix(vec3(1.0), min(arriving / max(whole, vec3(1e-30)), 1.0), greaterThan(whole, vec3(0.0)));
  return mix(vec3(1.0), kept, strength * ground.opacity);
}
