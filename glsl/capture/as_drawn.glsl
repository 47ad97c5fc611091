#include "capture/clip.glsl"
  // Keep VTK's own colour. Where it covers the pixel only partly, the surface below keeps its normal.
  vec4 giDrawn = vec4(giLit.rgb * gl_FragData[0].rgb, gl_FragData[0].a);
  if (giDrawn.a <= giLeastCover())
  {
    discard;
  }
  float giWhole = giDrawn.a < giOpaque ? 0.0 : 1.0;
  gl_FragData[0] = vec4(0.0, 0.0, 0.0, giDrawn.a);
  gl_FragData[1] = vec4(0.5, 0.5, 0.0, giWhole);
  gl_FragData[2] = giDrawn;
#ifdef GI_EXTENDED
  gl_FragData[3] = vec4(0.0, 0.0, 0.0, giWhole);
  gl_FragData[4] = vec4(0.0, 0.0, 0.0, giDrawn.a);
#endif
#ifdef GI_SURROUNDINGS
  gl_FragData[GI_SURROUNDINGS] = vec4(0.0, 0.0, 0.0, giWhole);
#endif
#ifdef GI_FACET
  gl_FragData[GI_FACET] = vec4(0.5, 0.5, 0.0, giWhole);
#endif
#ifdef GI_DISPLACEMENT
  gl_FragData[GI_DISPLACEMENT] = vec4(giDisplacement, giWhole);
#endif
