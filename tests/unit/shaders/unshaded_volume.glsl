//VTK::System::Dec
//VTK::ComputeLighting::Dec
vec4 computeLighting(vec4 color)
{
  finalColor = vec4(color.rgb, 0.0);
  finalColor.a = color.a;
  return finalColor;
}
