// Irradiance from probes at each pixel's surface, divided by pi. Needs shared/view.h, lib/octahedral.glsl,
// lib/reconstruct.glsl and fieldIrradiance(). Variant: GI_BENT (look up light in the direction of the bent normal).
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;
#ifdef GI_BENT
layout(binding = 3) uniform sampler2D openTexture; // see ambient_occlusion/raw.glsl
#endif

uniform mat3 viewToScene;
uniform vec3 eye; // relative to the scene's origin
uniform float intensity;

layout(location = 0) out vec4 irradiance;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  irradiance = vec4(0.0);
  if (texelFetch(albedoTexture, pixel, 0).a == 0.0)
  {
    return;
  }
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r);
  vec3 N = giDecodeOctahedral(texelFetch(normalTexture, pixel, 0).xy);
  vec3 D = N;
#ifdef GI_BENT
  // Where hardly any light arrives, its direction says little.
  vec3 open = transpose(mat3(view.ViewToWorld)) * (texelFetch(openTexture, pixel, 0).gba * 2.0 - 1.0);
  D = normalize(open + 0.02 * N);
#endif
  float reach = length(P);
  vec3 V = view.Scene.y > 0.5 ? vec3(0.0, 0.0, 1.0) : -P / reach;
  vec3 light = fieldIrradiance(eye + viewToScene * P, viewToScene * N, viewToScene * D, viewToScene * V, reach);
  irradiance = vec4(intensity * light, 1.0);
}
