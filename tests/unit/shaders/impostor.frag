in vec3 normalVCVSOutput;
in vec4 vertexVCVSOutput;
void main()
{
  // Set gl_FragDepth here (gl_FragCoord.z by default)
  vec4 vertexVC = vertexVCVSOutput;
  gl_FragDepth = (pos.z / pos.w + 1.0) / 2.0;
}
