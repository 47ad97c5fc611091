  // Normal of the flat facet at the pixel, toward the eye, and the facet's depth below the curved surface that the
  // normals represent: the mean of its depths below the tangent planes at the corners (Hanika 2021,
  // Hacking the Shadow Terminator). Variants: GI_FLAT, unless the shading normal is the geometric one; GI_ROUND, if the
  // vertex shader ends with capture/round.glsl. This is outside of all branches, where derivatives would be undefined.
  vec3 giFacet = normalVCVSOutput;
#ifdef GI_FLAT
  vec3 giAcross = dFdx(vertexVC.xyz);
  vec3 giAlong = dFdy(vertexVC.xyz);
  giAcross = cross(giAcross / max(max(abs(giAcross.x), abs(giAcross.y)), abs(giAcross.z)),
    giAlong / max(max(abs(giAlong.x), abs(giAlong.y)), abs(giAlong.z)));
  float giLength = length(giAcross);
  giFacet = giLength > 0.0 ? giAcross / giLength : giFacet; // the condition is false for NaN
#endif
  float giBulge = 0.0;
#ifdef GI_ROUND
  giBulge = giRoundVSOutput.w - dot(giRoundVSOutput.xyz, vertexVC.xyz);
  giBulge = max(dot(giRoundVSOutput.xyz, normalVCVSOutput) < 0.0 ? -giBulge : giBulge, 0.0);
#endif
