// A noisy value of a pixel with the surface that it belongs to, in one texel. Needs lib/octahedral.glsl.
struct GiSignal
{
  vec3 value;
  float frames; // number of frames in the value's mean; 0 for no surface
  float depth;  // of the window
  vec2 normal;  // octahedral
};

uvec4 giPackSignal(GiSignal signal)
{
  uvec2 n = uvec2(signal.normal * 65535.0 + 0.5);
  return uvec4(packHalf2x16(signal.value.rg), packHalf2x16(vec2(signal.value.b, signal.frames)),
    floatBitsToUint(signal.depth), n.x << 16 | n.y);
}

GiSignal giUnpackSignal(uvec4 word)
{
  vec2 last = unpackHalf2x16(word.y);
  return GiSignal(vec3(unpackHalf2x16(word.x), last.x), last.y, uintBitsToFloat(word.z),
    vec2(word.w >> 16, word.w & 65535u) / 65535.0);
}

// Share of a filter's level, whose samples are `step` pixels apart, at a pixel. It falls with the number of frames in
// the mean, the largest steps first, to nothing, so that still pictures converge to their unfiltered mean.
float giFilterShare(float radius, float step, float frames)
{
  const float last = 64.0; // frames
  float reach = radius / (1.0 + frames / 4.0);
  return clamp(2.0 * reach / step - 1.0, 0.0, 1.0) * clamp(2.0 - 2.0 * frames / last, 0.0, 1.0);
}
