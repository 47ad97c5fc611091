//VTK::Normal::Impl
  myPosition = vertexMC;
