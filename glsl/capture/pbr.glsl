#ifdef GI_FACET
#include "capture/facet.glsl"
#endif
#include "capture/clip.glsl"
  if (gl_FragData[0].a < giOpaque)
  {
#include "capture/as_drawn.glsl"
  }
  else
  {
    float giOcclusion = mix(1.0, ao, aoStrengthUniform);
    gl_FragData[0] = vec4(albedo, 1.0);
    gl_FragData[1] = vec4(giEncodeOctahedral(normalVCVSOutput), float(giMaterial) / 65535.0, 1.0);
    gl_FragData[2] = vec4(giSurrounding * giOcclusion, 1.0);
#ifdef GI_EXTENDED
    gl_FragData[3] = vec4(metallic, giOcclusion, roughness, 1.0);
    gl_FragData[4] = vec4(emissiveColor, 1.0);
#endif
#ifdef GI_SURROUNDINGS
    gl_FragData[GI_SURROUNDINGS] = vec4(iblSpecular * giOcclusion, 1.0);
#endif
#ifdef GI_FACET
    gl_FragData[GI_FACET] = vec4(giEncodeOctahedral(giFacet), giEncodeHeight(giBulge), 1.0);
#endif
#ifdef GI_DISPLACEMENT
    gl_FragData[GI_DISPLACEMENT] = vec4(giDisplacement, 1.0);
#endif
  }
