// Light on surfaces coloured by data, see techniques/data_colors.
#include "lib/luminance.glsl"
uniform bool giDataKeepsHue; // indirect light does not change their hue
uniform float giDataFloor;   // share of their colour that they show without light, as displayed

// Indirect light that arrives at a surface coloured by data.
vec3 giDataLight(vec3 light)
{
  return giDataKeepsHue ? vec3(giLuminance(light)) : light;
}

// The same for light that is already multiplied by the surface's reflectance.
vec3 giDataReflected(vec3 light, vec3 reflectance)
{
  return giDataKeepsHue ? reflectance * (giLuminance(light) / max(giLuminance(reflectance), 1e-6)) : light;
}

// Factor of the light that such a surface reflects; its own colour makes up the rest. encoded: VTK encodes its values
// for display, with the exponent 1 / 2.2.
float giDataLit(bool encoded)
{
  return 1.0 - (encoded ? pow(giDataFloor, 2.2) : giDataFloor);
}
