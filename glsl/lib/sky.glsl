// Radiance of resource::Sky. An alpha of 1 marks values encoded for display.
vec3 giSkyRadiance(vec4 sky)
{
  return sky.a > 0.5 ? pow(max(sky.rgb, 0.0), vec3(2.2)) : sky.rgb;
}
