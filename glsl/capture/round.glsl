  // At the end of a mapper's vertex shader, for capture/facet.glsl: the plane across the normal.
  float giSize = length(normalVCVSOutput);
  giRound.xyz = giSize > 0.0 ? normalVCVSOutput / giSize : vec3(0.0);
  giRound.w = dot(giRound.xyz, vertexVCVSOutput.xyz);
