  // Volumes are coloured by their data.
  finalColor.xyz = (1.0 - giAbsorbed) * mix(color.rgb, finalColor.xyz, giDataLit(false));
  