//VTK::System::Dec
//VTK::Light::Dec
void main()
{
  //VTK::Light::Impl
  gl_FragData[0] = vec4(ambientColor + diffuseColor, opacity);
}
