  // Inserted at the end of a mapper's vertex shader, for capture/facet.glsl: the tangent plane at the vertex.
  float giSize = length(normalVCVSOutput);
  giRoundVSOutput.xyz = giSize > 0.0 ? normalVCVSOutput / giSize : vec3(0.0);
  giRoundVSOutput.w = dot(giRoundVSOutput.xyz, vertexVCVSOutput.xyz);
