// Points of lights that have a shape of their own. Needs shared/light.h, lib/sampling.glsl.

bool giHasShape(LightData light)
{
  return light.Side.w > float(GI_SHAPE_POINT) + 0.5;
}

// Vector from a position to a point of a light; a direction for a directional light. w: factor of the light's strength
// at normal incidence. The mean over uniform u of w times a function is the integral over the light, so that of w
// times the cosine is the irradiance as a share of that of a point light at the centre.
vec4 giLightPoint(LightData light, vec3 position, vec2 u)
{
  int shape = int(light.Side.w + 0.5);
  float phi = 6.28318530717959 * u.y;
  if (shape == GI_SHAPE_ANGLE)
  {
    float fall = u.x * light.Up.w; // one minus the cosine
    float sine = sqrt(fall * (2.0 - fall));
    return vec4(giBasis(-light.Direction.xyz) * vec3(sine * cos(phi), sine * sin(phi), 1.0 - fall),
      2.0 / (2.0 - light.Up.w));
  }
  vec3 path = light.Position.xyz - position;
  float square = dot(path, path);
  if (shape == GI_SHAPE_SPHERE)
  {
    // Uniform over the cone that the sphere fills.
    float radius = light.Up.w;
    float share = min(radius * radius / square, 1.0);
    float cosine = sqrt(1.0 - share);
    float fall = u.x * share / (1.0 + cosine);
    float sine2 = fall * (2.0 - fall);
    float sine = sqrt(sine2);
    float far = sqrt(square);
    float near = far * (1.0 - fall) - sqrt(max(radius * radius - square * sine2, 0.0));
    return vec4(max(near, 1e-3 * radius) *
        (giBasis(path / far) * vec3(sine * cos(phi), sine * sin(phi), 1.0 - fall)),
      2.0 / (1.0 + cosine));
  }
  vec2 place = shape == GI_SHAPE_DISC ? giSampleDisc(u) : 2.0 * u - 1.0;
  vec3 to = path + place.x * light.Side.xyz + place.y * light.Up.xyz;
  float distance2 = max(dot(to, to), 1e-30);
  float shining = max(-dot(to, light.Direction.xyz), 0.0) * inversesqrt(distance2);
  return vec4(to, (square + light.Attenuation.w) * shining / distance2);
}
