#version 430 core
// The greatest of each activation in blocks of 2x2 texels.
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray activations;
layout(rgba16f, binding = 0) writeonly uniform image2DArray result;

uniform ivec2 size; // of what is pooled

void main()
{
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(2 * block, size)))
  {
    return;
  }
  for (int four = 0; four < textureSize(activations, 0).z; ++four)
  {
    vec4 greatest = vec4(0.0); // activations are positive
    for (int i = 0; i < 4; ++i)
    {
      ivec2 at = min(2 * block + ivec2(i & 1, i >> 1), size - 1);
      greatest = max(greatest, texelFetch(activations, ivec3(at, four), 0));
    }
    imageStore(result, ivec3(block, four), greatest);
  }
}
