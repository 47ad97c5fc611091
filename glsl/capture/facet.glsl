#ifdef GI_FACET
  // The normal of the flat piece that lies under the pixel, toward the eye. Variant: GI_FLAT, unless
  // the normal is the surface's own. Here, as derivatives are not defined in branches.
  vec3 giFacet = normalVCVSOutput;
#ifdef GI_FLAT
  vec3 giAcross = dFdx(vertexVC.xyz);
  vec3 giAlong = dFdy(vertexVC.xyz);
  giAcross = cross(giAcross / max(max(abs(giAcross.x), abs(giAcross.y)), abs(giAcross.z)),
    giAlong / max(max(abs(giAlong.x), abs(giAlong.y)), abs(giAlong.z)));
  float giLength = length(giAcross);
  giFacet = giLength > 0.0 ? giAcross / giLength : giFacet; // false of what is not a number
#endif
#endif
