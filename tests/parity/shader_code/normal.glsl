//VTK::Normal::Impl
  normalVCVSOutput = normalize(normalVCVSOutput + vec3(0.3, 0.0, 0.0));
