  // As in direct_light/resolve.frag: highlights reflect the environment if there is one; otherwise all indirect light
  // is reflected diffusely.
  vec3 giMatte = (1.0 - metallic) * (1.0 - F0) * albedo;
#ifdef GI_SCATTERS
  iblSpecular += FmsEms * irradiance;
  iblDiffuse -= FmsEms * irradiance;
#endif
#ifdef GI_SPREAD
  // VTK's PBR materials reflect 1 / pi of the light that its Phong materials reflect.
  iblDiffuse += (giMatte + F0) * giAround.rgb / 3.14159265;
#elif defined(GI_ENVIRONMENT)
  iblDiffuse = (1.0 - giAround.a) * iblDiffuse + giMatte * giAround.rgb;
#else
  iblDiffuse += (giMatte + F0) * giAround.rgb;
#endif
