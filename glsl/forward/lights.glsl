// Into the fragment shaders of what VTK draws itself, translucent surfaces and volumes: what of
// each of its lights arrives. A technique gives the functions giVisibility. Variant: GI_POSITIONAL_FIRST,
// the shader has the positional lights first, else all as the renderer lists them.
#include "shared/forward.h"
uniform int giLights;
uniform float giKept; // of their strength
#ifdef GI_POSITIONAL_FIRST
#define giShadowOf giShadowOfSorted
#endif
uniform int giShadowOf[GI_FORWARD_LIGHTS]; // the light among the shadowed ones, -1 for none
float giArrives[GI_FORWARD_LIGHTS];

void giArriveAt(vec3 P, vec3 N, vec3 facet, float bulge)
{
  for (int i = 0; i < giLights; ++i)
  {
    giArrives[i] = giKept * (giShadowOf[i] >= 0 ? giVisibility(giShadowOf[i], P, N, facet, bulge) : 1.0);
  }
}

void giArriveAt(vec4 P)
{
  for (int i = 0; i < giLights; ++i)
  {
    giArrives[i] = giKept * (giShadowOf[i] >= 0 ? giVisibility(giShadowOf[i], P.xyz / P.w) : 1.0);
  }
}
