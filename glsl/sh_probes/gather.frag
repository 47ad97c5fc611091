#version 430 core
// Irradiance from the baked probes at each pixel's surface, divided by pi.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/spherical_harmonics.glsl"
#include "probes/field.glsl"
#include "sh_probes/light.glsl"
#include "probes/gather.glsl"
