// Irradiance at a point where a ray ended, from the probes that see it. Statistics of distances, which the rasterizer's pixels
// use, leak light through walls; here rays decide. Needs ddgi/field.glsl, rays/hit_light.glsl, rays/toward_light.glsl. Variants:
// those of rays/hit_light.glsl, GI_FIELD_NESTED.
#ifdef GI_RAY_SKY_CELLS
#define FIELD_SKY raySkyMean
#else
#define FIELD_SKY raySkyRadiance
#endif
const int FIELD_STEPS = 4; // surfaces that a path visits to find one whose light the probes know

// Weight of a probe that sees the surface.
float fieldSeenWeight(vec3 toProbe, vec3 N)
{
  float facing = dot(toProbe, N) * inversesqrt(max(dot(toProbe, toProbe), 1e-30));
  return facing > 0.0 ? (0.5 + 0.5 * facing) * (0.5 + 0.5 * facing) : 0.0;
}

// A random one of the eight probes of a grid around a point, among those that see it, with a probability proportional to
// its weight: probes are drawn until a ray reaches one (rejection sampling). -1 if none sees the point.
int fieldSeenProbe(fieldGrid grid, RaySurfacePoint at, inout uint state)
{
  vec3 place = (at.position - grid.origin) / grid.spacing;
  ivec3 base = clamp(ivec3(floor(place)), ivec3(0), max(grid.counts - 2, ivec3(0)));
  vec3 share = clamp(place - vec3(base), vec3(0.0), vec3(1.0));
  float weights[8];
  float left = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    ivec3 corner = fieldCorner(i);
    ivec3 cell = min(base + corner, grid.counts - 1);
    vec3 offset = texelFetch(fieldProbes, fieldTile(fieldIndex(grid, cell)), 0).xyz;
    vec3 shares = mix(1.0 - share, share, vec3(corner));
    vec3 position = grid.origin + grid.spacing * vec3(cell) + offset;
    weights[i] = shares.x * shares.y * shares.z * fieldSeenWeight(position - at.position, at.normal);
    left += weights[i];
  }
  float least = 1e-4 * left;
  for (int tries = 0; tries < 8 && left > least; ++tries)
  {
    float u = giRandom(state) * left;
    int chosen = 0;
    for (int i = 0; i < 8; ++i)
    {
      chosen = weights[i] > 0.0 && u >= 0.0 ? i : chosen;
      u -= weights[i];
    }
    int probe = fieldIndex(grid, min(base + fieldCorner(chosen), grid.counts - 1));
    vec3 toProbe = fieldPosition(grid, probe) - at.position;
    // A probe whose distances are unknown has no light yet.
    bool known = fieldFetch(fieldDistance, probe, -normalize(toProbe), float(GI_FIELD_DISTANCE)).x > 0.0;
    if (known && rayReaches(vec4(toProbe, 1.0), at, state))
    {
      return probe;
    }
    left -= weights[chosen];
    weights[chosen] = 0.0;
  }
  return -1;
}

// Irradiance divided by pi, from a probe that sees the point. way: as for fieldReflected().
bool fieldSeenLight(RaySurfacePoint at, float way, out vec3 light, inout uint state)
{
  light = vec3(0.0);
  fieldEachGrid(at.position)
  {
    bool isFar = way >= fieldCellSize(walk.grid);
    int probe = isFar && giRandom(state) < walk.share ? fieldSeenProbe(walk.grid, at, state) : -1;
    if (probe >= 0)
    {
      light = fieldLightOf(probe, at.normal);
      return true;
    }
    walk.left = 1.0;
  }
  return false;
}

// Radiance that a surface reflects where a ray ended: what hitStraightLight() finds, and what a probe knows. A path goes on to
// another surface if no probe sees this one, or if the ray was shorter than a cell: light that differs within a cell, as in folds
// and at contacts, is found by rays (as from photon maps: Jensen 1996, Global Illumination using Photon Maps). way: length of the
// ray; RAY_FAR: ask probes however short it was.
vec3 fieldReflected(RaySurfacePoint at, float way, inout uint state)
{
  vec3 sum = vec3(0.0);
  vec3 weight = vec3(1.0);
  for (int i = 0; i <= FIELD_STEPS; ++i)
  {
    weight *= hitReflectance(at);
    if (weight == vec3(0.0))
    {
      break;
    }
    sum += weight * hitStraightLight(at, state);
    vec3 light;
    if (fieldSeenLight(at, i < FIELD_STEPS ? way : RAY_FAR, light, state))
    {
      return sum + weight * light;
    }
    vec3 L = giBasis(at.normal) * giSampleCosine(vec2(giRandom(state), giRandom(state)));
    bool closed;
    Ray ray = Ray(rayArrive(at, L, closed), 0.0, L, RAY_FAR);
    if (closed || i == FIELD_STEPS)
    {
      break;
    }
    vec3 from = at.position;
    float first;
    if (traceThrough(ray, at, first, state).instance < 0)
    {
#if defined(GI_RAY_SKY) && !defined(GI_SKY_AT_HITS)
      sum += weight * FIELD_SKY(L);
#endif
      break;
    }
    way = distance(from, at.position);
#ifdef GI_SEEK_EMITTERS
    bool sought = raySurfaces[at.surface].Emission.w > 0.0;
#else
    const bool sought = false;
#endif
    sum += sought ? vec3(0.0) : weight * at.emission;
  }
  return sum;
}
