  diffuseColor *= 1.0 - giAbsorbed;
