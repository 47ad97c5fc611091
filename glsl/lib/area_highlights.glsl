// Highlights of spheres, discs and rectangles. Needs lib/area_lights.glsl, lib/phong.glsl.

// Number of sides of the polygons that stand for discs and spheres, and the factor by which their corners are farther
// out than the rim, so that the area is the same: (2 pi / (n sin(2 pi / n)))^(1/2).
const int GI_ROUND_SIDES = 12;
const float GI_ROUND_REACH = 1.02330;

// An area light as seen from a point, in units of the distance.
struct GiPatch
{
  vec3 c; // centre
  vec3 u; // to its side
  vec3 v;
  bool round;
};

GiPatch giPatch(LightData light, vec3 position)
{
  vec3 path = light.Position.xyz - position;
  float square = max(dot(path, path), 1e-30);
  if (light.Side.w < float(GI_SHAPE_DISC) - 0.5)
  {
    // The disc that fills the same cone as the sphere.
    vec3 c = path * inversesqrt(square);
    mat3 basis = giBasis(-c);
    float share = min(light.Up.w * light.Up.w / square, 0.9999);
    float radius = sqrt(share / (1.0 - share));
    return GiPatch(c, radius * basis[0], radius * basis[1], true);
  }
  float scale = inversesqrt(square + light.Attenuation.w);
  return GiPatch(scale * path, scale * light.Side.xyz, scale * light.Up.xyz,
    light.Side.w < float(GI_SHAPE_RECTANGLE) - 0.5);
}

vec3 giCorner(GiPatch area, int i)
{
  if (area.round)
  {
    float angle = 6.28318530717959 / float(GI_ROUND_SIDES) * float(i);
    return area.c + GI_ROUND_REACH * (cos(angle) * area.u + sin(angle) * area.v);
  }
  int corner = i & 3;
  return area.c + (corner == 0 || corner == 3 ? area.u : -area.u) + (corner < 2 ? area.v : -area.v);
}

// Integrals along an arc of the powers of z that the moment of odd order n needs (x), and of n + 2 (y).
vec2 giArcMoments(vec3 a, vec3 b, int n)
{
  vec3 across = cross(a, b);
  float sine = length(across);
  if (sine < 1e-6)
  {
    return vec2(0.0);
  }
  float cosine = dot(a, b);
  float slope = (b.z - a.z * cosine) / sine;
  float c2 = a.z * a.z + slope * slope;
  float from = -atan(slope, a.z);
  float to = from + atan(sine, cosine);
  vec2 s = vec2(sin(from), sin(to));
  vec2 c = vec2(cos(from), cos(to));
  vec2 power = c;            // of the cosine, i + 1
  float integral = to - from; // of the cosine to the power i
  float scale = 1.0;
  vec2 sums = vec2(0.0);
  for (int i = 0; i <= n + 1; i += 2)
  {
    sums.x = sums.y;
    sums.y += scale * integral;
    integral = (power.y * s.y - power.x * s.x + float(i + 1) * integral) / float(i + 2);
    power *= c * c;
    scale *= c2;
  }
  return sums * (across.z / sine);
}

// Integral of the cosine to a direction, to a power of at least 1, over the solid angle of a patch: Arvo 1995,
// "Applications of Irradiance Tensors to the Simulation of Non-Lambertian Phenomena". Exact for odd powers; their
// logarithms are interpolated. toLobe: to coordinates whose z is that direction.
float giPatchPower(GiPatch area, mat3 toLobe, float power)
{
  int n = 2 * int(max(power - 1.0, 0.0) * 0.5) + 1;
  int sides = area.round ? GI_ROUND_SIDES : 4;
  vec2 sums = vec2(0.0);
  vec3 enter = vec3(0.0);
  vec3 leave = vec3(0.0);
  vec3 next = toLobe * giCorner(area, 0);
  for (int i = 1; i <= sides; ++i)
  {
    vec3 a = next;
    next = toLobe * giCorner(area, i);
    vec3 b = next;
    if (giClipEdge(a, b, enter, leave))
    {
      sums += giArcMoments(giUnit(a), giUnit(b), n);
    }
  }
  // Along the horizon only the power 0 counts.
  sums += giArc(leave, enter).z;
  vec2 moments = max(sums, 1e-30);
  float share = 0.5 * (power - float(n));
  return exp(mix(log(moments.x), log(moments.y), share)) / (power + 1.0);
}

// Share of the light of a lobe that comes from a patch: the lobe is a cosine's in linearly transformed directions
// (Heitz, Dupuy, Hill and Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines").
float giPatchShare(GiPatch area, mat3 toCosine)
{
  int sides = area.round ? GI_ROUND_SIDES : 4;
  GiOutline outline = GiOutline(vec3(0.0), vec3(0.0), vec3(0.0));
  vec3 next = toCosine * giCorner(area, 0);
  for (int i = 1; i <= sides; ++i)
  {
    vec3 a = next;
    next = toCosine * giCorner(area, i);
    giAddEdge(outline, a, next);
  }
  return max(giEnclosed(outline).z, 0.0) / GI_PI;
}

// Phong highlight of a light as a share of its colour, without attenuation.
float giAreaPhong(LightData light, vec3 position, vec3 N, vec3 V, float power)
{
  vec3 L = normalize(light.Position.xyz - position);
  float strength;
  if (giIsSmall(light, position, strength))
  {
    return max(strength, 0.0) * giPhongSpecular(N, -L, V, power);
  }
  mat3 toLobe = transpose(giBasis(reflect(-V, N)));
  return giAreaBrightness(light, position) * giPatchPower(giPatch(light, position), toLobe, power);
}

#ifdef GI_EXTENDED
layout(binding = 11) uniform sampler2DArray highlightTable; // see direct_light/highlight_table.comp

// Reflection of a light by the metallic-roughness model, without attenuation. facing: from giAreaFacing(). The diffuse
// part has Fresnel's factor of the light's centre. boost, diffuseShare: as in giReflectPBR().
vec3 giAreaPBR(LightData light, vec3 position, vec3 N, vec3 V, float facing, vec3 albedo, float metallic,
  float roughness, vec3 f0, vec3 f90, vec3 boost, float diffuseShare)
{
  vec3 L = normalize(light.Position.xyz - position);
  float strength;
  if (giIsSmall(light, position, strength))
  {
    return max(strength, 0.0) * giReflectPBR(N, V, L, albedo, metallic, roughness, f0, f90, boost, diffuseShare);
  }
  float cosine = clamp(dot(N, V), 0.0, 1.0);
  vec2 size = vec2(textureSize(highlightTable, 0).xy);
  vec2 place = (vec2(cosine, clamp(roughness, 0.0, 1.0)) * (size - 1.0) + 0.5) / size;
  vec4 entries = textureLod(highlightTable, vec3(place, 0.0), 0.0);
  vec2 shares = textureLod(highlightTable, vec3(place, 1.0), 0.0).xy;
  vec3 aside = V - dot(N, V) * N;
  vec3 X = dot(aside, aside) > 1e-8 ? normalize(aside) : giBasis(N)[0];
  mat3 toLocal = transpose(mat3(X, cross(N, X), N));
  mat3 toCosine = mat3(vec3(1.0, 0.0, entries.z), vec3(0.0, entries.y, 0.0), vec3(entries.x, 0.0, entries.w));
  float share = giPatchShare(giPatch(light, position), toCosine * toLocal);
  vec3 specular = giAreaBrightness(light, position) * share * (f0 * shares.x + f90 * shares.y) * boost;
  vec3 F = giFresnelSchlick(f0, f90, clamp(dot(normalize(V + L), L), 0.0, 1.0));
  return specular + diffuseShare * (1.0 - metallic) * (1.0 - F) * albedo / GI_PI * facing;
}
#endif
