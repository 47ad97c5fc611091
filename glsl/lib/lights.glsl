// Light that arrives at a point, by VTK's definition of its lights. Needs shared/light.h.
struct GiIncident
{
  vec3 Travel;       // unit vector along which the light travels at the point
  float Attenuation; // by distance and cone
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
    if (light.Attenuation.w > 0.0)
    {
      distance = sqrt(distance * distance + light.Attenuation.w); // see vtkGILightShape
    }
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
