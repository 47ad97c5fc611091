// Factor of all radiance. Variant: GI_AUTO (the part that measure.comp has found is in a texture).
uniform float scale; // by the fixed exposure
#ifdef GI_AUTO
layout(binding = 3) uniform sampler2D exposureTexture;
#endif

float exposureScale()
{
#ifdef GI_AUTO
  return scale * texelFetch(exposureTexture, ivec2(0), 0).r;
#else
  return scale;
#endif
}
