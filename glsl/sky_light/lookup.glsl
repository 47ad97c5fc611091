// Light that arrives at a surface from the direction of one of the sky's maps. A map is four vectors, for positions
// relative to the maps' centre:
//   across, along:  xyz axes of the map in texels; w its middle in the atlas
//   depth:          xyz gradient of the depth in the map, against the direction of the light; w depth of the centre
//   weight:         rgb light from that direction, by the gradient; a depth of one texel's width
// Names that begin with "field" are private to a forward part. Needs lib/luminance.glsl and a
// sampler2D named fieldAtlas.
uniform float fieldHalf; // half the width of a map in texels

// What a texel shows lies in front of the surface's plane, so the light is occluded; on it; or behind it. The borders are
// distances from the plane, a constant and a part for each unit of its slope, in texels.
const vec2 GiSkyOnPlane = vec2(0.1, 0.05); // nearer in front, it is the surface
const vec2 GiSkyInFront = vec2(0.75, 0.5); // farther in front, it is an occluder; between the two it can be either
const vec2 GiSkyBehind = vec2(1.0, 1.0);   // farther behind, the texel is beyond the surface's edge
const float GiSkyDoubt = 0.02;             // weight of a texel that can be either
const float GiSkySteepest = 20.0;          // tangent of the steepest plane with which depths are compared

struct GiSkyReceiver
{
  vec3 P; // relative to the maps' centre
  vec3 N; // shading normal
  vec3 F; // normal of the flat facet
};

float giSkyOpen(vec4 across, vec4 along, float depth, float facing, float texel, GiSkyReceiver at)
{
  vec2 place = vec2(dot(across.xyz, at.P), dot(along.xyz, at.P));
  if (max(abs(place.x), abs(place.y)) > fieldHalf - 1.5)
  {
    return 1.0;
  }
  // Depth of the facet's plane at each texel, as in shadow_maps/sheet.glsl.
  float steepest = GiSkySteepest * texel;
  vec2 slope = vec2(dot(across.xyz, at.F), dot(along.xyz, at.F)) * (texel * texel / max(facing, 1e-6 * texel));
  slope = clamp(slope, -steepest, steepest);
  vec2 first = floor(place - 0.5);
  vec2 share = place - 0.5 - first;
  vec4 drawn = textureGather(fieldAtlas, (vec2(across.w, along.w) + first + 1.0) / vec2(textureSize(fieldAtlas, 0)));
  float plane = depth + dot(slope, first + 0.5 - place);
  vec4 planes = min(plane + vec4(slope.y, slope.x + slope.y, slope.x, 0.0), 1.0);
  vec4 inFront = planes - drawn;
  vec2 unit = vec2(texel, max(abs(slope.x), abs(slope.y)));
  vec4 occluded = step(dot(GiSkyInFront, unit), inFront);
  vec4 doubtful = step(dot(GiSkyOnPlane, unit), inFront) - occluded;
  vec4 beyond = step(dot(GiSkyBehind, unit), -inFront);
  // Texels beyond the edge tell nothing of the light on the surface. Beside an edge, as where the walls of a room meet,
  // doubtful ones are taken for occluders; elsewhere for relief finer than a texel.
  vec4 closed = any(greaterThan(beyond, vec4(0.0))) ? occluded + doubtful : occluded;
  vec2 rest = 1.0 - share;
  vec4 weights = (1.0 - beyond) * (1.0 - (1.0 - GiSkyDoubt) * doubtful) *
    vec4(rest.x * share.y, share.x * share.y, share.x * rest.y, rest.x * rest.y);
  float sum = dot(weights, vec4(1.0));
  return sum > 0.0 ? 1.0 - dot(weights, closed) / sum : 1.0;
}

// rgb: light that arrives; a: luminance of that light if nothing were occluded.
vec4 giSkyLight(vec4 across, vec4 along, vec4 depth, vec4 weight, GiSkyReceiver at)
{
  float cosine = -dot(at.N, depth.xyz);
  if (cosine <= 0.0)
  {
    return vec4(0.0);
  }
  vec3 light = cosine * weight.rgb;
  float open = giSkyOpen(across, along, dot(depth.xyz, at.P) + depth.w, -dot(at.F, depth.xyz), weight.a, at);
  return vec4(open * light, giLuminance(light));
}
