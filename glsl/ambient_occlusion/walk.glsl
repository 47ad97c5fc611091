// A walk over the depth buffer, from a pixel in a direction of the screen. Needs shared/view.h.
layout(binding = 0) uniform sampler2D depthTexture;

uniform float radius; // world units
uniform float bias;   // sine of the elevation that counts as flat
uniform int steps;
uniform int refinements;

struct Walk
{
  ivec2 pixel;
  vec2 place; // the pixel's centre in the window
  float depth;
  float shift; // jitter of the samples, in steps
  vec3 P;
  vec3 N;
  vec3 V; // to the eye
  vec4 clip;
  float w; // of the view position computed from clip coordinates
  vec3 perOffset; // change of w per offset in the window
};

Walk walkFrom(ivec2 pixel, float depth, vec3 N, float shift)
{
  Walk walk;
  walk.pixel = pixel;
  walk.place = vec2(pixel) + 0.5;
  walk.depth = depth;
  walk.shift = shift;
  walk.P = giViewPosition(walk.place, depth);
  walk.N = N;
  walk.V = normalize(giViewPosition(walk.place, 0.0) - giViewPosition(walk.place, 1.0));
  walk.clip = view.ViewToClip * vec4(walk.P, 1.0);
  walk.w = 1.0 / walk.clip.w;
  walk.perOffset = vec3(view.ClipToView[0].w, view.ClipToView[1].w, view.ClipToView[2].w) *
    vec3(2.0 / view.Viewport.zw, 2.0);
  return walk;
}

// One side of a slice: its direction on the screen, and the linear functions that give the offset from P of a visible
// point, across the view and toward the eye. Window coordinates and depth are a projective map of
// positions, so both offsets are ratios of functions that are linear in window coordinates and depth.
struct WalkLine
{
  vec2 direction; // on the screen
  float pixels;   // length of the radius
  vec2 n;         // cosine and sine of the angle by which the normal leans to this side
  vec3 across;
  vec3 toward;
};

// Distance in pixels from a position to the viewport's border.
float walkToBorder(vec2 place, vec2 direction)
{
  vec2 border = view.Viewport.xy + mix(vec2(0.0), view.Viewport.zw, greaterThan(direction, vec2(0.0)));
  vec2 reach = (border - place) / mix(direction, vec2(1e-6), lessThan(abs(direction), vec2(1e-6)));
  return min(abs(reach.x), abs(reach.y));
}

// Linear function that maps an offset in the window to the offset along an axis in view coordinates, before division by
// w.
vec3 walkAxis(Walk walk, vec3 axis)
{
  vec4 plane = vec4(axis, -dot(axis, walk.P));
  return (plane * view.ClipToView).xyz * vec3(2.0 / view.Viewport.zw, 2.0);
}

// Side of a slice along T, a direction in view coordinates perpendicular to V. n: cosine and sine of the angle from V
// to the normal's projection into the slice. rise: walkAxis() of that projection.
WalkLine walkAlong(Walk walk, vec3 T, vec2 n, vec3 rise)
{
  WalkLine line;
  vec4 along = view.ViewToClip * vec4(T, 0.0);
  vec2 perUnit = 0.5 * view.Viewport.zw * (along.xy - walk.clip.xy * walk.w * along.w) * walk.w;
  float pixels = max(length(perUnit), 1e-30);
  line.direction = perUnit / pixels;
  line.pixels = radius * pixels;
  line.n = n;
  // The centre of a texel lies beside the slice. Its height over the tangent plane counts, so that no
  // plane occludes itself.
  vec3 run = walkAxis(walk, n.x * T - n.y * walk.V);
  line.across = rise * n.y + run * n.x;
  line.toward = rise * n.x - run * n.y;
  return line;
}

// The opposite side of the slice.
WalkLine walkBack(WalkLine line)
{
  return WalkLine(-line.direction, line.pixels, vec2(line.n.x, -line.n.y), -line.across, line.toward);
}

// Sample positions of a walk, from 0 to 1: first `steps` evenly spaced ones, then `refinements` that search for the
// edge of the highest occluder so far, which lies between two samples.
struct Search
{
  vec2 direction; // on the screen
  float reach;    // pixels to the last sample
  float best;
  float gap;
};

Search walkSearch(Walk walk, WalkLine line)
{
  // If the border is nearer than the next pixel, all samples are at the pixel itself.
  float border = walkToBorder(walk.place, line.direction);
  vec2 direction = border > 1.0 ? line.direction : vec2(0.0);
  return Search(direction, max(min(line.pixels, border - 0.01), 1.0), 0.0, 1.0 / float(steps));
}

float walkNext(Walk walk, inout Search search, int i)
{
  search.gap *= i < steps ? 1.0 : 0.5;
  return i < steps ? (float(i) + walk.shift) * search.gap : min(search.best + search.gap, 1.0);
}

// Offset of the surface that is visible at position t in [0, 1), across the view and toward the eye. Returns false if
// the surface does not rise over the pixel's tangent plane. Samples are denser near the pixel, where a small occluder
// fills a large angle.
bool walkStep(Walk walk, WalkLine line, Search search, float t, out vec2 seen)
{
  ivec2 at = ivec2(walk.place + search.direction * (1.0 + (search.reach - 1.0) * t * t));
  float depth = texelFetch(depthTexture, at, 0).r;
  vec3 offset = vec3(at - walk.pixel, depth - walk.depth);
  float scale = 1.0 / (walk.w + dot(walk.perOffset, offset));
  seen = vec2(max(dot(line.across, offset), 0.0), dot(line.toward, offset)) * scale;
  float rise = dot(seen, line.n.yx);
  return depth < 1.0 && rise > 0.0 && rise * rise > bias * bias * dot(seen, seen);
}
