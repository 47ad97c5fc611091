  gl_FragData[0].rgb += diffuseColor * giAround.rgb;
