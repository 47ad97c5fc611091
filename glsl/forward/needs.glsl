// What the parts that techniques give need of lib/, once.
#include "lib/octahedral.glsl"
#include "lib/cube_light.glsl"
#include "lib/spherical_harmonics.glsl"
