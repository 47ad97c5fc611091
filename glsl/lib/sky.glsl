// The radiance of resource::Sky: its alpha tells whether it holds values for display.
vec3 giSkyRadiance(vec4 sky)
{
  return sky.a > 0.5 ? pow(max(sky.rgb, 0.0), vec3(2.2)) : sky.rgb;
}
