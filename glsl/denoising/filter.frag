#version 430 core
// One level of an a-trous filter: the mean of samples on the same surface (Dammertz, Sewtz, Hanika and Lensch 2010,
// Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination Filtering). Samples of light weigh by their number of
// frames, and less where they differ by more than their noise (Schied et al. 2017, Spatiotemporal Variance-Guided Filtering).
// GI_GUIDED: a network says how much differences count (Isik, Mullia, Fisher, Eisenmann and Gharbi 2021, Interactive Monte Carlo
// Denoising using Affinity of Neural Features), and for light by rays also how much samples of other surfaces and a regression on
// the samples' places (Fan 1992, Design-adaptive Nonparametric Regression). GI_SLOPES: averages residuals of a regression on
// normals and concavities, see slopes.comp.
// Variants: those of denoising/signal.glsl; GI_OWN_SURFACE: light of paths, which the network was not trained on.
#include "shared/view.h"
#include "shared/denoising.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "lib/alike.glsl"
#include "lib/filter_reach.glsl"
#include "lib/luminance.glsl"
#include "denoising/signal.glsl"
layout(binding = 0) uniform usampler2D signalTexture;
#ifdef GI_GUIDED
layout(binding = 1) uniform sampler2D featureTexture;
layout(binding = 2) uniform sampler2D countTexture; // how much features, deviations, places and other surfaces count in this level
#endif

// Not for light of paths, which the network was not trained on.
#if defined(GI_GUIDED) && !defined(GI_OWN_SURFACE)
#define GI_PLACES
#endif

#ifdef GI_SLOPES
layout(binding = 3) uniform sampler2DArray slopes;
#endif
#ifdef GI_JOINT
layout(binding = 4) uniform sampler2D values;
#endif

uniform int step;
uniform int sharing; // number of pixels that share a sample in one frame

// Standard deviations of a difference after which a sample's weight falls to 1 / e.
const float TOLERANCE = 3.25;

// How much features count in light of paths, times as much as the network says, in the first two levels and later: a path that finds
// a bright lamp by chance stays a small spot. Standard deviations count as without the network there.
const vec2 FEATURES_OF_PATHS = vec2(2.4, 12.0);

// How much the network may make standard deviations count, per frame. Few frames may agree by chance and then seem to have little
// noise: walls would get dots. The regressions spare what this blurs.
const float SHARPNESS_PER_FRAME = 0.05;
const float FEWEST_FRAMES = 8.0; // from which the frames of a mean tell its noise

// Number of frames from which features count as the network says. In first frames they would keep noise. Of two pixels the longer
// history decides, so that a surface that has just come into view is told from those around it.
const float FEATURE_FRAMES = 4.0;

// Number of frames up to which standard deviations count as the network says, and their share after many. Otherwise what stands out
// of a mean by chance stays for long, and still pictures flicker more than without the network.
const float SHARP_FRAMES = 12.0;
const float LEAST_SHARE = 0.4;

// Most that normals count, times as much as in a first frame, where a regression on normals and features of a network spare what
// normals explain.
const float MOST_BEND = 2.25;

// Relative noise of paths from which normals count as in a first frame: what they change is less.
const float MUCH_NOISE = 0.2;

const float RIDGE = 0.1; // of the regression on places, in squared distances of samples

#ifdef GI_SHARES
const int DIRECTIONS = 4; // a penumbra is foreshortened like its surface; opposite samples have the same reach
#else
const int DIRECTIONS = 1;
#endif

layout(location = 0) out uvec4 result;
#ifdef GI_JOINT
layout(location = 1) out vec4 filtered;
#endif

// Length of a step on the surface at a pixel, divided by that on a surface that faces the eye. offset: the step, in pixels.
float stretchOf(GiSurfel here, vec2 offset)
{
  vec3 P = giViewPosition(gl_FragCoord.xy, here.depth);
  vec3 along = giViewPosition(gl_FragCoord.xy + offset, here.depth + dot(here.slope, offset)) - P;
  vec3 across = giViewPosition(gl_FragCoord.xy + offset, here.depth) - P;
  return max(length(along) / max(length(across), 1e-30), 1.0);
}

#ifdef GI_SLOPES
// Derivative of light with respect to the normal and the concavity at a pixel, interpolated between tiles.
mat4x3 slopeAt(vec2 place)
{
  vec2 last = ceil(view.Viewport.zw / float(GI_DENOISING_TILE)) - 1.0;
  vec2 tile = (place - view.Viewport.xy) / float(GI_DENOISING_TILE) - 0.5;
  vec2 f = fract(tile);
  mat4x3 sum = mat4x3(0.0);
  for (int i = 0; i < 4; ++i)
  {
    vec2 offset = vec2(i & 1, i >> 1);
    vec2 share = mix(1.0 - f, f, offset);
    ivec2 at = ivec2(clamp(floor(tile) + offset, vec2(0.0), last));
    for (int j = 0; j < 4; ++j)
    {
      sum[j] += share.x * share.y * texelFetch(slopes, ivec3(at, j), 0).rgb;
    }
  }
  return sum;
}
#endif

// Weight of a sample by its distance along an axis: a spline, as levels of equal weights would leave patterns of dots.
// farthest: the greatest distance, 1 or 2 samples.
float kernelAt(int distance, int farthest)
{
  float d = float(distance);
  return farthest == 1 ? 0.5 - 0.25 * d : 0.375 - (0.09375 + 0.03125 * d) * d; // 3/8, 1/4, 1/16
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  result = texelFetch(signalTexture, pixel, 0);
  GiSignal signal = giUnpackSignal(result);
#ifdef GI_JOINT
  vec4 own = texelFetch(values, pixel, 0);
  vec4 change = vec4(0.0);
  filtered = own;
#endif
#ifdef GI_LIGHT
  if (giFilterShare(signal.reach, float(step)).x == 0.0)
  {
    return;
  }
#endif
  if (signal.frames == 0.0)
  {
    return;
  }
  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw) - 1;
  GiSurfel here = giSurfel(gl_FragCoord.xy, signal.depth, signal.normal, float(step));
  vec4 changes[DIRECTIONS];
  for (int i = 0; i < DIRECTIONS; ++i)
  {
    changes[i] = vec4(0.0);
  }
  float weights = 0.0;
  vec4 reach = vec4(0.0);
  vec4 known = vec4(0.0);
#ifdef GI_LIGHT
  float bend = giBend(signal.frames);
#ifdef GI_OWN_SURFACE
  bend = clamp(MUCH_NOISE * MUCH_NOISE / max(signal.error * signal.error, 1e-6), 1.0, bend);
#elif defined(GI_GUIDED)
  bend = min(bend, MOST_BEND);
#endif
  here.bend *= bend;
  float light = giLuminance(signal.value.rgb);
  float noise = signal.error * light;
  bool guided = noise > 0.0; // else the noise follows from how much the samples differ
  vec2 moments = vec2(0.0);
  vec2 squares = vec2(0.0); // of weights, and of weighted noise
#endif
#ifdef GI_GUIDED
  vec4 features = texelFetch(featureTexture, pixel, 0);
  vec4 ownCounts = texelFetch(countTexture, pixel, 0);
#endif
#ifdef GI_PLACES
  vec2 places = vec2(0.0);
  vec3 spread = vec3(0.0);
  mat2x4 leans = mat2x4(0.0); // products of changes and places
#ifdef GI_JOINT
  mat2x4 ownLeans = mat2x4(0.0);
#endif
#endif
#ifdef GI_SLOPES
  mat4x3 slope = slopeAt(gl_FragCoord.xy);
  vec4 shape = vec4(giDecodeOctahedral(signal.normal), signal.concavity);
#endif
#if defined(GI_OWN_SURFACE) || defined(GI_PLACES)
  int farthest = step == 1 ? 2 : 1; // most noise is left where surfaces are a few pixels wide
#else
  const int farthest = 1;
#endif
  int number = 0;
  for (int y = -farthest; y <= farthest; ++y)
  {
#ifdef GI_PLACES
    int widest = farthest == 1 ? 1 : farthest - abs(y); // for time's sake no corners
#else
    int widest = farthest;
#endif
    for (int x = -widest; x <= widest; ++x, ++number)
    {
      ivec2 offset = ivec2(x, y);
      ivec2 at = pixel + step * offset;
      if (any(lessThan(at, low)) || any(greaterThan(at, high)))
      {
        continue;
      }
      GiSignal other = giUnpackSignal(texelFetch(signalTexture, at, 0));
      float alike = giSimilarity(here, vec2(step * offset), other.depth, other.normal);
#ifdef GI_GUIDED
      vec4 otherCounts = texelFetch(countTexture, at, 0);
#endif
#ifdef GI_PLACES
      alike = mix(alike, 1.0, min(ownCounts.w, otherCounts.w));
#endif
      float weight = kernelAt(abs(offset.x), farthest) * kernelAt(abs(offset.y), farthest) * other.frames * alike;
      if (weight == 0.0)
      {
        continue;
      }
      float sharpness = 1.0 / TOLERANCE;
      float unlike = 0.0; // the weight falls by e to the power of this
#ifdef GI_GUIDED
      // Symmetric: if a bright pixel took from neighbours that refuse its own sample, the picture would lose light.
      vec2 counts = max(ownCounts.xy, otherCounts.xy);
      vec4 apart = texelFetch(featureTexture, at, 0) - features;
#ifdef GI_OWN_SURFACE
      counts.x *= step <= 2 ? FEATURES_OF_PATHS.x : FEATURES_OF_PATHS.y;
#else
      counts.x *= min(max(signal.frames, other.frames) / FEATURE_FRAMES, 1.0);
      float least = min(signal.frames, other.frames);
      sharpness = min(counts.y, SHARPNESS_PER_FRAME * max(least, FEWEST_FRAMES));
      sharpness *= clamp(SHARP_FRAMES / least, LEAST_SHARE, 1.0);
#endif
      unlike = counts.x * dot(apart, apart);
#endif
#ifdef GI_LIGHT
      float otherNoise = other.error * giLuminance(other.value.rgb);
      vec3 turned = vec3(0.0);
#ifdef GI_SLOPES
      turned = slope * (shape - vec4(giDecodeOctahedral(other.normal), other.concavity));
#endif
      other.value.rgb += turned;
      float otherLight = giLuminance(other.value.rgb);
      if (guided)
      {
        unlike += sharpness * abs(otherLight - light) * inversesqrt(max(noise * noise + otherNoise * otherNoise, 1e-30));
      }
      weight *= exp(-unlike);
#ifdef GI_PLACES
      vec2 place = vec2(offset) / float(farthest);
      places += weight * place;
      spread += weight * place.xxy * place.xyy;
      leans += weight * outerProduct(other.value - signal.value, place);
#endif
      moments += weight * vec2(otherLight, otherLight * otherLight);
      squares += weight * weight * vec2(1.0, otherNoise * otherNoise);
#ifdef GI_JOINT
      vec4 ownChange = texelFetch(values, at, 0) + vec4(turned, 0.0) - own;
      change += weight * ownChange;
#ifdef GI_PLACES
      ownLeans += weight * outerProduct(ownChange, place);
#endif
#endif
#endif
      changes[DIRECTIONS == 1 ? 0 : min(min(number, 8 - number), DIRECTIONS - 1)] += weight * (other.value - signal.value);
      weights += weight;
#ifndef GI_LIGHT
      // A penumbra reaches pixels whose own ray missed the occluder.
      vec4 hits = weight * vec4(greaterThan(other.reach, vec4(0.0)));
      reach += hits * other.reach;
      known += hits;
#endif
    }
  }
#ifndef GI_LIGHT
  signal.reach = reach / max(known, 1e-6);
#endif
#ifdef GI_PLACES
  vec2 middle = places / max(weights, 1e-6);
  vec2 lever = inverse(mat2(spread.xy, spread.yz) / max(weights, 1e-6) - outerProduct(middle, middle) + mat2(RIDGE)) * middle;
  // A sample at d has 1 - trust * dot(d - middle, lever) times its weight, which must not be negative.
  vec2 size = abs(lever);
  float most = (farthest > 1 ? max(size.x, size.y) : size.x + size.y) - dot(middle, lever);
  lever *= min(ownCounts.z, 1.0 / max(most, 1e-6));
  changes[0] += dot(middle, lever) * changes[0] - leans * lever;
#ifdef GI_JOINT
  change += dot(middle, lever) * change - ownLeans * lever;
#endif
#endif
  vec4 share = vec4(0.0);
  for (int i = 0; i < DIRECTIONS; ++i)
  {
    float stretch = DIRECTIONS == 1 ? 1.0 : stretchOf(here, vec2(i % 3, i / 3) - 1.0);
    share = giFilterShare(signal.reach / stretch, float(step));
    signal.value += share * changes[i] / max(weights, 1e-6);
  }
#ifdef GI_LIGHT
#ifdef GI_JOINT
  filtered = max(own + share.x * change / max(weights, 1e-6), 0.0);
#endif
  signal.value.rgb = max(signal.value.rgb, 0.0);
  if (!guided)
  {
    moments /= max(weights, 1e-6);
    squares.y = float(sharing) * squares.x * max(moments.y - moments.x * moments.x, 0.0);
  }
  noise = mix(noise, sqrt(squares.y) / max(weights, 1e-6), share.x);
  signal.error = min(noise / max(giLuminance(signal.value.rgb), 1e-20), 1.0);
#endif
  result = giPackSignal(signal);
}
