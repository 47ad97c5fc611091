// Reach of a spatial filter after a number of frames, as a share of that at the first; half of it after `halved` frames. In the
// second half of `last` frames it falls to nothing, so that still pictures converge to their unfiltered mean.
vec4 giReachAfter(vec4 frames, float halved, float last)
{
  return clamp(2.0 - 2.0 * frames / last, 0.0, 1.0) / (1.0 + frames / halved);
}

// The same for pictures that are means of filtered frames. Such a mean retains the blur of its first frames, so the reach falls
// faster, but not to nothing, as each frame adds noise of its own.
float giReachInMean(float frames)
{
  float n = max(frames, 1.0);
  return max(1.0 / (1.0 + n / 4.0), 0.5 * pow(n, -0.25));
}
