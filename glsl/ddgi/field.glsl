// Irradiance at a point between live probes. Each probe holds irradiance divided by pi in an octahedral map
// with a border of one texel. Needs lib/octahedral.glsl.
#include "probes/field.glsl"
layout(binding = 4) uniform sampler2D fieldLight;

// Irradiance at a point of a surface, divided by pi. D: mean direction of the unoccluded light, N if nothing nearby
// occludes it. V, reach: as for fieldWeights().
vec3 fieldIrradiance(vec3 P, vec3 N, vec3 D, vec3 V, float reach)
{
  vec3 sum = vec3(0.0);
  fieldEachGrid(P)
  {
    int probes[8];
    float weights[8];
    fieldWeights(walk, P, N, V, reach, true, probes, weights);
    for (int i = 0; i < 8; ++i)
    {
      sum += walk.share * weights[i] * fieldFetch(fieldLight, probes[i], D, float(GI_FIELD_LIGHT)).rgb;
    }
  }
  return sum;
}
