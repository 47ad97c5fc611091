// Visibility of a light at a surface: applies the biases, selects the map, and filters. Needs
// shadow_maps/filter.glsl. Variants: GI_CASCADES (some light has cascades), and those of the filter.
uniform vec3 bias; // constant, slope, normal; all in texels
uniform bool receiverPlane; // whether depths are compared with the facet's plane

// Cosine of a facet to the light, at least. For planes steeper than 88 degrees the depth at the next texel is
// meaningless.
const float GiSmallestCosine = 0.03;
// The same for surrounding facets, so that occluders on a steep surface are not taken for its next facet.
const float GiSmallestAround = 0.15;
// Tangent at which the slope bias stops growing. With more, light would leak behind steep facets.
const float GiSteepest = 12.0;
// Share of a cascade's range over which it is blended with the next one.
const float GiOverlap = 0.1;
// Cosine to the light below which facets shadow each other.
const float GiGrazing = 0.3;

struct GiShadowed
{
  vec3 P;
  vec3 N;      // shading normal
  vec3 facet;  // normal of the flat facet
  float bulge; // height of the curved surface that N represents over the facet, in world units
  float error; // error of P, in world units
};

// Turns a facet's normal F toward the light until its cosine to the light is at least `least`.
vec3 giTurnedToLight(vec3 F, vec3 N, vec3 L, float least)
{
  float cosine = dot(F, L);
  vec3 side = F - cosine * L;
  return cosine < least ? least * L + sqrt(1.0 - least * least) * normalize(side + 1e-5 * N) : F;
}

GiReceiver giMakeReceiver(ShadowLightData light, GiShadowed surface, vec3 L, float distance, int map)
{
  vec3 F = giTurnedToLight(surface.facet, surface.N, L, GiSmallestCosine);
  float cosine = dot(F, L);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  float texel = shadowMaps[map].Scale.x * distance;
  GiReceiver receiver;
  // Offset along the normal: Holbert 2011, Saying "Goodbye" to Shadow Acne (Game Developers Conference).
  receiver.P = surface.P + L * (texel * (bias.x + bias.y * min(sine / cosine, GiSteepest)) + surface.error) +
    F * (texel * bias.z * sine);
  receiver.texel = texel;
  // Height of a row of pixels at unit distance, or at any distance in a parallel projection.
  receiver.pixel = 2.0 * abs(view.ClipToView[1][1]) / view.Viewport.w *
    (view.Scene.y > 0.5 ? 1.0 : abs(surface.P.z));
  // Two axes across the light, slid along it into the receiver's plane. Without the slide, depths are compared with the
  // point's own depth.
  vec3 U = normalize(abs(L.z) < 0.9 ? cross(L, vec3(0.0, 0.0, 1.0)) : cross(L, vec3(0.0, 1.0, 0.0)));
  vec3 V = cross(L, U);
  vec2 slide = receiverPlane ? vec2(dot(F, U), dot(F, V)) / cosine : vec2(0.0);
  receiver.U = U - L * slide.x;
  receiver.V = V - L * slide.y;
  receiver.L = L;
#ifdef GI_FLAT
  receiver.across = light.Size.y > float(GI_OUTLINE_ROUND) + 0.5
    ? mat2(dot(light.Side.xyz, U), dot(light.Side.xyz, V), dot(light.Up.xyz, U), dot(light.Up.xyz, V))
    : mat2(1.0);
#endif
  // The shading normal is the mean of the surrounding facets. The facet beyond the nearest edge thus leans as far to
  // its other side.
  vec3 around = giTurnedToLight(reflect(-surface.facet, surface.N), surface.N, L, GiSmallestAround);
  receiver.rise = receiverPlane ? slide - vec2(dot(around, U), dot(around, V)) / dot(around, L) : vec2(0.0);
  return receiver;
}

float giShadowVisibility(ShadowLightData light, GiShadowed surface, float angle)
{
  bool positional = light.Position.w > 0.5;
  vec3 fromLight = surface.P - light.Position.xyz;
  float distance = positional ? length(fromLight) : 1.0;
  vec3 L = positional ? -fromLight / distance : -light.Direction.xyz;
  float cosine = dot(surface.N, L);
  if (cosine <= 0.0)
  {
    return 0.0;
  }
  // At grazing angles light arrives on the curved surface, as in rays/surface.glsl.
  float share = surface.bulge > 0.0 ? clamp(2.0 - 2.0 * cosine / GiGrazing, 0.0, 1.0) : 0.0;
  float lift = share * surface.bulge;
  if (dot(surface.facet, L) <= 0.0 && lift <= surface.error)
  {
    return 0.0;
  }
  surface.P += lift * surface.N;
  int map = light.Maps.x;
#ifdef GI_CUBE
  map += light.Maps.z == GI_SHADOW_CUBE ? giFaceOf(fromLight) : 0;
#endif
#ifdef GI_CASCADES
  float next = 0.0; // share of the next cascade
  if (light.Maps.z == GI_SHADOW_CASCADES)
  {
    // Select by the distance from the eye, which does not change when the camera turns.
    float far = length(surface.P);
    int cascade = 0;
    while (cascade < light.Maps.y - 1 && far > light.Ends[cascade])
    {
      ++cascade;
    }
    map += cascade;
    float end = light.Ends[cascade];
    next = cascade < light.Maps.y - 1 ? clamp((far / end - 1.0) / GiOverlap + 1.0, 0.0, 1.0) : 0.0;
  }
  float open = 0.0;
  int parts = next > 0.0 ? 2 : 1;
  for (int part = 0; part < parts; ++part)
  {
    GiReceiver receiver = giMakeReceiver(light, surface, L, distance, map + part);
    open += (part == 0 ? 1.0 - next : next) * giMapVisibility(light, receiver, map + part, angle);
  }
  return open;
#else
  return giMapVisibility(light, giMakeReceiver(light, surface, L, distance, map), map, angle);
#endif
}
