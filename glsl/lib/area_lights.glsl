// Unshadowed light of spheres, discs and rectangles. Integrals of a cosine over the part of a shape that is above the
// horizon, for a receiver at the origin whose normal is z. Needs shared/light.h, lib/pbr.glsl,
// lib/sampling.glsl.
// Below this solid angle a light is a point: the integrals would lose their digits.
const float GI_AREA_SMALLEST = 1e-3;

bool giHasArea(LightData light)
{
  return light.Side.w > float(GI_SHAPE_SPHERE) - 0.5;
}

// A convex outline, added up edge by edge, and clipped to the horizon.
struct GiOutline
{
  vec3 sum;   // twice the vector irradiance
  vec3 enter; // where the outline rises above the horizon
  vec3 leave;
};

// Vector between two unit vectors whose direction is that of their cross product, and whose length is their angle.
vec3 giArc(vec3 a, vec3 b)
{
  vec3 across = cross(a, b);
  float sine = length(across);
  return across * (sine > 1e-5 ? atan(sine, dot(a, b)) / sine : 1.0);
}

vec3 giUnit(vec3 v)
{
  return v * inversesqrt(max(dot(v, v), 1e-37));
}

// Clips an edge to the horizon. Returns false if nothing is left.
bool giClipEdge(inout vec3 a, inout vec3 b, inout vec3 enter, inout vec3 leave)
{
  if (a.z <= 0.0 && b.z <= 0.0)
  {
    return false;
  }
  if (a.z <= 0.0)
  {
    a = giUnit(a * b.z - b * a.z);
    enter = a;
  }
  else if (b.z <= 0.0)
  {
    b = giUnit(b * a.z - a * b.z);
    leave = b;
  }
  return true;
}

void giAddEdge(inout GiOutline outline, vec3 a, vec3 b)
{
  if (giClipEdge(a, b, outline.enter, outline.leave))
  {
    outline.sum += giArc(giUnit(a), giUnit(b));
  }
}

// Integral of the unit vectors over the solid angle of the outline, times z (Lambert 1760, Photometria, for polygons;
// as a vector: Baum, Rushmeier and Winget 1989, "Improving Radiosity Solutions Through the Use of Analytically
// Determined Form-Factors"): its z is the irradiance for unit radiance.
vec3 giEnclosed(GiOutline outline)
{
  return 0.5 * (outline.sum + giArc(outline.leave, outline.enter));
}

// A rectangle. c: its centre, u and v: to its sides.
float giRectangleCosine(vec3 c, vec3 u, vec3 v)
{
  GiOutline outline = GiOutline(vec3(0.0), vec3(0.0), vec3(0.0));
  giAddEdge(outline, c + u + v, c - u + v);
  giAddEdge(outline, c - u + v, c - u - v);
  giAddEdge(outline, c - u - v, c + u - v);
  giAddEdge(outline, c + u - v, c + u + v);
  return giEnclosed(outline).z;
}

// Antiderivatives of 1, cos and sin over a + b cos, between two angles of at most a turn. The second and third are
// series where b is small.
vec3 giArcIntegrals(float from, float to, float a, float b)
{
  float root = sqrt(max((a - b) * (a + b), 1e-12 * a * a));
  vec2 half0 = vec2(sqrt(max(a - b, 0.0)) * sin(0.5 * from), sqrt(a + b) * cos(0.5 * from));
  vec2 half1 = vec2(sqrt(max(a - b, 0.0)) * sin(0.5 * to), sqrt(a + b) * cos(0.5 * to));
  float even = 2.0 / root * (atan(half1.x, half1.y) - atan(half0.x, half0.y));
  float c0 = cos(from);
  float c1 = cos(to);
  if (b > 0.02 * a)
  {
    return vec3(even, (to - from - a * even) / b, log((a + b * c0) / (a + b * c1)) / b);
  }
  float e = b / a;
  float s0 = sin(from);
  float s1 = sin(to);
  float ofCosine = s1 - s0 - 0.5 * e * (to - from + s1 * c1 - s0 * c0) +
    e * e * (s1 - s0 - (s1 * s1 * s1 - s0 * s0 * s0) / 3.0);
  float ofSine = c0 - c1 + 0.5 * e * (c1 * c1 - c0 * c0) - e * e / 3.0 * (c1 * c1 * c1 - c0 * c0 * c0);
  return vec3(even, ofCosine / a, ofSine / a);
}

// A disc, whose axis shines toward the receiver; u and v are as long as its radius. Stokes' theorem for the circle, as
// for the edges of a polygon, and for the line along which the horizon cuts it.
float giDiscCosine(vec3 c, vec3 u, vec3 v)
{
  // Turn u toward the farthest point, so that the squared distance is a + b cos.
  vec2 lean = vec2(dot(c, u), dot(c, v));
  float m = length(lean);
  vec2 turn = m > 0.0 ? lean / m : vec2(1.0, 0.0);
  vec3 far = turn.x * u + turn.y * v;
  vec3 aside = -turn.y * u + turn.x * v;
  float a = dot(c, c) + dot(u, u);
  float b = 2.0 * m;
  vec3 factors = vec3(cross(far, aside).z, cross(c, aside).z, -cross(c, far).z);
  float slope = length(vec2(far.z, aside.z));
  if (c.z <= -slope)
  {
    return 0.0;
  }
  if (c.z >= slope)
  {
    float root = sqrt(max((a - b) * (a + b), 1e-12 * a * a));
    return GI_PI / root * (factors.x - factors.y * b / (a + root));
  }
  float middle = atan(aside.z, far.z);
  float reach = acos(clamp(-c.z / slope, -1.0, 1.0));
  float from = middle - reach;
  float to = middle + reach;
  vec3 start = c + cos(from) * far + sin(from) * aside;
  vec3 end = c + cos(to) * far + sin(to) * aside;
  start.z = 0.0;
  end.z = 0.0;
  return 0.5 * (dot(factors, giArcIntegrals(from, to, a, b)) + giArc(giUnit(end), giUnit(start)).z);
}

// A sphere of radius r: Snyder 1996, "Area Light Sources for Real-Time Graphics".
float giSphereCosine(vec3 c, float r)
{
  float h2 = max(dot(c, c) / (r * r), 1.0001);
  float cosine = c.z * inversesqrt(max(dot(c, c), 1e-37));
  float k = 1.0 - h2 * cosine * cosine;
  if (k <= 0.0)
  {
    return GI_PI * max(cosine, 0.0) / h2;
  }
  float behind = sqrt(h2 - 1.0);
  float part = cosine * acos(clamp(-cosine * behind * inversesqrt(max(1.0 - cosine * cosine, 1e-12)), -1.0, 1.0)) -
    sqrt(k) * behind;
  return max(part / h2 + atan(sqrt(k), behind), 0.0);
}

// Radiance of a light as a share of its colour times pi, without attenuation; see vtkGILightShape.
float giAreaBrightness(LightData light, vec3 position)
{
  vec3 path = position - light.Position.xyz;
  float square = dot(path, path);
  return light.Side.w > float(GI_SHAPE_SPHERE) + 0.5
    ? (square + light.Attenuation.w) / (GI_PI * light.Attenuation.w)
    : max(square / (light.Up.w * light.Up.w), 1.0) / GI_PI;
}

// Whether the whole of a light has one direction from a position, and what share of a point light's strength it has
// there.
bool giIsSmall(LightData light, vec3 position, out float strength)
{
  vec3 path = position - light.Position.xyz;
  float square = dot(path, path);
  strength = 1.0;
  if (light.Side.w < float(GI_SHAPE_DISC) - 0.5)
  {
    return GI_PI * light.Up.w * light.Up.w < GI_AREA_SMALLEST * square;
  }
  strength = (1.0 + light.Attenuation.w / square) * dot(path, light.Direction.xyz) * inversesqrt(square);
  return strength <= 0.0 || GI_PI * light.Attenuation.w < GI_AREA_SMALLEST * square;
}

// Irradiance of a sphere, disc or rectangle as a share of its colour times pi, without attenuation.
float giAreaFacing(LightData light, vec3 position, vec3 N)
{
  vec3 path = light.Position.xyz - position;
  float square = max(dot(path, path), 1e-30);
  mat3 toLocal = transpose(giBasis(N));
  vec3 c = toLocal * path;
  float strength;
  if (giIsSmall(light, position, strength))
  {
    return max(strength, 0.0) * max(c.z, 0.0) * inversesqrt(square);
  }
  float brightness = giAreaBrightness(light, position);
  if (light.Side.w < float(GI_SHAPE_DISC) - 0.5)
  {
    return brightness * giSphereCosine(c, light.Up.w);
  }
  // Lengths relative to the distance, so that squares stay finite.
  float scale = inversesqrt(square + light.Attenuation.w);
  vec3 u = scale * (toLocal * light.Side.xyz);
  vec3 v = scale * (toLocal * light.Up.xyz);
  c *= scale;
  float cosine = light.Side.w < float(GI_SHAPE_RECTANGLE) - 0.5 ? giDiscCosine(c, u, v) : giRectangleCosine(c, u, v);
  return brightness * max(cosine, 0.0);
}
