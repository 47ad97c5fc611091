// The metallic-roughness model as VTK draws it: GGX distribution (Walter et al. 2007), height-
// correlated Smith visibility (Heitz 2014), Schlick's Fresnel term (1994), Lambert diffuse.
const float GI_PI = 3.14159265358979;

float giDistributionGGX(float NdH, float roughness)
{
  float a = roughness * roughness;
  float a2 = a * a;
  float d = (NdH * a2 - NdH) * NdH + 1.0;
  return a2 / (GI_PI * d * d);
}

// VTK passes the roughness itself as the GGX width here, not its square.
float giVisibilitySmith(float NdV, float NdL, float roughness)
{
  float a2 = roughness * roughness;
  float v = NdL * sqrt(a2 + NdV * (NdV - a2 * NdV));
  float l = NdV * sqrt(a2 + NdL * (NdL - a2 * NdL));
  return 0.5 / (v + l);
}

vec3 giFresnelSchlick(vec3 f0, vec3 f90, float HdL)
{
  return f0 + (f90 - f0) * pow(1.0 - HdL, 5.0);
}

// Radiance toward the eye for light of unit irradiance at normal incidence. diffuseShare: share of the light that the
// diffuse term reflects; 0 leaves only the highlight. boost: factor of the highlight, see lib/compensation.glsl.
vec3 giReflectPBR(vec3 N, vec3 V, vec3 L, vec3 albedo, float metallic, float roughness, vec3 f0, vec3 f90, vec3 boost,
  float diffuseShare)
{
  vec3 H = normalize(V + L);
  float NdV = clamp(dot(N, V), 1e-5, 1.0);
  float NdL = clamp(dot(N, L), 1e-5, 1.0);
  float NdH = clamp(dot(N, H), 1e-5, 1.0);
  float HdL = clamp(dot(H, L), 1e-5, 1.0);
  vec3 F = giFresnelSchlick(f0, f90, HdL);
  vec3 specular = giDistributionGGX(NdH, roughness) * giVisibilitySmith(NdV, NdL, roughness) * F * boost;
  vec3 diffuse = diffuseShare * (1.0 - metallic) * (1.0 - F) * albedo / GI_PI;
  return (diffuse + specular) * NdL;
}

vec3 giReflectPBR(vec3 N, vec3 V, vec3 L, vec3 albedo, float metallic, float roughness, vec3 f0, vec3 f90)
{
  return giReflectPBR(N, V, L, albedo, metallic, roughness, f0, f90, vec3(1.0), 1.0);
}
