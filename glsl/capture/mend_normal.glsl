  // A normal of points that is zero, or no number, counts as none: that of the flat piece does, toward the eye.
  vec3 giPieceAcross = dFdx(vertexVC.xyz);
  vec3 giPieceAlong = dFdy(vertexVC.xyz);
  giPieceAcross /= max(max(abs(giPieceAcross.x), abs(giPieceAcross.y)), abs(giPieceAcross.z));
  giPieceAlong /= max(max(abs(giPieceAlong.x), abs(giPieceAlong.y)), abs(giPieceAlong.z));
  vec3 giPiece = cross(giPieceAcross, giPieceAlong);
  giPiece = dot(giPiece, giPiece) > 0.0 ? normalize(giPiece) : vec3(0.0, 0.0, 1.0);
  // Not the other way round: compilers take "not above" for "at most", which no number is either.
  giPiece = dot(normalVCVSOutput, normalVCVSOutput) > 0.0 ? normalVCVSOutput : giPiece;
  normalVCVSOutput = giMendsNormals != 0 ? giPiece : normalVCVSOutput;
