//VTK::System::Dec
// Minimal stand-in for VTK's shader of a PBR surface, to find out whether the inserted parts compile.
in vec4 vertexVC;
in vec3 normalVCVSOutput;
out vec4 fragOutput0;
uniform vec3 lightColor0;
uniform samplerCube prefilterTex;
//VTK::Light::Dec

void main()
{
  vec3 albedo = vec3(1.0);
  float metallic = 0.0;
  float opacity = 0.5;
  vec3 F0 = vec3(0.04);
  //VTK::Light::Impl
  vec3 Lo = lightColor0 * albedo;
  vec3 iblSpecular = texture(prefilterTex, normalVCVSOutput).rgb;
  vec3 iblDiffuse = albedo;
  vec3 color = iblDiffuse + iblSpecular;
  color += Lo;
  gl_FragData[0] = vec4(color, opacity);
}
