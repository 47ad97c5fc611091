// To one side of a slice, by the highest horizon. What is seen stands for all that is behind it,
// unless it is so far before the surface that it must be another thing.
float horizonAt(Walk walk, WalkLine line, Search search, float t, float perRadius)
{
  vec2 seen;
  bool rises = walkStep(walk, line, search, t, seen);
  // Of what is within the radius the highest point stands for all behind it.
  float x2 = seen.x * seen.x;
  float y2 = seen.y * seen.y;
  y2 = seen.y > 0.0 ? min(y2, max(radius * radius - x2, 0.0)) : y2;
  float found = sqrt(y2 / max(x2 + y2, 1e-30));
  found = seen.y < 0.0 ? -found : found;
  float weight = clamp(2.0 - seen.y * perRadius, 0.0, 1.0);
  return rises ? mix(-line.n.y, found, weight) : -line.n.y;
}

// The light that is closed; its mean direction times it, across the view and toward the eye.
vec3 closedSide(Walk walk, WalkLine line)
{
  float horizon = -line.n.y;
  float perRadius = 1.0 / radius;
  Search search = walkSearch(walk, line);
  for (int i = 0; i < steps + refinements; ++i)
  {
    float t = walkNext(walk, search, i);
    float found = horizonAt(walk, line, search, t, perRadius);
    search.best = found > horizon ? t : search.best;
    horizon = max(horizon, found);
  }
  float s = sqrt(max(1.0 - horizon * horizon, 0.0));
  return vec3(giWholeArc(line.n) - giArc(horizon, s, line.n),
    giArcMoment(-line.n.y, line.n.x, line.n) - giArcMoment(horizon, s, line.n));
}
