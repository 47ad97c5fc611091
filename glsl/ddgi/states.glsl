// State of each probe besides its maps. Needs ddgi/field.glsl.
struct ProbeState
{
  float lights;    // number of updates of its irradiance map at its position
  float distances; // number of updates of its distance map at its position
  float idle;      // number of consecutive checks that found no surface nearby that could use the probe
};

layout(rgba32f, binding = 2) uniform image2D states;

const float PROBE_RESTS = 3.0; // idle checks after which a probe rests
const int PROBE_WAKES = 8;     // a resting probe takes part in one of this many updates

ProbeState probeState(int probe)
{
  vec4 texel = imageLoad(states, fieldTile(probe));
  return ProbeState(texel.x, texel.y, texel.z);
}

void setProbeState(int probe, ProbeState state)
{
  imageStore(states, fieldTile(probe), vec4(state.lights, state.distances, state.idle, 0.0));
}

// Whether a probe skips this update, as no surface uses it.
bool probeRests(int probe, int update, ProbeState state)
{
  return state.idle >= PROBE_RESTS && (probe + update) % PROBE_WAKES != 0;
}
