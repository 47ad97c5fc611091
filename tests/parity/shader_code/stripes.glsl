//VTK::Normal::Impl
  diffuseColor *= 0.5 + 0.5 * sin(40.0 * myPosition.x);
