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
    vec3 giTexture = gl_FragData[0].rgb;
    // Only edges that VTK draws as tubes shorten the normal, where they blend into the surface.
    gl_FragData[0] = vec4(diffuseColor * giTexture * length(normalVCVSOutput), 1.0);
    gl_FragData[1] = vec4(giEncodeOctahedral(normalVCVSOutput),
      float(gl_FrontFacing ? giMaterial : giBackMaterial) / 65535.0, 1.0);
    gl_FragData[2] = vec4(ambientColor * giTexture, 1.0);
#ifdef GI_EXTENDED
    gl_FragData[3] = vec4(giTexture, 1.0);
    gl_FragData[4] = vec4(0.0, 0.0, 0.0, 1.0);
#endif
#ifdef GI_SURROUNDINGS
    gl_FragData[GI_SURROUNDINGS] = vec4(0.0, 0.0, 0.0, 1.0);
#endif
#ifdef GI_FACET
    gl_FragData[GI_FACET] = vec4(giEncodeOctahedral(giFacet), giEncodeHeight(giBulge), 1.0);
#endif
#ifdef GI_DISPLACEMENT
    gl_FragData[GI_DISPLACEMENT] = vec4(giDisplacement, 1.0);
#endif
  }
