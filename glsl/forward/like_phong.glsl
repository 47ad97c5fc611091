//VTK::System::Dec
// Minimal stand-in for VTK's shader of a Phong surface, to find out whether the inserted parts compile.
in vec4 vertexVC;
in vec3 normalVCVSOutput;
out vec4 fragOutput0;
uniform vec3 lightColor0;
//VTK::Light::Dec

void main()
{
  vec3 ambientColor = vec3(0.0);
  vec3 diffuseColor = vec3(1.0);
  float opacity = 0.5;
  //VTK::Light::Impl
  vec3 diffuse = diffuseColor * lightColor0;
  vec3 specular = lightColor0;
  gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);
  //VTK::TCoord::Impl
}
