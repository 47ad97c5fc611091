//VTK::System::Dec
// Minimal stand-in for VTK's shader of a PBR surface, to find out whether the inserted parts compile.
in vec4 vertexVC;
in vec3 normalVCVSOutput;
out vec4 fragOutput0;
uniform vec3 lightColor0;
uniform samplerCube prefilterTex;
uniform sampler2D brdfTex;
//VTK::Light::Dec

void main()
{
  vec3 diffuseColor = vec3(1.0);
  float metallic = 0.0;
  float roughnessUniform = 0.5;
  float roughness = roughnessUniform;
  float NdV = 0.5;
  float opacity = 0.5;
  vec3 F0 = vec3(0.04);
  //VTK::Light::Impl
  vec3 albedo = diffuseColor;
  vec2 brdf = texture(brdfTex, vec2(NdV, roughness)).rg;
  vec3 F90 = vec3(1.0);
  vec3 Lo = vec3(0.0);
  vec3 diffuse = albedo;
  vec3 specular = F0;
  Lo += lightColor0 * (diffuse + specular);
  vec3 specularBrdf = F0 * brdf.r + brdf.g;
  vec3 prefilteredSpecularColor = texture(prefilterTex, normalVCVSOutput).rgb;
  vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;
  vec3 iblDiffuse = albedo;
  vec3 color = iblDiffuse + iblSpecular;
  color += Lo;
  gl_FragData[0] = vec4(color, opacity);
  //VTK::TCoord::Impl
}
