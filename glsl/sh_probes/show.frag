#version 430 core
// Draws balls at the baked probes.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/spherical_harmonics.glsl"
#include "probes/field.glsl"
#include "probes/spheres.glsl"
#include "sh_probes/light.glsl"

const int PROBE_STRAYS = 0; // probes move by at most 0.4 cells

bool probeIsResting(int probe)
{
  return false;
}
#include "probes/show.glsl"
