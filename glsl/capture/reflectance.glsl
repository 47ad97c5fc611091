  diffuseColor *= giReflectance;
