// A direction in one float, which represents integers of 24 bits exactly. Needs lib/octahedral.glsl.
float fieldPackDirection(vec3 direction)
{
  vec2 code = floor(giEncodeOctahedral(direction) * 4095.0 + 0.5);
  return code.x * 4096.0 + code.y;
}

vec3 fieldUnpackDirection(float code)
{
  float x = floor(code / 4096.0);
  return giDecodeOctahedral(vec2(x, code - 4096.0 * x) / 4095.0);
}
