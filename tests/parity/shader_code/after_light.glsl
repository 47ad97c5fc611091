//VTK::Light::Impl
  gl_FragData[0].rgb = floor(gl_FragData[0].rgb * 4.0) / 4.0;
