// Into the fragment shaders of what VTK draws itself: indirect light, of the GI_PARTS techniques that know it in
// space, in their order; each counts as far as those before do not know the point. A technique gives, in view
// coordinates (V: unit, to where the point is seen from; reach: how far that is):
//   vec4 fieldIndirect(vec3 P, vec3 N, vec3 V, float reach)                       what arrives at a surface, divided by pi,
//                                                                                 times a; a the share that is known
//   float fieldIndirectCube(vec3 P, vec3 V, float reach, out vec3 cube[6])        likewise from all around, see
//                                                                                 lib/cube_light.glsl; returns a
//   float fieldGrain()                                                            lengths over which light varies
// What is declared under a name that begins with "field" goes by a name of its part's own here: giField0Indirect.
uniform bool giParallelRays;

vec3 giToEye(vec3 P, out float reach)
{
  reach = length(P);
  return giParallelRays ? vec3(0.0, 0.0, 1.0) : -P / max(reach, 1e-20);
}

// At a surface. VTK's edges drawn as tubes shorten the normal, where they blend into the surface.
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
