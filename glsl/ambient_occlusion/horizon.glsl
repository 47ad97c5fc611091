// Occlusion on one side of a slice, by the highest horizon. A visible surface is taken to occlude everything behind it,
// unless it is so far in front of the pixel's surface that it must be an unrelated object.
float horizonAt(Walk walk, WalkLine line, Search search, float t, float perRadius)
{
  vec2 seen;
  bool rises = walkStep(walk, line, search, t, seen);
  // The highest point within the radius represents everything behind it.
  float x2 = seen.x * seen.x;
  float y2 = seen.y * seen.y;
  y2 = seen.y > 0.0 ? min(y2, max(radius * radius - x2, 0.0)) : y2;
  float elevation = sqrt(y2 / max(x2 + y2, 1e-30));
  elevation = seen.y < 0.0 ? -elevation : elevation;
  float weight = clamp(2.0 - seen.y * perRadius, 0.0, 1.0);
  return rises ? mix(-line.n.y, elevation, weight) : -line.n.y;
}

// x: occluded light; yz: its mean direction times the light, across the view and toward the eye.
vec3 occludedSide(Walk walk, WalkLine line)
{
  float horizon = -line.n.y;
  float perRadius = 1.0 / radius;
  Search search = walkSearch(walk, line);
  for (int i = 0; i < steps + refinements; ++i)
  {
    float t = walkNext(walk, search, i);
    float elevation = horizonAt(walk, line, search, t, perRadius);
    search.best = elevation > horizon ? t : search.best;
    horizon = max(horizon, elevation);
  }
  float s = sqrt(max(1.0 - horizon * horizon, 0.0));
  return vec3(giWholeArc(line.n) - giArc(horizon, s, line.n),
    giArcMoment(-line.n.y, line.n.x, line.n) - giArcMoment(horizon, s, line.n));
}
