  vec4 giAround = giIndirect(vertexVC.xyz, normalVCVSOutput);
