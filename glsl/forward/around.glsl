  vec4 giAround = giIndirect(vertexVC.xyz, normalVCVSOutput);
#ifdef GI_RULES
  giAround.rgb = giDataLight(giAround.rgb);
#endif
