//VTK::System::Dec
//VTK::Output::Dec
in vec4 vertexVCVSOutput;
in vec3 normalVCVSOutput;
void main()
{
  gl_FragData[0] = vec4(abs(normalVCVSOutput), 1.0);
}
