  float giAlpha = gl_FragData[0].a;
  if (giAlpha <= 0.0)
  {
    discard;
  }
  float giOcclusion = mix(1.0, ao, aoStrengthUniform);
  gl_FragData[0] = vec4(albedo, giAlpha);
  gl_FragData[1] = vec4(giEncodeOctahedral(normalVCVSOutput), float(giMaterial) / 65535.0, roughness);
  gl_FragData[2] = vec4(giSurrounding * giOcclusion, giAlpha);
#ifdef GI_EXTENDED
  gl_FragData[3] = vec4(metallic, giOcclusion, 0.0, 1.0);
  gl_FragData[4] = vec4(emissiveColor, giAlpha);
#endif
