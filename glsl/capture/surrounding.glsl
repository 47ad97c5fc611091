  // The light of the surroundings, which VTK has added first. Variants: GI_LOBE_KNOWN (brdf holds the reflectance of the
  // highlight under uniform light, as factors of F0 and F90), GI_SCATTERS (VTK adds the light that microfacets reflect
  // several times to the diffuse light; it belongs to the highlight, which remains where diffuse light is replaced).
#ifdef GI_LOBE_KNOWN
  vec3 giBoost = giCompensates ? giCompensation(F0, brdf.r + brdf.g) : vec3(1.0);
  color += (giBoost - 1.0) * iblSpecular;
  iblSpecular *= giBoost;
#endif
#ifdef GI_SCATTERS
  iblSpecular += FmsEms * irradiance;
#endif
  vec3 giSurrounding = color;
