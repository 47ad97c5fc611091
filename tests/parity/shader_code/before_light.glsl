  ambientColor = vec3(0.2, 0.0, 0.1);
//VTK::Light::Impl
