#version 430 core
// Balls at the baked probes.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/spherical_harmonics.glsl"
#include "probes/field.glsl"
#include "probes/spheres.glsl"
#include "sh_probes/light.glsl"

const int PROBE_STRAYS = 0; // moved by 0.4 cells at most

bool probeIsResting(int probe)
{
  return false;
}
#include "probes/show.glsl"
