  // The light of the surroundings, which VTK has added first. Variant: GI_LOBE_KNOWN (brdf holds the reflectance of the
  // highlight under uniform light, as factors of F0 and F90).
#ifdef GI_LOBE_KNOWN
  vec3 giBoost = giCompensates ? giCompensation(F0, brdf.r + brdf.g) : vec3(1.0);
  color += (giBoost - 1.0) * iblSpecular;
  iblSpecular *= giBoost;
#endif
  vec3 giSurrounding = color;
