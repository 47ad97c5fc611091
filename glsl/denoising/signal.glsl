// A noisy result of a pixel with the surface that it belongs to, in one texel. Needs lib/octahedral.glsl and
// lib/filter_reach.glsl. Variants: GI_SHARES (shares of four lights, each with a reach of its own), GI_LOBE (a colour and its
// share, with a reach), GI_LIGHT (light in all directions, whose reach follows from its frames and its noise), GI_GUIDED (light,
// filtered as a network says, which knows how much is left to filter). GI_JOINT: the values are means over frames, and guide the
// filter of this frame's own values (Petschnigg et al. 2004, Digital Photography with Flash and No-Flash Image Pairs).
struct GiSignal
{
  vec4 value;
  vec4 reach;   // of the filter, in pixels
  float frames; // number of frames in the value's mean, 255 at most; 0 for no surface
  float error;  // relative standard error of light's luminance; 0: unknown
  float depth;  // of the window
  vec2 normal;  // octahedral
  float concavity; // of light's surface, see pack.frag; 0 if flat
};

uniform float radius; // the greatest reach, in pixels

// Frames after which the reach of light is half, and nothing. That filter spares what stands out of the noise, so it may last.
#ifdef GI_GUIDED
const float LIGHT_HALVED = 1e9;
#elif defined(GI_OWN_SURFACE)
const float LIGHT_HALVED = 48.0;
#else
const float LIGHT_HALVED = 32.0;
#endif
const float LIGHT_LAST = 256.0;

// Number of frames after the first in which the limit on the squared difference of normals halves. Light depends on where a
// surface faces: in the first frame its noise is larger than what slopes differ by, later it is not.
const float BEND_HALVED = 4.0;

float giBend(float frames)
{
  return 1.0 + (frames - 1.0) / BEND_HALVED;
}

// Share of a filter's level, whose samples are `step` pixels apart. As the reach falls, the largest steps end first.
vec4 giFilterShare(vec4 reach, float step)
{
  return clamp(2.0 * reach / step - 1.0, 0.0, 1.0);
}

const float GI_WIDEST = 64.0;   // reach that can be stored
const float GI_BRIGHTEST = 6e4; // light that half floats hold

// Steps of what signals of light hold: of normals, of depths, and of the square roots of concavities.
const float GI_NORMALS = 4095.0;
const float GI_DEPTHS = 16777215.0;
const float GI_CONCAVITIES = 32767.0;

uint giPackNormal(vec2 normal)
{
  uvec2 n = uvec2(normal * 65535.0 + 0.5);
  return n.x << 16 | n.y;
}

uvec4 giPackSignal(GiSignal signal)
{
#if defined(GI_SHARES) || defined(GI_LOBE)
  uint depth = floatBitsToUint(signal.frames > 0.0 ? signal.depth : -1.0);
#endif
#ifdef GI_SHARES
  return uvec4(packUnorm4x8(signal.value), packUnorm4x8(sqrt(signal.reach / GI_WIDEST)), depth, giPackNormal(signal.normal));
#elif defined(GI_LOBE)
  vec2 last = vec2(signal.value.a, sqrt(signal.reach.x / GI_WIDEST));
  return uvec4(packHalf2x16(signal.value.rg), packHalf2x16(vec2(signal.value.b, 0.0)) | packUnorm4x8(vec4(0.0, 0.0, last)), depth,
    giPackNormal(signal.normal));
#else
  uint error = signal.error > 0.0 ? max(uint(sqrt(signal.error) * 255.0 + 0.5), 1u) : 0u;
  uint known = uint(min(signal.frames, 255.0)) << 8 | error;
  uvec2 n = uvec2(signal.normal * GI_NORMALS + 0.5);
  float root = sign(signal.concavity) * sqrt(min(abs(signal.concavity), 1.0));
  uint steps = uint(GI_CONCAVITIES * (root + 1.0) + 0.5);
  return uvec4(packHalf2x16(signal.value.rg), packHalf2x16(vec2(signal.value.b, 0.0)) | known << 16,
    min(uint(signal.depth * GI_DEPTHS + 0.5), 16777215u) | steps >> 8 << 24, n.x << 20 | n.y << 8 | steps & 255u);
#endif
}

GiSignal giUnpackSignal(uvec4 word)
{
  GiSignal signal;
#if defined(GI_SHARES) || defined(GI_LOBE)
  signal.depth = uintBitsToFloat(word.z);
  signal.normal = vec2(word.w >> 16, word.w & 65535u) / 65535.0;
#else
  signal.depth = float(word.z & 16777215u) / GI_DEPTHS;
  signal.normal = vec2(word.w >> 20, word.w >> 8 & 4095u) / GI_NORMALS;
  float root = float(word.z >> 24 << 8 | word.w & 255u) / GI_CONCAVITIES - 1.0;
  signal.concavity = root * abs(root);
#endif
#ifdef GI_SHARES
  vec4 root = unpackUnorm4x8(word.y);
  signal.value = unpackUnorm4x8(word.x);
  signal.reach = GI_WIDEST * root * root;
  signal.frames = signal.depth >= 0.0 ? 1.0 : 0.0;
#elif defined(GI_LOBE)
  vec2 last = unpackUnorm4x8(word.y).zw;
  signal.value = vec4(unpackHalf2x16(word.x), unpackHalf2x16(word.y).x, last.x);
  signal.reach = vec4(GI_WIDEST * last.y * last.y);
  signal.frames = signal.depth >= 0.0 ? 1.0 : 0.0;
#else
  uint known = word.y >> 16;
  float errorRoot = float(known & 255u) / 255.0;
  signal.value = vec4(unpackHalf2x16(word.x), unpackHalf2x16(word.y).x, 0.0);
  signal.error = errorRoot * errorRoot;
  signal.frames = float(known >> 8);
#if defined(GI_JOINT) && !defined(GI_GUIDED)
  signal.reach = vec4(radius * giReachInMean(signal.frames));
#else
  signal.reach = radius * giReachAfter(vec4(signal.frames), LIGHT_HALVED, LIGHT_LAST);
#endif
#endif
  return signal;
}
