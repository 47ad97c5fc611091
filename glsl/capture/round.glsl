  // At the end of a mapper's vertex shader, for capture/facet.glsl: the plane across the normal.
  float giSize = length(normalVCVSOutput);
  giRoundVSOutput.xyz = giSize > 0.0 ? normalVCVSOutput / giSize : vec3(0.0);
  giRoundVSOutput.w = dot(giRoundVSOutput.xyz, vertexVCVSOutput.xyz);
