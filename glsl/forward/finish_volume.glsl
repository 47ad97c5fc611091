  // The mean colour of what the ray has met; its alpha says how much that hides.
  gl_FragData[0].rgb =
    gl_FragData[0].a * giDisplayed(gl_FragData[0].rgb / max(gl_FragData[0].a, 1e-6), false);
