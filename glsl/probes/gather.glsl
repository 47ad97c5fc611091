// What probes send to each pixel's surface, divided by pi. Needs shared/view.h, lib/octahedral.glsl,
// lib/reconstruct.glsl and fieldIrradiance().
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D albedoTexture;
layout(binding = 2) uniform sampler2D normalTexture;

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
  float reach = length(P);
  vec3 V = view.Scene.y > 0.5 ? vec3(0.0, 0.0, 1.0) : -P / reach;
  irradiance = vec4(
    intensity * fieldIrradiance(eye + viewToScene * P, viewToScene * N, viewToScene * V, reach), 1.0);
}
