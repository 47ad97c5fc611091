  // The finished colour of a lit surface. Variants: GI_PBR (VTK has encoded it for display), GI_RULES, GI_DISPLAY.
  {
    vec3 giFinished = gl_FragData[0].rgb;
#ifdef GI_PBR
    giFinished = pow(max(giFinished, 0.0), vec3(2.2));
#endif
#ifdef GI_RULES
#ifdef GI_PBR
    giFinished = mix(albedo, giFinished, giDataLit(true));
#else
    giFinished = mix(diffuseColor, giFinished, giDataLit(false));
#endif
#endif
#ifdef GI_DISPLAY
#ifdef GI_PBR
    giFinished = giDisplayed(giFinished, true);
#else
    giFinished = giDisplayed(giFinished, false);
#endif
#endif
#ifdef GI_PBR
    giFinished = pow(giFinished, vec3(1.0 / 2.2));
#endif
    gl_FragData[0].rgb = giFinished;
  }
