//VTK::Normal::Dec
out vec4 myPosition;
