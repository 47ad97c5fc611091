#version 430 core
// Irradiance from the live probes at each pixel's surface, divided by pi.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "ddgi/field.glsl"
#include "probes/gather.glsl"
