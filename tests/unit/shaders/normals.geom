in vec3 normalVCVSOutput[];
out vec3 normalVCGSOutput;
void main()
{
  normalVCGSOutput = normalVCVSOutput[i];
}
