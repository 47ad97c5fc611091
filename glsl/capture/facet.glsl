  // The normal of the flat piece that lies under the pixel, toward the eye, and how far below the round surface
  // it is that the normals stand for: the mean of what it is below the planes at the corners (Hanika 2021,
  // Hacking the Shadow Terminator). Variants: GI_FLAT, unless the normal is the surface's own; GI_ROUND, the
  // vertex shader ends with capture/round.glsl. Here, as derivatives are not defined in branches.
  vec3 giFacet = normalVCVSOutput;
#ifdef GI_FLAT
  vec3 giAcross = dFdx(vertexVC.xyz);
  vec3 giAlong = dFdy(vertexVC.xyz);
  giAcross = cross(giAcross / max(max(abs(giAcross.x), abs(giAcross.y)), abs(giAcross.z)),
    giAlong / max(max(abs(giAlong.x), abs(giAlong.y)), abs(giAlong.z)));
  float giLength = length(giAcross);
  giFacet = giLength > 0.0 ? giAcross / giLength : giFacet; // false of what is not a number
#endif
  float giBulge = 0.0;
#ifdef GI_ROUND
  giBulge = giRoundVSOutput.w - dot(giRoundVSOutput.xyz, vertexVC.xyz);
  giBulge = max(dot(giRoundVSOutput.xyz, normalVCVSOutput) < 0.0 ? -giBulge : giBulge, 0.0);
#endif
