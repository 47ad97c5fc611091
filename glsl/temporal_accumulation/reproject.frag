#version 430 core
// Reprojection: finds a pixel's surface in the previous frame and the number of consecutive frames in which it was
// visible, and stores the surface for the next frame.
// A pixel around that position is accepted if it lay in the same plane, had a similar normal and belonged to the same
// object (Nehab et al. 2007, Accelerating Real-Time Shading with Reverse Reprojection Caching).
// Variants: GI_STILL (nothing moves), GI_PROPS_MOVE (props move, not only the camera),
// GI_DISPLACEMENT (some props deform).
#include "shared/view.h"
#include "shared/material.h"
#include "shared/motion.h"
#include "lib/octahedral.glsl"
#include "lib/reconstruct.glsl"
#include "temporal_accumulation/surface.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D surfaceTexture; // of the previous frame
layout(binding = 3) uniform sampler2D displacementTexture;

#ifdef GI_STILL
const int taps = 1;
#else
const int taps = 4; // pixels around the reprojected position
#endif

uniform vec2 tolerance; // x: distance from the plane, relative to the depth; y: cosine between normals
uniform float most;     // maximum number of frames in a mean
uniform bool continued; // whether there is a history of the previous frame

// xy: offset to the position in the previous frame, in pixels; z: number of consecutive frames, including this one;
// w: bit mask of the accepted pixels among the four around that position.
layout(location = 0) out vec4 result;
layout(location = 1) out vec4 remembered;

vec2 windowOf(mat4 viewToClip, vec3 position)
{
  vec4 clip = viewToClip * vec4(position, 1.0);
  return view.Viewport.xy + (clip.xy / clip.w * 0.5 + 0.5) * view.Viewport.zw;
}

// View-space position of a pixel in the previous frame, at a view depth.
vec3 previousPosition(ivec2 pixel, float depth)
{
  mat4 m = motion.PreviousViewToClip;
  vec2 ndc = (vec2(pixel) + 0.5 - view.Viewport.xy) / view.Viewport.zw * 2.0 - 1.0 - motion.PreviousShift.xy;
  float w = m[2].w * depth + m[3].w;
  return vec3((ndc * w - m[2].xy * depth - m[3].xy) / vec2(m[0].x, m[1].y), depth);
}

// Area on the screen of a small piece of a surface, up to a factor that is the same in all frames.
float areaOf(mat4 viewToClip, vec3 normal, vec3 position)
{
  float w = viewToClip[2].w * position.z + viewToClip[3].w;
  vec3 along = viewToClip[2].w == 0.0 ? vec3(0.0, 0.0, 1.0) : position / w; // of a ray through the pixel
  return abs(dot(normal, along) * viewToClip[0].x * viewToClip[1].y) / (w * w);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 packedNormal = texelFetch(normalTexture, pixel, 0);
  vec3 P = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r);
  vec3 N = giDecodeOctahedral(packedNormal.xy);
  int index = int(packedNormal.z * 65535.0 + 0.5);
  int object = materials[index].Model.w;
#ifdef GI_STILL
  vec3 previousP = P;
  vec3 previousN = N;
#else
  mat4 toPrevious = motion.ToPrevious;
#ifdef GI_PROPS_MOVE
  int row = materials[index].Model.z;
  if (row > 0)
  {
    toPrevious = motions[row];
  }
#endif
  vec3 previousP = P;
#ifdef GI_DISPLACEMENT
  previousP += texelFetch(displacementTexture, pixel, 0).xyz;
#endif
  previousP = (toPrevious * vec4(previousP, 1.0)).xyz;
  vec3 previousN = mat3(toPrevious) * N;
#endif

#ifdef GI_STILL
  vec2 moved = vec2(0.0);
#else
  vec2 moved = windowOf(motion.PreviousViewToClip, previousP) - windowOf(motion.ViewToClip, P);
  // A static surface is fetched exactly, not blended with its neighbours because of rounding.
  moved = max(abs(moved.x), abs(moved.y)) < 1e-2 ? vec2(0.0) : moved;
#endif
  vec2 place = vec2(pixel) + moved;
  vec2 corner = floor(place);
  vec2 weight = place - corner;

  ivec2 low = ivec2(view.Viewport.xy);
  ivec2 high = low + ivec2(view.Viewport.zw);
  int accepted = 0;
  float frames = 0.0;
  float weights = 0.0;
  for (int i = 0; i < taps && continued; ++i)
  {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 at = ivec2(corner) + offset;
    vec2 share = mix(1.0 - weight, weight, vec2(offset));
    if (share.x * share.y < 1e-3 || any(lessThan(at, low)) || any(greaterThanEqual(at, high)))
    {
      continue;
    }
    GiSurfaceRecord record = giUnpackSurface(texelFetch(surfaceTexture, at, 0));
    vec3 recordP = previousPosition(at, record.depth);
    float planeDistance = abs(dot(previousN, recordP - previousP));
    if (record.object == object && planeDistance < tolerance.x * abs(previousP.z) &&
      dot(record.normal, previousN) > tolerance.y)
    {
      accepted |= 1 << i;
      frames += share.x * share.y * record.frames;
      weights += share.x * share.y;
    }
  }
#ifndef GI_STILL
  // Histories of surfaces that were seen at a sharper angle or from further away are too coarse for what is seen now.
  float area = areaOf(motion.ViewToClip, N, P);
  frames *= min(areaOf(motion.PreviousViewToClip, previousN, previousP) / max(area, 1e-30), 1.0);
#endif
  frames = weights > 0.0 ? min(frames / weights + 1.0, most) : 1.0;
  result = vec4(moved, frames, float(accepted));
  remembered = giPackSurface(GiSurfaceRecord(N, P.z, object, frames));
}
