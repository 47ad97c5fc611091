#version 150
// Stands in for VTK's template, to find out whether capture snippets from another folder compile. In VTK's template
// an error would end the process.
#define GI_FLAT 1
#define GI_ROUND 1
#define GI_LOBE_KNOWN 1
vec4 giRoundVSOutput = vec4(0.0, 0.0, 1.0, 0.0);
vec4 vertexVC = vec4(gl_FragCoord.xyz, 1.0);
vec3 normalVCVSOutput = vec3(0.0, 0.0, 1.0);
vec3 diffuseColor = vec3(0.0);
vec3 ambientColor = vec3(0.0);
vec3 albedo = vec3(0.0);
vec3 F0 = vec3(0.04);
vec2 brdf = vec2(1.0, 0.0);
vec3 color = vec3(0.0);
vec3 iblSpecular = vec3(0.0);
vec3 FmsEms = vec3(0.0);
vec3 irradiance = vec3(0.0);
vec3 emissiveColor = vec3(0.0);
float ao = 1.0;
float aoStrengthUniform = 1.0;
float metallic = 0.0;
float roughness = 0.5;
#include "capture/declarations.glsl"

void main()
{
  gl_FragData[0] = vec4(1.0);
#include "capture/mend_normal.glsl"
#include "capture/reflectance.glsl"
#include "capture/surrounding.glsl"
#include "capture/before_texture.glsl"
//PENUMBRA::Capture
}
