//VTK::System::Dec
// Minimal stand-in for VTK's shader of a shaded volume, to find out whether the inserted parts compile.
out vec4 fragOutput0;
uniform mat4 in_modelViewMatrix;
uniform mat4 in_volumeMatrix[1];
uniform mat4 in_textureDatasetMatrix[1];
uniform mat4 in_textureToEye[1];
uniform vec3 in_cellSpacing[1];
uniform vec3 in_diffuse[4];
uniform vec3 in_ambient[4];
uniform vec3 in_lightDiffuseColor[2];
vec3 g_dataPos = vec3(0.0);
//VTK::ComputeLighting::Dec
vec4 computeLighting(vec4 color, int component, float label)
{
  vec4 finalColor = vec4(0.0);
  vec4 shading_gradient = vec4(1.0, 0.0, 0.0, -1.0);
  vec3 diffuse = vec3(0.0);
  for (int dirNum = 0; dirNum < 2; dirNum++)
  {
    diffuse += in_lightDiffuseColor[dirNum];
  }
  finalColor.xyz = in_ambient[component] + in_diffuse[component] * diffuse * color.rgb;
  finalColor.a = color.a;
  return finalColor;
}

void main()
{
  vec4 g_fragColor = computeLighting(vec4(1.0), 0, 0.0);
  gl_FragData[0] = g_fragColor;
}
