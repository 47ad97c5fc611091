// Encodes a unit vector in two numbers: Cigolle et al. 2014, A Survey of Efficient Representations for
// Independent Unit Vectors. They lie in [0, 1], for unsigned normalized storage.
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

vec3 giDecodeOctahedral(vec2 e)
{
  vec2 p = e * 2.0 - 1.0;
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return normalize(n);
}
