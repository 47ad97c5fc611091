// Inserted into the fragment shaders of translucent surfaces and volumes, which VTK draws itself: the visibility of
// each light. A technique supplies the functions giVisibility. Variant: GI_POSITIONAL_FIRST (the shader lists
// positional lights first; else the lights are in the renderer's order).
#include "shared/forward.h"
uniform int giLights;
uniform float giKept; // share of the lights' strength that is not spread over all directions
#ifdef GI_POSITIONAL_FIRST
#define giShadowOf giShadowOfSorted
#endif
uniform int giShadowOf[GI_FORWARD_LIGHTS]; // index among the lights with shadows, -1 for a light without
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
