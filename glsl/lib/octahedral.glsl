// Unit vectors in two numbers: Cigolle et al. 2014, A Survey of Efficient Representations for
// Independent Unit Vectors. The result lies in [0, 1], for unsigned normalized storage.
vec2 giEncodeOctahedral(vec3 n)
{
  vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
  if (n.z < 0.0)
  {
    vec2 side = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    p = (1.0 - abs(p.yx)) * side;
  }
  return p * 0.5 + 0.5;
}

// Two numbers in [0, 1], to twelve bits each, in three of eight bits, and back.
vec3 giPack12(vec2 v)
{
  vec2 whole = floor(clamp(v, 0.0, 1.0) * 4095.0 + 0.5);
  vec2 high = floor(whole / vec2(16.0, 256.0));
  vec2 low = whole - high * vec2(16.0, 256.0);
  return vec3(high.x, low.x * 16.0 + high.y, low.y) / 255.0;
}

vec2 giUnpack12(vec3 v)
{
  vec3 whole = floor(v * 255.0 + 0.5);
  float high = floor(whole.y / 16.0);
  return vec2(whole.x * 16.0 + high, (whole.y - high * 16.0) * 256.0 + whole.z) / 4095.0;
}

vec3 giDecodeOctahedral(vec2 e)
{
  vec2 p = e * 2.0 - 1.0;
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return normalize(n);
}
