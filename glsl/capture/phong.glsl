  vec4 giTexture = gl_FragData[0];
  if (giTexture.a <= 0.0)
  {
    discard;
  }
  // Only VTK's edges drawn as tubes shorten the normal, where they blend into the surface.
  gl_FragData[0] = vec4(diffuseColor * giTexture.rgb * length(normalVCVSOutput), giTexture.a);
  gl_FragData[1] = vec4(giEncodeOctahedral(normalVCVSOutput),
    float(gl_FrontFacing ? giMaterial : giBackMaterial) / 65535.0, 0.0);
  gl_FragData[2] = vec4(ambientColor * giTexture.rgb, giTexture.a);
#ifdef GI_EXTENDED
  gl_FragData[3] = vec4(giTexture.rgb, 1.0);
  gl_FragData[4] = vec4(0.0, 0.0, 0.0, giTexture.a);
#endif
