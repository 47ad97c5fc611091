// Reach of a spatial filter after a number of frames, as a share of that at the first. It falls to nothing, so that still
// pictures converge to their unfiltered mean.
vec4 giReachAfter(vec4 frames)
{
  const float last = 64.0;
  return clamp(2.0 - 2.0 * frames / last, 0.0, 1.0) / (1.0 + frames / 4.0);
}

// The same for light, whose filter knows the noise that is left and spares what stands out of it.
float giLightReachAfter(float frames)
{
  const float last = 64.0;
  return clamp(2.0 - 2.0 * frames / last, 0.0, 1.0) / (1.0 + frames / 16.0);
}
