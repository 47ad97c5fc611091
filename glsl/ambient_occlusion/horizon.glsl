// To one side of a slice, by the highest horizon. What is seen stands for all that is behind it,
// unless it is so far before the surface that it must be another thing.
float horizonAt(Walk walk, WalkLine line, Search search, float t)
{
  vec2 seen;
  bool rises = walkStep(walk, line, search, t, seen);
  float top = walkTop(seen);
  float found = top * inversesqrt(max(top * top + seen.x * seen.x, 1e-30));
  float weight = clamp(2.0 - seen.y / radius, 0.0, 1.0);
  return rises ? mix(-line.n.y, found, weight) : -line.n.y;
}

// The light that is closed; its mean direction times it, across the view and toward the eye.
vec3 closedSide(Walk walk, WalkLine line)
{
  float horizon = -line.n.y;
  Search search = walkSearch(walk, line);
  for (int i = 0; i < steps + refinements; ++i)
  {
    float t = walkNext(walk, search, i);
    float found = horizonAt(walk, line, search, t);
    search.best = found > horizon ? t : search.best;
    horizon = max(horizon, found);
  }
  float s = sqrt(max(1.0 - horizon * horizon, 0.0));
  return vec3(giWholeArc(line.n) - giArc(horizon, s, line.n),
    giArcMoment(-line.n.y, line.n.x, line.n) - giArcMoment(horizon, s, line.n));
}
