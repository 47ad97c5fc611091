// What of a light reaches a surface: the biases, the map that shows it, and the filter. Needs
// shadow_maps/filter.glsl. Variants: GI_CASCADES (a light with cascades), and those of the filter.
uniform vec3 bias; // constant, slope, normal; all in texels
uniform bool receiverPlane; // whether depths are compared with the facet's plane

// Steeper than 88 degrees, a plane's depths at the next texel say nothing.
const float GiSmallestCosine = 0.03;
// Share of a cascade over which the next one takes over.
const float GiOverlap = 0.1;

struct GiShadowed
{
  vec3 P;
  vec3 N;      // of shading
  vec3 facet;  // of the flat piece
  float error; // of P, in world units
};

GiReceiver giReceiverOf(ShadowLightData lamp, GiShadowed surface, vec3 L, float distance, int map)
{
  vec3 F = surface.facet;
  float cosine = dot(F, L);
  if (cosine < GiSmallestCosine)
  {
    vec3 side = F - cosine * L;
    F = GiSmallestCosine * L + sqrt(1.0 - GiSmallestCosine * GiSmallestCosine) * normalize(side + 1e-5 * surface.N);
    cosine = GiSmallestCosine;
  }
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  float texel = shadowMaps[map].Scale.x * distance;
  GiReceiver receiver;
  // Along the normal: Holbert 2011, Saying "Goodbye" to Shadow Acne (Game Developers Conference).
  receiver.P = surface.P + L * (texel * (bias.x + bias.y * sine / cosine) + surface.error) +
    F * (texel * bias.z * sine);
  receiver.texel = texel;
  // One row's height at unit distance, or at any in parallel projection.
  receiver.pixel = 2.0 * abs(view.ClipToView[1][1]) / view.Viewport.w *
    (view.Scene.y > 0.5 ? 1.0 : abs(surface.P.z));
  // Two axes across the light, slid along it into the plane; left where they are, the plane is one
  // across the light, of the point's own depth.
  vec3 U = normalize(abs(L.z) < 0.9 ? cross(L, vec3(0.0, 0.0, 1.0)) : cross(L, vec3(0.0, 1.0, 0.0)));
  vec3 V = cross(L, U);
  receiver.U = receiverPlane ? U - L * (dot(F, U) / cosine) : U;
  receiver.V = receiverPlane ? V - L * (dot(F, V) / cosine) : V;
  return receiver;
}

float giReached(ShadowLightData lamp, GiShadowed surface, float angle)
{
  bool positional = lamp.Position.w > 0.5;
  vec3 fromLight = surface.P - lamp.Position.xyz;
  float distance = positional ? length(fromLight) : 1.0;
  vec3 L = positional ? -fromLight / distance : -lamp.Direction.xyz;
  if (dot(surface.N, L) <= 0.0)
  {
    return 0.0;
  }
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
