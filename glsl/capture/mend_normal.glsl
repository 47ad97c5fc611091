  // A point normal that is zero or NaN is replaced by the normal of the flat facet, toward the eye.
  vec3 giPieceAcross = dFdx(vertexVC.xyz);
  vec3 giPieceAlong = dFdy(vertexVC.xyz);
  giPieceAcross /= max(max(abs(giPieceAcross.x), abs(giPieceAcross.y)), abs(giPieceAcross.z));
  giPieceAlong /= max(max(abs(giPieceAlong.x), abs(giPieceAlong.y)), abs(giPieceAlong.z));
  vec3 giPiece = cross(giPieceAcross, giPieceAlong);
  giPiece = dot(giPiece, giPiece) > 0.0 ? normalize(giPiece) : vec3(0.0, 0.0, 1.0);
  // VTK has normalized the normal. The test is not "> 0", which compilers turn into "!= 0" for a sum of squares; that
  // is true for NaN.
  float giSquare = dot(normalVCVSOutput, normalVCVSOutput);
  bool giIsNormal = giSquare > 0.25 && giSquare < 4.0;
  giPiece = giIsNormal ? normalVCVSOutput : giPiece;
  normalVCVSOutput = giMendsNormals != 0 ? giPiece : normalVCVSOutput;
