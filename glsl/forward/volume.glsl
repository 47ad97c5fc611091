// Inserted into the shaders of shaded volumes: indirect light at a sample. Needs forward/indirect.glsl.
// Distance along a ray after which the light is looked up again, as a share of the length over which light varies. A
// lookup at each sample would be slow.
const float GI_ASK_AGAIN = 0.125;
// Change between neighbouring data points, as a share of the data's range, from which on a sample is shaded as a
// surface. Where the data is constant, light is scattered evenly; in between, the two are blended.
const float GI_STEEP = 0.001;

vec3 giCube[6];
vec3 giCubePlace = vec3(0.0);
bool giCubeKnown = false;

// Change between neighbouring data points, as a share of the data's range. gradient: as from VTK's computeGradient().
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
  // Turn the normal to the viewer, whichever way the data increases.
  N *= (dot(N, V) < 0.0 ? -1.0 : 1.0) / size;
  return mix(mean, giCubeLight(giCube, N), clamp(giChange(gradient, spacing) / GI_STEEP, 0.0, 1.0));
}
