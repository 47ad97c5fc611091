  // A normal of points that is zero, or no number, counts as none: that of the flat piece does, toward the eye.
  vec3 giPieceAcross = dFdx(vertexVC.xyz);
  vec3 giPieceAlong = dFdy(vertexVC.xyz);
  giPieceAcross /= max(max(abs(giPieceAcross.x), abs(giPieceAcross.y)), abs(giPieceAcross.z));
  giPieceAlong /= max(max(abs(giPieceAlong.x), abs(giPieceAlong.y)), abs(giPieceAlong.z));
  vec3 giPiece = cross(giPieceAcross, giPieceAlong);
  giPiece = dot(giPiece, giPiece) > 0.0 ? normalize(giPiece) : vec3(0.0, 0.0, 1.0);
  // VTK has normalized it. Not "above 0": compilers take that for "not 0" in a sum of squares, which no number is too.
  float giSquare = dot(normalVCVSOutput, normalVCVSOutput);
  bool giIsNormal = giSquare > 0.25 && giSquare < 4.0;
  giPiece = giIsNormal ? normalVCVSOutput : giPiece;
  normalVCVSOutput = giMendsNormals != 0 ? giPiece : normalVCVSOutput;
