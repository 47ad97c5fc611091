// What of a light reaches a surface: the biases, the map that shows it, and the filter. Needs
// shadow_maps/filter.glsl. Variants: GI_CASCADES (a light with cascades), and those of the filter.
uniform vec3 bias; // constant, slope, normal; all in texels
uniform bool receiverPlane; // whether depths are compared with the facet's plane

// Steeper than 88 degrees, a plane's depths at the next texel say nothing.
const float GiSmallestCosine = 0.03;
// And of facets around: what stands on a steep surface is not taken for the next facet.
const float GiSmallestAround = 0.15;
// Tangent beyond which the slope's bias grows no more, or light shines through behind steep facets.
const float GiSteepest = 12.0;
// Share of a cascade over which the next one takes over.
const float GiOverlap = 0.1;
// Cosine to the light below which facets shade each other.
const float GiGrazing = 0.3;

struct GiShadowed
{
  vec3 P;
  vec3 N;      // of shading
  vec3 facet;  // of the flat piece
  float bulge; // by how much the round surface that N stands for is above it, in world units
  float error; // of P, in world units
};

// A facet's normal F, turned so that its cosine to the light is the least one or more.
vec3 giFaced(vec3 F, vec3 N, vec3 L, float least)
{
  float cosine = dot(F, L);
  vec3 side = F - cosine * L;
  return cosine < least ? least * L + sqrt(1.0 - least * least) * normalize(side + 1e-5 * N) : F;
}

GiReceiver giReceiverOf(ShadowLightData lamp, GiShadowed surface, vec3 L, float distance, int map)
{
  vec3 F = giFaced(surface.facet, surface.N, L, GiSmallestCosine);
  float cosine = dot(F, L);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  float texel = shadowMaps[map].Scale.x * distance;
  GiReceiver receiver;
  // Along the normal: Holbert 2011, Saying "Goodbye" to Shadow Acne (Game Developers Conference).
  receiver.P = surface.P + L * (texel * (bias.x + bias.y * min(sine / cosine, GiSteepest)) + surface.error) +
    F * (texel * bias.z * sine);
  receiver.texel = texel;
  // One row's height at unit distance, or at any in parallel projection.
  receiver.pixel = 2.0 * abs(view.ClipToView[1][1]) / view.Viewport.w *
    (view.Scene.y > 0.5 ? 1.0 : abs(surface.P.z));
  // Two axes across the light, slid along it into the plane; left where they are, the plane is one
  // across the light, of the point's own depth.
  vec3 U = normalize(abs(L.z) < 0.9 ? cross(L, vec3(0.0, 0.0, 1.0)) : cross(L, vec3(0.0, 1.0, 0.0)));
  vec3 V = cross(L, U);
  vec2 slide = receiverPlane ? vec2(dot(F, U), dot(F, V)) / cosine : vec2(0.0);
  receiver.U = U - L * slide.x;
  receiver.V = V - L * slide.y;
  receiver.L = L;
  // The shading normal is the mean of the facets around: beyond the nearest edge they lean as far to its
  // other side.
  vec3 around = giFaced(reflect(-surface.facet, surface.N), surface.N, L, GiSmallestAround);
  receiver.rise = receiverPlane ? slide - vec2(dot(around, U), dot(around, V)) / dot(around, L) : vec2(0.0);
  return receiver;
}

float giReached(ShadowLightData lamp, GiShadowed surface, float angle)
{
  bool positional = lamp.Position.w > 0.5;
  vec3 fromLight = surface.P - lamp.Position.xyz;
  float distance = positional ? length(fromLight) : 1.0;
  vec3 L = positional ? -fromLight / distance : -lamp.Direction.xyz;
  float cosine = dot(surface.N, L);
  if (cosine <= 0.0)
  {
    return 0.0;
  }
  // Where light grazes, it arrives on the round surface, as rays/surface.glsl has it for rays.
  float share = surface.bulge > 0.0 ? clamp(2.0 - 2.0 * cosine / GiGrazing, 0.0, 1.0) : 0.0;
  float lift = share * surface.bulge;
  if (dot(surface.facet, L) <= 0.0 && lift <= surface.error)
  {
    return 0.0;
  }
  surface.P += lift * surface.N;
  int map = lamp.Maps.x;
#ifdef GI_CUBE
  map += lamp.Maps.z == GI_SHADOW_CUBE ? giFaceOf(fromLight) : 0;
#endif
#ifdef GI_CASCADES
  float next = 0.0; // share of the next cascade
  if (lamp.Maps.z == GI_SHADOW_CASCADES)
  {
    // By the distance from the eye, which turning the camera does not change.
    float far = length(surface.P);
    int cascade = 0;
    while (cascade < lamp.Maps.y - 1 && far > lamp.Ends[cascade])
    {
      ++cascade;
    }
    map += cascade;
    float end = lamp.Ends[cascade];
    next = cascade < lamp.Maps.y - 1 ? clamp((far / end - 1.0) / GiOverlap + 1.0, 0.0, 1.0) : 0.0;
  }
  float open = 0.0;
  int parts = next > 0.0 ? 2 : 1;
  for (int part = 0; part < parts; ++part)
  {
    GiReceiver receiver = giReceiverOf(lamp, surface, L, distance, map + part);
    open += (part == 0 ? 1.0 - next : next) * giReaching(lamp, receiver, map + part, angle);
  }
  return open;
#else
  return giReaching(lamp, giReceiverOf(lamp, surface, L, distance, map), map, angle);
#endif
}
