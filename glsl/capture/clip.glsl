  if (gl_FragCoord.z < giDepthWindow.x || gl_FragCoord.z > giDepthWindow.y)
  {
    discard;
  }
