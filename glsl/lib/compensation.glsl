// Light that microfacets reflect several times, which the single-scattering model of lib/pbr.glsl loses: Turquin 2019,
// "Practical multiple scattering compensation for microfacet models", equations 15 and 16.

uniform bool giCompensates; // highlights keep this light

// Factor of a highlight. share: its reflectance under uniform light with a Fresnel term of 1.
vec3 giCompensation(vec3 f0, float share)
{
  return 1.0 + f0 * (1.0 / clamp(share, 0.1, 1.0) - 1.0);
}

// Reflectance of the highlight of lib/pbr.glsl under uniform light with a Fresnel term of 1, a polynomial fitted to its
// integral: within 0.7 % for roughnesses from 0.2 and elevations from 2 degrees, within 2.2 % for smaller roughnesses
// (tests/gpu/TestLightLib.cxx).
float giHighlightShare(float NdV, float roughness)
{
  const float fitted[36] = float[36](
    2.7950, -22.8634, 58.8028, -64.5958, 35.0611, -8.1762,
    -18.4675, 145.5072, -308.0224, 378.1518, -321.4288, 118.5520,
    52.4373, -421.9179, 969.8331, -1682.5145, 1837.4744, -696.9758,
    -76.8621, 711.4969, -2108.4333, 4509.0493, -4871.0073, 1628.3624,
    60.3797, -637.5877, 2322.3467, -5314.0527, 5405.4624, -1538.9282,
    -19.3053, 222.7086, -925.9318, 2148.5410, -2045.7092, 472.8442);
  float x = NdV / (NdV + 0.8 * roughness + 0.005);
  float y = sqrt(roughness);
  float sum = 0.0;
  for (int i = 5; i >= 0; --i)
  {
    float row = 0.0;
    for (int j = 5; j >= 0; --j)
    {
      row = row * x + fitted[6 * i + j];
    }
    sum = sum * y + row;
  }
  return sum;
}
