// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Edges of cells, drawn over the surface that the eye sees, as lines whose width is in pixels, as
// VTK's mappers draw them. Needs rays/surface.glsl, shared/view.h.

// Distance in pixels from a point of the window to the nearest drawn edge of a triangle. corner: corners in view
// coordinates; hidden: a bit for each edge that is not drawn, the first bit for the edge from the first to the second
// corner.
float edgeDistance(vec3 corner[3], uint hidden, vec2 pixel)
{
  vec2 window[3];
  for (int i = 0; i < 3; ++i)
  {
    vec4 clip = view.ViewToClip * vec4(corner[i], 1.0);
    window[i] = (clip.xy / clip.w * 0.5 + 0.5) * view.Viewport.zw + view.Viewport.xy;
  }
  float nearest = 1e30;
  for (int i = 0; i < 3; ++i)
  {
    vec2 along = normalize(window[(i + 1) % 3] - window[i]);
    vec2 to = pixel - window[i];
    bool drawn = (hidden >> i & 1u) == 0u;
    nearest = drawn ? min(nearest, abs(along.x * to.y - along.y * to.x)) : nearest;
  }
  return nearest;
}

// The surface point with the edges drawn over its colour.
RaySurfacePoint withEdges(RaySurfacePoint at, RayHit hit, mat3 sceneToView, vec3 eye, vec2 pixel)
{
  RaySurface surface = raySurfaces[at.surface];
  if (surface.Edge.a <= 0.0)
  {
    return at;
  }
  int record = hit.instance * GI_RAY_INSTANCE_TEXELS;
  vec4 x = rayInstance(record);
  vec4 y = rayInstance(record + 1);
  vec4 z = rayInstance(record + 2);
  mat3 toScene = inverse(transpose(mat3(x.xyz, y.xyz, z.xyz)));
  vec3 corner[3];
  for (int i = 0; i < 3; ++i)
  {
    vec3 p = rayPrimitive(hit.primitive * GI_RAY_PRIMITIVE_TEXELS + i).xyz;
    corner[i] = sceneToView * (toScene * (p - vec3(x.w, y.w, z.w)) - eye);
  }
  uint hidden = texelFetch(rayAttributes, surface.Where.x + at.primitive).x >> GI_RAY_EDGE_SHIFT;
  float width = surface.Edge.a;
  float coverage = clamp(0.5 + 0.5 * width - edgeDistance(corner, hidden, pixel), 0.0, 1.0) *
    surface.More.w;
  at.color.rgb *= 1.0 - coverage;
  bool pbr = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PBR;
  at.emission = pbr ? at.emission : mix(at.emission, surface.Edge.rgb, coverage);
  return at;
}
