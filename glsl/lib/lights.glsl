// What reaches a point from a light, as VTK means its lights. Needs shared/light.h.
struct GiIncident
{
  vec3 Travel;       // unit, the way the light goes at the point
  float Attenuation; // of distance and cone
};

GiIncident giIncident(LightData light, vec3 position)
{
  GiIncident incident;
  incident.Travel = light.Direction.xyz;
  incident.Attenuation = 1.0;
#ifdef GI_POSITIONAL
  if (light.Kind.x == GI_LIGHT_POSITIONAL)
  {
    vec3 path = position - light.Position.xyz;
    float distance = length(path);
    incident.Travel = path / distance;
    vec3 c = light.Attenuation.xyz;
    incident.Attenuation = 1.0 / (c.x + c.y * distance + c.z * distance * distance);
    if (light.Color.w > -1.5)
    {
      float cone = dot(incident.Travel, light.Direction.xyz);
      incident.Attenuation *= cone >= light.Color.w ? pow(cone, light.Direction.w) : 0.0;
    }
  }
#endif
  return incident;
}
