// What is known of each probe, beside its maps. Needs ddgi/field.glsl.
struct ProbeState
{
  float lights;    // updates of its map of light since it stands where it does
  float distances; // and of its map of distances
  float idle;      // how often no surface was found that could ask it; 0 where one was
};

layout(rgba32f, binding = 2) uniform image2D states;

const float PROBE_RESTS = 3.0; // idle so often
const int PROBE_WAKES = 8;     // in one of so many updates

ProbeState probeState(int probe)
{
  vec4 texel = imageLoad(states, fieldTile(probe));
  return ProbeState(texel.x, texel.y, texel.z);
}

void setProbeState(int probe, ProbeState state)
{
  imageStore(states, fieldTile(probe), vec4(state.lights, state.distances, state.idle, 0.0));
}

// Probes that nobody asks are updated now and then only.
bool probeRests(int probe, int update, ProbeState state)
{
  return state.idle >= PROBE_RESTS && (probe + update) % PROBE_WAKES != 0;
}
