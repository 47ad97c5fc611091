  // VTK multiplies this colour by its textures next: keep the lit colour, and pass white through.
  vec4 giLit = gl_FragData[0];
  gl_FragData[0] = vec4(1.0, 1.0, 1.0, giLit.a);
