  // VTK multiplies this colour by its textures next. Keep the lit colour and pass white, so that the result is the
  // texture's factor.
  vec4 giLit = gl_FragData[0];
  gl_FragData[0] = vec4(1.0, 1.0, 1.0, giLit.a);
