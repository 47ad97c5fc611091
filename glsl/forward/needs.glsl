// Includes the functions of lib/ that the techniques' parts need, once.
#include "lib/octahedral.glsl"
#include "lib/cube_light.glsl"
#include "lib/spherical_harmonics.glsl"
#include "lib/luminance.glsl"
