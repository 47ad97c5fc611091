//VTK::Color::Impl
  diffuseColor = diffuseColor.bgr;
