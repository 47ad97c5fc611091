// Interleaved gradient noise in [0, 1): Jimenez 2014, Next Generation Post Processing in Call of
// Duty: Advanced Warfare. The golden ratio shifts it from frame to frame, so that its values at a pixel are evenly
// distributed over still frames.
float giInterleavedNoise(vec2 pixel, int frame)
{
  float spatial = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  return fract(spatial + 0.61803399 * float(frame));
}

// Point i of n points distributed evenly over the unit disc, rotated by an angle (Vogel 1979).
vec2 giVogelDisc(int i, int n, float angle)
{
  float radius = sqrt((float(i) + 0.5) / float(n));
  float turn = float(i) * 2.39996323 + angle;
  return radius * vec2(cos(turn), sin(turn));
}
