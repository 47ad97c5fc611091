// Reach of a spatial filter after a number of frames, as a share of that at the first; half of it after `halved` frames. In the
// second half of `last` frames it falls to nothing, so that still pictures converge to their unfiltered mean.
vec4 giReachAfter(vec4 frames, float halved, float last)
{
  return clamp(2.0 - 2.0 * frames / last, 0.0, 1.0) / (1.0 + frames / halved);
}
