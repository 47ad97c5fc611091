// Light that arrives at a surface from the direction of one of the sky's maps. A map is four vectors, for positions
// relative to the maps' centre:
//   across, along:  xyz axes of the map in texels; w its middle in the atlas
//   depth:          xyz gradient of the depth in the map, against the direction of the light; w depth of the centre
//   weight:         rgb light from that direction, by the gradient; a depth of one texel's width
// Names that begin with "field" are private to a forward part. Needs lib/luminance.glsl and a
// sampler2D named fieldAtlas.
uniform float fieldHalf; // half the width of a map in texels

// Biases as for shadow maps, in texels.
const float GiSkyConstantBias = 0.2;
const float GiSkySlopeBias = 0.1;
const float GiSkySteepest = 20.0; // tangent of the steepest plane with which depths are compared

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
  float plane = depth + dot(slope, first + 0.5 - place) - GiSkyConstantBias * texel -
    GiSkySlopeBias * max(abs(slope.x), abs(slope.y));
  vec4 open = step(min(plane + vec4(slope.y, slope.x + slope.y, slope.x, 0.0), 1.0), drawn);
  vec2 columns = mix(open.wx, open.zy, share.x);
  return mix(columns.x, columns.y, share.y);
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
