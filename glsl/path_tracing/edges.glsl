// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The edges of cells, drawn over the surface that the eye looks at: lines of a width in pixels, as
// VTK's mappers draw them. Needs rays/surface.glsl, shared/view.h.

// Pixels from a point of the window to the nearest edge of a triangle that is drawn. corner: in view
// coordinates; hidden: a bit for each edge, the first from the first corner to the second.
float edgeDistance(vec3 corner[3], uint hidden, vec2 pixel)
{
  vec2 place[3];
  for (int i = 0; i < 3; ++i)
  {
    vec4 clip = view.ViewToClip * vec4(corner[i], 1.0);
    place[i] = (clip.xy / clip.w * 0.5 + 0.5) * view.Viewport.zw + view.Viewport.xy;
  }
  float nearest = 1e30;
  for (int i = 0; i < 3; ++i)
  {
    vec2 along = normalize(place[(i + 1) % 3] - place[i]);
    vec2 to = pixel - place[i];
    bool drawn = (hidden >> i & 1u) == 0u;
    nearest = drawn ? min(nearest, abs(along.x * to.y - along.y * to.x)) : nearest;
  }
  return nearest;
}

// The surface point as it looks with its edges drawn.
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
  float share = clamp(0.5 + 0.5 * width - edgeDistance(corner, hidden, pixel), 0.0, 1.0) *
    surface.More.w;
  at.color.rgb *= 1.0 - share;
  bool pbr = (surface.Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PBR;
  at.emission = pbr ? at.emission : mix(at.emission, surface.Edge.rgb, share);
  return at;
}
