// Irradiance at a point between live probes. Each probe holds irradiance divided by pi in an octahedral map
// with a border of one texel. Needs lib/octahedral.glsl.
#include "probes/field.glsl"
layout(binding = 4) uniform sampler2D fieldLight;

// Index of the map of what emitters send straight to a probe, which its first map contains.
int fieldEmittedMap(int probe)
{
  return fieldBegins[fieldGrids] + probe;
}

// Variant: GI_SEEK_EMITTERS (without what arrives straight from emitters, as rays go there).
vec3 fieldLightOf(int probe, vec3 direction)
{
  vec3 light = fieldFetch(fieldLight, probe, direction, float(GI_FIELD_LIGHT)).rgb;
#ifdef GI_SEEK_EMITTERS
  light -= fieldFetch(fieldLight, fieldEmittedMap(probe), direction, float(GI_FIELD_LIGHT)).rgb;
  light = max(light, vec3(0.0));
#endif
  return light;
}

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
      sum += walk.share * weights[i] * fieldLightOf(probes[i], D);
    }
  }
  return sum;
}
