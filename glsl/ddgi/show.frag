#version 430 core
// Draws balls at the live probes.
#include "shared/view.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "ddgi/field.glsl"
#include "ddgi/states.glsl"
#include "probes/spheres.glsl"

const int PROBE_STRAYS = 1; // probes move toward a neighbour, but not as far as its grid point

vec3 probeIrradiance(int probe, vec3 N)
{
  return fieldFetch(fieldLight, probe, N, float(GI_FIELD_LIGHT)).rgb;
}

bool probeIsResting(int probe)
{
  return probeState(probe).idle >= PROBE_RESTS;
}
#include "probes/show.glsl"
