// The functions of lib/ that the techniques' parts need, once. Variant: GI_RULES (surfaces reflect by rules).
#include "lib/octahedral.glsl"
#include "lib/cube_light.glsl"
#include "lib/spherical_harmonics.glsl"
#include "lib/luminance.glsl"
#ifdef GI_RULES
#include "forward/rules.glsl"
#endif
