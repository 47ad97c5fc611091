//VTK::Normal::Dec
in vec4 myPosition;
