// Inserted into the fragment shaders of props that VTK draws itself: indirect light from the GI_PARTS techniques that
// know it in space. In their order, each covers the share of a point's light that the previous ones do not know. A
// technique supplies, in view coordinates (V: unit vector to the viewpoint; reach: distance to it):
//   vec4 fieldIndirect(vec3 P, vec3 N, vec3 V, float reach)
//       a: share of the light that is known; rgb: irradiance at a surface divided by pi, times a
//   float fieldIndirectCube(vec3 P, vec3 V, float reach, out vec3 cube[6])
//       the same for the six axis directions, see lib/cube_light.glsl; returns a
//   float fieldGrain()
//       length over which the light varies
// Names that begin with "field" are private to a part. They are renamed per part, for example to giField0Indirect.
uniform bool giParallelRays;

vec3 giToEye(vec3 P, out float reach)
{
  reach = length(P);
  return giParallelRays ? vec3(0.0, 0.0, 1.0) : -P / max(reach, 1e-20);
}

// Indirect light at a surface. Edges that VTK draws as tubes shorten the normal where they blend into the surface.
vec4 giIndirect(vec3 P, vec3 N)
{
  float size = length(N);
  N /= max(size, 1e-20);
  float reach;
  vec3 V = giToEye(P, reach);
  vec4 light = giField0Indirect(P, N, V, reach);
#if GI_PARTS > 1
  if (light.a < 1.0)
  {
    light += (1.0 - light.a) * giField1Indirect(P, N, V, reach);
  }
#endif
  return vec4(size * light.rgb, light.a);
}

float giIndirectCube(vec3 P, vec3 V, float reach, out vec3 cube[6])
{
  float known = giField0IndirectCube(P, V, reach, cube);
#if GI_PARTS > 1
  if (known < 1.0)
  {
    vec3 next[6];
    float more = giField1IndirectCube(P, V, reach, next);
    for (int side = 0; side < 6; ++side)
    {
      cube[side] += (1.0 - known) * next[side];
    }
    known += (1.0 - known) * more;
  }
#endif
  return known;
}

float giGrain()
{
#if GI_PARTS > 1
  return min(giField0Grain(), giField1Grain());
#else
  return giField0Grain();
#endif
}
