  // As direct_light/resolve.frag does: beside an environment, highlights reflect that; else all goes on evenly.
  vec3 giMatte = (1.0 - metallic) * (1.0 - F0) * albedo;
#ifdef GI_SPREAD
  // VTK's PBR reflects 1 / pi of what its Phong materials do.
  iblDiffuse += (giMatte + F0) * giAround.rgb / 3.14159265;
#elif defined(GI_ENVIRONMENT)
  iblDiffuse = (1.0 - giAround.a) * iblDiffuse + giMatte * giAround.rgb;
#else
  iblDiffuse += (giMatte + F0) * giAround.rgb;
#endif
