  {
#include "capture/facet.glsl"
    giArriveAt(vertexVC.xyz, normalVCVSOutput, giFacet, giBulge);
  }
