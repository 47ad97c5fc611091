//VTK::Color::Impl
  diffuseColor *= tint;
