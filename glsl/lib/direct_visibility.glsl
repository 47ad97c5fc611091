// Share of a light that reaches a pixel's surface. channel: LightData::Kind.y. Needs sampler2DArray directVisibility. Variant:
// GI_DIRECT_VISIBILITY (some lights cast shadows).
float giDirectVisibility(ivec2 pixel, int channel)
{
#ifdef GI_DIRECT_VISIBILITY
  if (channel >= 0)
  {
    return texelFetch(directVisibility, ivec3(pixel, channel / 4), 0)[channel & 3];
  }
#endif
  return 1.0;
}
