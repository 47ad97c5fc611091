// Visibility of a light with shadow maps at a point of a prop that VTK draws itself (see forward/lights.glsl). P, N,
// facet and bulge: as in capture/facet.glsl, in view coordinates. Variants: those of shadow_maps/receive.glsl.
#include "shared/view.h"
#include "shared/shadow.h"
#include "lib/noise.glsl"
uniform sampler2D atlas;
#include "shadow_maps/sheet.glsl"
#include "shadow_maps/filter.glsl"
#include "shadow_maps/receive.glsl"

float giVisibility(int shadow, vec3 P, vec3 N, vec3 facet, float bulge)
{
  GiShadowed surface = GiShadowed(P, N, facet, bulge, 0.0);
  // The noise is the same in every frame, as nothing averages what VTK draws.
  float angle = 6.28318531 * giInterleavedNoise(gl_FragCoord.xy, 0);
  return giShadowVisibility(shadowLights[shadow], surface, angle);
}

// Visibility at a point in a volume. N and facet face the light.
float giVisibility(int shadow, vec3 P)
{
  vec4 light = shadowLights[shadow].Position;
  vec3 L = light.w > 0.5 ? normalize(light.xyz - P) : -shadowLights[shadow].Direction.xyz;
  return giVisibility(shadow, P, L, L, 0.0);
}
