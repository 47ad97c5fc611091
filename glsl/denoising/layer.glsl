// A part of a layer of the network: a 3x3 convolution. The generated shader says how many activations come in and go out, in
// fours (GI_INPUTS, GI_OUTPUTS), how many of the former come from the layer above, which has half the size (GI_ABOVE, if any),
// which output is the part's first (GI_FIRST), and whether nothing follows, so that sums may be negative (GI_LAST). It computes
// the sums with weights that are literals. Variant: GI_WEIGHTS_BUFFER (weights come from a buffer, for drivers that compile long
// shaders slowly).
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray activations;
#ifdef GI_ABOVE
layout(binding = 1) uniform sampler2DArray above;
#endif
layout(rgba16f, binding = 0) writeonly uniform image2DArray result;

uniform ivec2 size; // of the layer, in texels

// Four activations near a place. Outside of the picture they are 0.
vec4 giActivation(ivec2 at, int four)
{
  ivec2 inside = clamp(at, ivec2(0), size - 1);
#ifdef GI_ABOVE
  vec4 found = four < GI_ABOVE ? texelFetch(above, ivec3(inside >> 1, four), 0)
                               : texelFetch(activations, ivec3(inside, four - GI_ABOVE), 0);
#else
  vec4 found = texelFetch(activations, ivec3(inside, four), 0);
#endif
  return inside == at ? found : vec4(0.0);
}

#ifdef GI_WEIGHTS_BUFFER
layout(std140, binding = 1) uniform GiWeights
{
  vec4 biases[GI_OUTPUTS];
  mat4 weights[9 * GI_INPUTS * GI_OUTPUTS];
};

void giSums(ivec2 at, inout vec4 sums[GI_OUTPUTS])
{
  for (int i = 0; i < GI_OUTPUTS; ++i)
  {
    sums[i] = biases[i];
  }
  for (int tap = 0; tap < 9; ++tap)
  {
    for (int four = 0; four < GI_INPUTS; ++four)
    {
      vec4 v = giActivation(at + ivec2(tap % 3, tap / 3) - 1, four);
      for (int i = 0; i < GI_OUTPUTS; ++i)
      {
        sums[i] += weights[(tap * GI_INPUTS + four) * GI_OUTPUTS + i] * v;
      }
    }
  }
}
#else
void giSums(ivec2 at, inout vec4 sums[GI_OUTPUTS]);
#endif

void main()
{
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, size)))
  {
    return;
  }
  vec4 sums[GI_OUTPUTS];
  giSums(at, sums);
  for (int i = 0; i < GI_OUTPUTS; ++i)
  {
#ifndef GI_LAST
    sums[i] = max(sums[i], 0.0);
#endif
    imageStore(result, ivec3(at, GI_FIRST + i), sums[i]);
  }
}
