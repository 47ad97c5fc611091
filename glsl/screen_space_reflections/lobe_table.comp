#version 430 core
// Reflectance of lobes under uniform light, by the cosine to the eye (column) and the roughness (row). x and y
// are the factors of f0 and f90 of VTK's metallic-roughness model (Karis 2013, "Real Shading in Unreal
// Engine 4"); z is the part of a Phong lobe that is above the horizon.
#include "lib/sampling.glsl"
#include "lib/pbr.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba16f, binding = 0) uniform writeonly image2D table;

const int SAMPLES = 512;

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(table);
  vec2 place = vec2(texel) / vec2(size - 1);
  float NdV = max(place.x, 1e-3);
  float roughness = place.y;
  float width = max(roughness * roughness, 1e-4);
  float power = 0.5 / pow(max(roughness, 0.02), 4.0) - 0.5; // inverse of phongRoughness() in lobe.glsl
  vec3 V = vec3(sqrt(1.0 - NdV * NdV), 0.0, NdV);
  mat3 mirrored = giBasis(vec3(-V.xy, V.z));
  float a2 = width * width;
  float masking = 2.0 * NdV / (NdV + sqrt(a2 + (1.0 - a2) * NdV * NdV));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < SAMPLES; ++i)
  {
    vec2 u = giSample2D(uint(i), 0x51ed270bu);
    vec3 H = giSampleVisibleGGX(u, V, width);
    vec3 L = reflect(-V, H);
    if (L.z > 0.0)
    {
      float weight = 4.0 * NdV * L.z * giVisibilitySmith(NdV, L.z, roughness) / masking;
      float edge = pow(1.0 - clamp(dot(H, L), 0.0, 1.0), 5.0);
      sum.xy += weight * vec2(1.0 - edge, edge);
    }
    sum.z += (mirrored * giSamplePower(u, max(power, 0.0))).z > 0.0 ? 1.0 : 0.0;
  }
  imageStore(table, texel, vec4(sum / float(SAMPLES), 0.0));
}
