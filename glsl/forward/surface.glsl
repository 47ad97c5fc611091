  {
    // The flat piece of surface, as shadow maps know it.
    vec3 giFlat = cross(dFdx(vertexVC.xyz), dFdy(vertexVC.xyz));
    giFlat = dot(giFlat, giFlat) > 0.0 ? normalize(giFlat) : normalVCVSOutput;
    giArriveAt(vertexVC.xyz, normalVCVSOutput, giFlat);
  }
