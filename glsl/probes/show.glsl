// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws balls at the probes over the picture: white, lit by the light that each of them holds, with a coloured rim if
// the probe has been relocated or rests. Needs shared/view.h, lib/reconstruct.glsl, probes/field.glsl,
// probes/spheres.glsl, and from the including shader
//   vec3 probeIrradiance(int probe, vec3 N): irradiance divided by pi;
//   bool probeIsResting(int probe): whether it is rarely updated, as no surface uses it;
//   const int PROBE_STRAYS: maximum distance of a probe from its own cell, in cells.
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D before;

uniform mat3 viewToScene;
uniform vec3 eye; // relative to the scene's origin
uniform float radius; // in cells

layout(location = 0) out vec4 color;

// Rim colours, chosen to differ from each other and from the light of most scenes, also for colour-blind people.
const vec3 MOVED = vec3(1.0, 0.42, 0.0);
const vec3 RESTING = vec3(0.0, 0.35, 1.0);
const float RIM = 0.6; // cosine to the eye: a fifth of the radius

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = texelFetch(before, pixel, 0);
  vec3 near = giViewPosition(gl_FragCoord.xy, 0.0);
  vec3 path = giViewPosition(gl_FragCoord.xy, texelFetch(depthTexture, pixel, 0).r) - near;
  vec3 toward = viewToScene * normalize(path);
  vec3 origin = eye + viewToScene * near;
  float at = length(path);
  int probe = -1;
  vec3 N;
  for (int i = 0; i < fieldGrids; ++i)
  {
    fieldGrid grid = fieldGridOf(i);
    float size = radius * fieldCellSize(grid);
    int found = fieldSphere(grid, origin, toward, size, PROBE_STRAYS, at);
    if (found >= 0)
    {
      probe = found;
      N = (origin + at * toward - fieldPosition(grid, found)) / size;
    }
  }
  if (probe < 0)
  {
    return;
  }
  bool rim = -dot(N, toward) < RIM;
  bool moved = texelFetch(fieldProbes, fieldTile(probe), 0).xyz != vec3(0.0);
  color.rgb = rim && moved ? MOVED : (rim && probeIsResting(probe) ? RESTING : probeIrradiance(probe, N));
}
