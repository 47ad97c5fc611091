  vec4 giDrawn = vec4(giLit.rgb * gl_FragData[0].rgb, gl_FragData[0].a);
  if (giDrawn.a <= 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0, 0.0, 0.0, giDrawn.a);
  gl_FragData[1] = vec4(0.5, 0.5, 0.0, 0.0);
  gl_FragData[2] = giDrawn;
#ifdef GI_EXTENDED
  gl_FragData[3] = vec4(0.0);
  gl_FragData[4] = vec4(0.0, 0.0, 0.0, giDrawn.a);
#endif
