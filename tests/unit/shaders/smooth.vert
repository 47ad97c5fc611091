out vec3 normalVCVSOutput;
void main()
{
  vertexVCVSOutput = MCVCMatrix * vertexMC;
}
