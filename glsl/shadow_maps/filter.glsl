// Visibility of a light, averaged over a disc in the receiver's plane. Needs
// shadow_maps/sheet.glsl and lib/noise.glsl. Variants (software renderers also execute branches that are
// not taken): GI_CUBE (some light has six maps), GI_SOFT (some light has a size), GI_FLAT (some light is a disc or a
// rectangle).
uniform int filterSamples;
uniform int blockerSamples;
uniform int penumbraSamples;
uniform float filterRadius; // in texels
uniform float pixelRadius;  // lower bound of the radius in pixels

// Index of the cube face that a direction from the light falls into, in the order +x -x +y -y +z -z.
int giFaceOf(vec3 fromLight)
{
  vec3 d = mat3(view.ViewToWorld) * fromLight;
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z)
  {
    return d.x > 0.0 ? 0 : 1;
  }
  if (a.y >= a.z)
  {
    return d.y > 0.0 ? 2 : 3;
  }
  return d.z > 0.0 ? 4 : 5;
}

struct GiReceiver
{
  vec3 P;         // offset by the bias
  vec3 U;         // two vectors in the plane, each one unit long across the light
  vec3 V;
  vec3 L;         // toward the light
  vec2 rise;      // additional rise of U and V toward the light in the plane of the surrounding facets
  float texel;    // width of a shadow-map texel at P, in world units
  float pixel;    // width of a pixel at P, in world units
#ifdef GI_FLAT
  mat2 across;    // a flat light's outline across the direction to it, in units of its longer side
#endif
};

// Atlas position of a point of the disc. On a cube it may lie on another face, whose sheet is then returned.
vec3 giTap(ShadowLightData light, GiReceiver receiver, vec2 offset, inout GiSheet sheet)
{
  vec3 at = giAtlasPosition(sheet, offset);
#if defined(GI_CUBE) && defined(GI_SOFT)
  if (light.Maps.z == GI_SHADOW_CUBE && giIsOutside(sheet, at))
  {
    vec3 Q = receiver.P + offset.x * receiver.U + offset.y * receiver.V;
    Q += receiver.L * max(dot(offset, receiver.rise), 0.0);
    sheet = giSheet(light.Maps.x + giFaceOf(Q - light.Position.xyz), Q, receiver.U, receiver.V, receiver.L,
      receiver.rise);
    at = sheet.middle;
  }
#endif
  return at;
}

// A point of the kernel, in units of its radius, for a point of the unit disc. The kernel of a flat light has its
// outline, but is at least `least` wide.
vec2 giKernel(ShadowLightData light, GiReceiver receiver, vec2 p, float least)
{
#ifdef GI_FLAT
  if (light.Size.y > float(GI_OUTLINE_ELLIPSE) + 0.5)
  {
    // The disc's radii become the radii of squares: Shirley and Chiu 1997, "A Low Distortion Map Between Disk and
    // Square", inverted.
    vec2 a = abs(p);
    float r = length(p);
    float turn = 4.0 / 3.14159265 * atan(min(a.x, a.y), max(max(a.x, a.y), 1e-9));
    p = sign(p) * (a.x > a.y ? vec2(r, r * turn) : vec2(r * turn, r));
  }
  vec2 side = receiver.across[0];
  vec2 up = receiver.across[1];
  return p.x * side * max(1.0, least * inversesqrt(max(dot(side, side), 1e-12))) +
    p.y * up * max(1.0, least * inversesqrt(max(dot(up, up), 1e-12)));
#else
  return p;
#endif
}

float giFiltered(ShadowLightData light, GiReceiver receiver, GiSheet sheet, float radius, float least, int samples,
  float angle)
{
  float sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    GiSheet tapSheet = sheet;
    vec3 at = giTap(light, receiver,
      radius * giKernel(light, receiver, giVogelDisc(i, samples, angle), least), tapSheet);
    sum += giLitShare(tapSheet, at);
  }
  return sum / float(samples);
}

#ifdef GI_SOFT
// Width of the penumbra on a receiver. depths: of the occluder and of the receiver in the map.
float giPenumbraWidth(ShadowLightData light, int map, vec2 depths)
{
  vec2 range = shadowMaps[map].Scale.yz;
  if (light.Position.w < 0.5)
  {
    return light.Size.x * (depths.y - depths.x) * (range.y - range.x);
  }
  vec2 distances = range.x * range.y / mix(vec2(range.y), vec2(range.x), depths);
  return light.Size.x * (distances.y / distances.x - 1.0);
}

// Percentage-closer soft shadows (Fernando 2005): the mean penumbra width of the possible blockers, negative if there
// are none. Samples are denser toward the middle, so that blockers near the receiver are found as well as distant ones.
// A blocker counts only if its penumbra is wider than its distance from the middle.
float giMeanPenumbra(ShadowLightData light, GiReceiver receiver, GiSheet sheet, float angle)
{
  vec3 center = giAtlasPosition(sheet, vec2(0.0));
  float maximumWidth = giPenumbraWidth(light, sheet.map, vec2(0.0, center.z));
  // At most half the map: farther away it says little about blockers in between.
  maximumWidth = min(maximumWidth,
    0.5 * receiver.texel * (sheet.area.z - sheet.area.x) * float(textureSize(atlas, 0).x));
  float sum = 0.0;
  float blockers = 0.0;
  for (int i = 0; i < blockerSamples; ++i)
  {
    float radius = maximumWidth * (float(i) + 0.5) / float(blockerSamples);
    float turn = float(i) * 2.39996323 + angle;
    GiSheet tapSheet = sheet;
    vec3 at = giTap(light, receiver, radius * giKernel(light, receiver, vec2(cos(turn), sin(turn)), 0.0), tapSheet);
    vec2 depths = giMapAndPlaneDepth(tapSheet, at);
    float spread = depths.x < depths.y ? giPenumbraWidth(light, tapSheet.map, depths) : 0.0;
    if (spread > radius)
    {
      sum += spread;
      blockers += 1.0;
    }
  }
  return blockers > 0.0 ? min(sum / blockers, maximumWidth) : -1.0;
}
#endif

float giMapVisibility(ShadowLightData light, GiReceiver receiver, int map, float angle)
{
  GiSheet sheet = giSheet(map, receiver.P, receiver.U, receiver.V, receiver.L, receiver.rise);
  float radius = max(filterRadius * receiver.texel, pixelRadius * receiver.pixel);
  int samples = filterSamples;
  float least = 1.0;
#ifdef GI_SOFT
  float penumbra = light.Size.x > 0.0 ? giMeanPenumbra(light, receiver, sheet, angle) : -1.0;
  if (penumbra > radius)
  {
    least = radius / penumbra;
    radius = penumbra;
    samples = penumbraSamples;
  }
#endif
  return giFiltered(light, receiver, sheet, radius, least, samples, angle);
}
