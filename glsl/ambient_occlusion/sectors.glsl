// Occlusion on one side of a slice, by sectors that hold equal amounts of light. Each occluder closes the sectors
// between its front and its back. After Therrien, Levesque and Gilet 2023, Screen Space Indirect Lighting with
// Visibility Bitmask, with sectors derived from the closed form of the arc.
uniform float thickness; // world units

const uint SECTORS = 32u;

// Height of an occluder, limited to the radius.
float walkHeight(vec2 seen)
{
  return min(seen.y, sqrt(max(radius * radius - seen.x * seen.x, 0.0)));
}

// Light of the arc from the view direction to the direction of an offset (across, toward).
float sectorLight(vec2 offset, vec2 n)
{
  vec2 d = offset * inversesqrt(max(dot(offset, offset), 1e-30));
  return giArc(d.y, d.x, n);
}

// Mask of the sectors that the surface at position t occludes. first: the first of them, or SECTORS if there is none.
uint sectorsAt(Walk walk, WalkLine line, Search search, float t, float scale, out uint first)
{
  vec2 seen;
  bool rises = walkStep(walk, line, search, t, seen);
  vec2 front = vec2(seen.x, walkHeight(seen));
  vec2 back = vec2(seen.x, min(seen.y - thickness, front.y));
  bool below = dot(back, line.n.yx) <= 0.0;
  // Stochastic rounding, so that occluders smaller than a sector count partly.
  first = min(uint(sectorLight(front, line.n) * scale + walk.shift), SECTORS);
  uint last = below ? SECTORS : min(uint(sectorLight(back, line.n) * scale + walk.shift), SECTORS);
  bool occludes = rises && last > first;
  first = occludes ? first : SECTORS;
  return occludes ? (0xffffffffu >> (SECTORS - (last - first))) << first : 0u;
}

#ifdef GI_BENT
// Mean direction times light of the arc that starts at the view direction and holds this much light.
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

// Mean direction of the light in the closed sectors times the light, across the view and toward the eye.
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

// x: occluded light; yz, with GI_BENT: its mean direction times the light, across the view and toward the eye.
vec3 occludedSide(Walk walk, WalkLine line)
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
