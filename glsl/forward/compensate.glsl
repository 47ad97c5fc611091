  // As in capture/surrounding.glsl.
#ifdef GI_LOBE_KNOWN
  iblSpecular *= giCompensates ? giCompensation(F0, brdf.r + brdf.g) : vec3(1.0);
#endif
