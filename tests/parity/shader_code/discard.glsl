//VTK::Light::Impl
  if (mod(gl_FragCoord.x, 8.0) < 3.0) { discard; }
