// Into the shaders of shaded volumes: indirect light at a sample. Needs forward/indirect.glsl.
// Which probes a sample sees is asked where its ray has gone this share of what light varies over, not at each.
const float GI_ASK_AGAIN = 0.125;
// A sample is taken for one of a surface where the data changes by this share of its range, or more, from one point
// of the data to the next; where it is constant, light goes on from there evenly. Between, both.
const float GI_STEEP = 0.001;

vec3 giCube[6];
vec3 giCubePlace = vec3(0.0);
bool giCubeKnown = false;

// How much the data changes from one of its points to the next, in its range. gradient: as VTK's computeGradient() has it.
float giChange(vec4 gradient, vec3 spacing)
{
  float mean = (spacing.x + spacing.y + spacing.z) / 3.0;
  return gradient.w < 0.0 ? 0.5 * mean * length(gradient.xyz) : 0.25 * gradient.w;
}

vec3 giScattered(vec4 place, vec4 gradient, mat4 textureToEye, vec3 spacing)
{
  vec3 P = place.xyz / place.w;
  float reach;
  vec3 V = giToEye(P, reach);
  if (!giCubeKnown || distance(P, giCubePlace) > GI_ASK_AGAIN * giGrain())
  {
    giIndirectCube(P, V, reach, giCube);
    giCubePlace = P;
    giCubeKnown = true;
  }
  vec3 N = (textureToEye * vec4(gradient.xyz, 0.0)).xyz;
  float size = length(N);
  vec3 mean = giCubeMean(giCube);
  if (size <= 0.0)
  {
    return mean;
  }
  // The side that is seen, whichever way the data grows.
  N *= (dot(N, V) < 0.0 ? -1.0 : 1.0) / size;
  return mix(mean, giCubeLight(giCube, N), clamp(giChange(gradient, spacing) / GI_STEEP, 0.0, 1.0));
}
