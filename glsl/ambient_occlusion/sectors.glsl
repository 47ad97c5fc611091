// To one side of a slice, by sectors that hold alike much light: each thing closes those between its
// front and its back. After Therrien, Levesque and Gilet 2023, Screen Space Indirect Lighting with
// Visibility Bitmask, with the sectors spread by the closed form of the arc.
uniform float thickness; // world units

const uint SECTORS = 32u;

// The light from the view direction to that of an offset (across, toward).
float sectorLight(vec2 offset, vec2 n)
{
  vec2 d = offset * inversesqrt(max(dot(offset, offset), 1e-30));
  return giArc(d.y, d.x, n);
}

// The sectors that what is seen at a place closes; first: where they begin, or the last.
uint sectorsAt(Walk walk, WalkLine line, Search search, float t, float scale, out uint first)
{
  vec2 seen;
  bool rises = walkStep(walk, line, search, t, seen);
  vec2 front = vec2(seen.x, walkTop(seen));
  vec2 back = vec2(seen.x, min(seen.y - thickness, front.y));
  bool below = dot(back, line.n.yx) <= 0.0;
  // Rounded by chance, so that what is smaller than a sector counts in part.
  first = min(uint(sectorLight(front, line.n) * scale + walk.shift), SECTORS);
  uint last = below ? SECTORS : min(uint(sectorLight(back, line.n) * scale + walk.shift), SECTORS);
  bool some = rises && last > first;
  first = some ? first : SECTORS;
  return some ? (0xffffffffu >> (SECTORS - (last - first))) << first : 0u;
}

#ifdef GI_BENT
// Of the arc from the view direction that holds so much light: its light's mean direction times the light.
vec2 sectorMoment(float light, float whole, vec2 n)
{
  float low = 0.0;
  float high = giArcAngle(-n.y, n.x);
  if (light >= 0.999 * whole)
  {
    return giArcMoment(-n.y, n.x, n);
  }
  for (int i = 0; i < 6; ++i)
  {
    float middle = 0.5 * (low + high);
    bool more = giArc(cos(middle), sin(middle), n) < light;
    low = more ? middle : low;
    high = more ? high : middle;
  }
  float angle = 0.5 * (low + high);
  return giArcMoment(cos(angle), sin(angle), n);
}

// The mean direction of the light in sectors, times the light, across the view and toward the eye.
vec2 closedMoment(uint closed, float whole, vec2 n)
{
  float sector = whole / float(SECTORS);
  vec2 moment = vec2(0.0);
  while (closed != 0u)
  {
    int from = findLSB(closed);
    int open = findLSB(~(closed >> from)); // -1 where all are closed
    int to = open < 0 ? int(SECTORS) : min(from + open, int(SECTORS));
    moment += sectorMoment(float(to) * sector, whole, n) - sectorMoment(float(from) * sector, whole, n);
    closed = to < int(SECTORS) ? closed >> to << to : 0u;
  }
  return moment;
}
#endif

// The light that is closed; with GI_BENT its mean direction times it, across the view and toward the eye.
vec3 closedSide(Walk walk, WalkLine line)
{
  float whole = giWholeArc(line.n);
  float scale = float(SECTORS) / max(whole, 1e-6);
  uint closed = 0u;
  uint highest = SECTORS;
  Search search = walkSearch(walk, line);
  for (int i = 0; i < steps + refinements; ++i)
  {
    float t = walkNext(walk, search, i);
    uint first;
    closed |= sectorsAt(walk, line, search, t, scale, first);
    search.best = first < highest ? t : search.best;
    highest = min(first, highest);
  }
  vec3 result = vec3(whole * float(bitCount(closed)) / float(SECTORS), 0.0, 0.0);
#ifdef GI_BENT
  result.yz = closedMoment(closed, whole, line.n);
#endif
  return result;
}
