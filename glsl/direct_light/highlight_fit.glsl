// See highlight_table.comp. Needs lib/pbr.glsl, lib/sampling.glsl.
const int HIGHLIGHT_GRID = 12;  // samples per dimension
const int HIGHLIGHT_STEPS = 40; // of the search
const float HIGHLIGHT_NARROWEST = 0.0316; // roughness

// The lobe to be fitted.
struct Highlight
{
  vec3 V;
  float roughness;
  float width;  // GGX
  float norm;   // its integral
  mat3 frame;   // z: the mean direction, x in the plane of incidence
};

// The distribution times masking and cosine, without Fresnel's factor.
float highlightAt(Highlight lobe, vec3 L)
{
  if (L.z <= 0.0)
  {
    return 0.0;
  }
  float NdH = clamp(normalize(lobe.V + L).z, 1e-5, 1.0);
  return giDistributionGGX(NdH, lobe.roughness) * giVisibilitySmith(lobe.V.z, L.z, lobe.roughness) * L.z;
}

// Probability density of directions that mirror V at a microfacet.
float highlightDensity(Highlight lobe, vec3 L)
{
  vec3 H = normalize(lobe.V + L);
  return giDistributionGGX(max(H.z, 0.0), lobe.roughness) * max(H.z, 0.0) / max(4.0 * dot(lobe.V, H), 1e-6);
}

// p: logarithms of the two widths, and the shear in units of the first.
mat3 highlightMatrix(Highlight lobe, vec3 p)
{
  float x = exp(p.x);
  return lobe.frame * mat3(vec3(x, 0.0, 0.0), vec3(0.0, exp(p.y), 0.0), vec3(x * p.z, 0.0, 1.0));
}

// Integral of the cube of the difference, by both lobes' samples.
float highlightError(Highlight lobe, vec3 p)
{
  mat3 fromCosine = highlightMatrix(lobe, p);
  mat3 toCosine = inverse(fromCosine);
  float scale = abs(determinant(toCosine)) / GI_PI;
  float sum = 0.0;
  for (int i = 0; i < 2 * HIGHLIGHT_GRID * HIGHLIGHT_GRID; ++i)
  {
    int k = i / 2;
    vec2 u = (vec2(k / HIGHLIGHT_GRID, k % HIGHLIGHT_GRID) + 0.5) / float(HIGHLIGHT_GRID);
    vec3 L = (i & 1) == 0 ? normalize(fromCosine * giSampleCosine(u)) : reflect(-lobe.V, giSampleGGX(u, lobe.width));
    vec3 c = toCosine * L;
    float square = dot(c, c);
    float fitted = scale * max(c.z, 0.0) / (square * square);
    float difference = abs(highlightAt(lobe, L) / lobe.norm - fitted);
    sum += difference * difference * difference / max(fitted + highlightDensity(lobe, L), 1e-9);
  }
  return sum;
}

// The search of Nelder and Mead 1965, "A Simplex Method for Function Minimization".
vec3 fitWidths(Highlight lobe, vec3 start)
{
  vec4 points[4]; // w: error
  for (int i = 0; i < 4; ++i)
  {
    vec3 p = start + 0.3 * vec3(i == 1, i == 2, i == 3);
    points[i] = vec4(p, highlightError(lobe, p));
  }
  for (int step = 0; step < HIGHLIGHT_STEPS; ++step)
  {
    // The best point comes first, the worst one last.
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3 - i; ++k)
      {
        if (points[k].w > points[k + 1].w)
        {
          vec4 worse = points[k];
          points[k] = points[k + 1];
          points[k + 1] = worse;
        }
      }
    }
    vec3 middle = (points[0].xyz + points[1].xyz + points[2].xyz) / 3.0;
    vec3 p = 2.0 * middle - points[3].xyz;
    vec4 mirrored = vec4(p, highlightError(lobe, p));
    bool best = mirrored.w < points[0].w;
    if (!best && mirrored.w < points[2].w)
    {
      points[3] = mirrored;
      continue;
    }
    p = best ? 3.0 * middle - 2.0 * points[3].xyz
             : 0.5 * (middle + (mirrored.w < points[3].w ? mirrored.xyz : points[3].xyz));
    vec4 other = vec4(p, highlightError(lobe, p));
    if (other.w < min(mirrored.w, points[3].w))
    {
      points[3] = other;
    }
    else if (best)
    {
      points[3] = mirrored;
    }
    else
    {
      for (int i = 1; i < 4; ++i)
      {
        p = 0.5 * (points[0].xyz + points[i].xyz);
        points[i] = vec4(p, highlightError(lobe, p));
      }
    }
  }
  vec4 least = points[0];
  for (int i = 1; i < 4; ++i)
  {
    least = points[i].w < least.w ? points[i] : least;
  }
  return least.xyz;
}

// place: the cosine to the eye and the roughness.
vec4[2] fitHighlight(vec2 place)
{
  Highlight lobe;
  float cosine = max(place.x, 1e-2);
  lobe.V = vec3(sqrt(1.0 - cosine * cosine), 0.0, cosine);
  lobe.roughness = max(place.y, HIGHLIGHT_NARROWEST);
  lobe.width = lobe.roughness * lobe.roughness;
  const int samples = 512;
  vec3 mean = vec3(0.0);
  vec2 shares = vec2(0.0);
  for (int i = 0; i < samples; ++i)
  {
    vec3 H = giSampleVisibleGGX(giSample2D(uint(i), 0x51ed270bu), lobe.V, lobe.width);
    vec3 L = reflect(-lobe.V, H);
    float a2 = lobe.width * lobe.width;
    float masking = 2.0 * cosine / (cosine + sqrt(a2 + (1.0 - a2) * cosine * cosine));
    float weight = L.z > 0.0
      ? 4.0 * cosine * L.z * giVisibilitySmith(cosine, L.z, lobe.roughness) / masking
      : 0.0;
    float edge = pow(1.0 - clamp(dot(H, L), 0.0, 1.0), 5.0);
    mean += weight * L;
    shares += weight * vec2(1.0 - edge, edge);
  }
  shares /= float(samples);
  lobe.norm = shares.x + shares.y;
  vec3 Z = normalize(vec3(mean.x, 0.0, mean.z));
  lobe.frame = mat3(vec3(Z.z, 0.0, -Z.x), vec3(0.0, 1.0, 0.0), Z);
  float start = log(min(2.0 * lobe.width, 1.0));
  mat3 toCosine = inverse(highlightMatrix(lobe, fitWidths(lobe, vec3(start, start, 0.0))));
  vec4 entries[2];
  entries[0] = vec4(toCosine[2][0], toCosine[1][1], toCosine[0][2], toCosine[2][2]) / toCosine[0][0];
  entries[1] = vec4(shares, 0.0, 0.0);
  return entries;
}
