// Phong highlight as VTK draws it. travel: direction in which the light travels.
float giPhongSpecular(vec3 normal, vec3 travel, vec3 toEye, float power)
{
  return pow(max(0.0, dot(reflect(travel, normal), toEye)), power);
}
