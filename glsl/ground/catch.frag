#version 430 core
// The factor of the picture where the ground catches shadows, and their opacity. Variants: GI_DIRECT_VISIBILITY,
// GI_AMBIENT_VISIBILITY, GI_IRRADIANCE (indirect light is known).
#define GI_POSITIONAL 1
#include "shared/view.h"
#include "shared/light.h"
#include "lib/lights.glsl"
#include "lib/luminance.glsl"
#include "lib/reconstruct.glsl"
#include "ground/plane.glsl"
#include "ground/catch.glsl"

layout(binding = 3) uniform sampler2DArray directVisibility;
layout(binding = 4) uniform sampler2D ambientVisibility;
layout(binding = 5) uniform sampler2D irradianceTexture;
#include "lib/direct_visibility.glsl"

uniform int lightCount;
uniform vec3 ambientLight; // radiance that a white diffuse surface reflects from uniform surroundings
uniform vec3 openLight;    // the same from the environment, with nothing in between

layout(location = 0) out vec4 color;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (!giCatches(pixel))
  {
    discard;
  }
  GiGround ground = giGroundAt(gl_FragCoord.xy);
  vec3 whole = ambientLight;
  vec3 arriving = ambientLight;
#ifdef GI_IRRADIANCE
  arriving += texelFetch(irradianceTexture, pixel, 0).rgb;
  whole += openLight;
#endif
#ifdef GI_AMBIENT_VISIBILITY
  arriving *= texelFetch(ambientVisibility, pixel, 0).r;
#endif
  for (int i = 0; i < lightCount; ++i)
  {
    GiIncident incident = giIncident(lights[i], ground.P);
    vec3 light = lights[i].Color.rgb * incident.Attenuation * max(dot(plane.xyz, -incident.Travel), 0.0);
    whole += light;
    arriving += light * giDirectVisibility(pixel, lights[i].Kind.y);
  }
  vec3 kept = giKept(ground, arriving, whole);
  color = vec4(kept, giShadowAlpha(kept));
}
