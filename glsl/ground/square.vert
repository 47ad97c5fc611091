#version 430 core
// The square around the ground's disc.
#include "shared/view.h"
#include "lib/reconstruct.glsl"
#include "ground/plane.glsl"

invariant gl_Position; // draws after the first compare depths for equality

void main()
{
  const vec2 corners[6] = vec2[](vec2(-1.0, -1.0), vec2(1.0, -1.0), vec2(1.0, 1.0), vec2(-1.0, -1.0), vec2(1.0, 1.0),
    vec2(-1.0, 1.0));
  vec3 across = normalize(cross(plane.xyz, abs(plane.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  vec3 along = cross(plane.xyz, across);
  vec2 corner = disc.w * corners[gl_VertexID];
  gl_Position = view.ViewToClip * vec4(disc.xyz + corner.x * across + corner.y * along, 1.0);
}
