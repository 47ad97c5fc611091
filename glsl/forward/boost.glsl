  vec3 giBoost = giCompensates ? giCompensation(F0, giHighlightShare(NdV, roughness)) : vec3(1.0);
