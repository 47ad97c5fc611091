// Encodes a height of any scale in [0, 1] by its logarithm, for unsigned normalized storage. In 16 bits the relative
// error is about a thousandth. Heights of zero or less become zero.
float giEncodeHeight(float height)
{
  return height > 0.0 ? clamp(log2(height) / 128.0 + 0.5, 1e-4, 1.0) : 0.0;
}

float giDecodeHeight(float code)
{
  return code > 0.0 ? exp2(128.0 * code - 64.0) : 0.0;
}
