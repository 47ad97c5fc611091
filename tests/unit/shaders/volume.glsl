//VTK::System::Dec
//VTK::ComputeLighting::Dec
vec4 computeLighting(SIGNATURE)
{
  vec4 GRADIENT = computeGradient(g_dataPos);
  finalColor.xyz = in_ambient[COMPONENT] * ambient +
    in_diffuse[COMPONENT] * diffuse;
  finalColor.a = color.a;
}
