// The plane that a receiver lies in, as a shadow map sees it: depths are compared texel by texel with
// the plane's own, so that neither a texel's width nor a filter's needs a bias (receiver-plane depth
// bias: Isidoro 2006, Shadow Mapping: GPU-based Tips and Techniques; at the texels' centres: Dou et al.
// 2014, Adaptive Depth Bias for Shadow Maps). Needs shared/shadow.h and a sampler2D named atlas.
struct GiSheet
{
  int map;
  vec4 area;   // of the map in the atlas
  vec4 center; // of the receiver, in the atlas before division
  vec4 stepU;  // to points of the plane one world unit off along two axes
  vec4 stepV;
  vec2 slope;  // change of the plane's depth with the place in the atlas
};

GiSheet giSheet(int map, vec3 P, vec3 U, vec3 V)
{
  mat4 toMap = shadowMaps[map].ViewToMap;
  GiSheet sheet;
  sheet.map = map;
  sheet.area = shadowMaps[map].Area;
  sheet.center = toMap * vec4(P, 1.0);
  sheet.stepU = toMap * vec4(U, 0.0);
  sheet.stepV = toMap * vec4(V, 0.0);
  vec3 at = sheet.center.xyz / sheet.center.w;
  vec3 du = sheet.stepU.xyz - at * sheet.stepU.w;
  vec3 dv = sheet.stepV.xyz - at * sheet.stepV.w;
  sheet.slope = vec2(du.z * dv.y - dv.z * du.y, dv.z * du.x - du.z * dv.x) /
    (du.x * dv.y - du.y * dv.x);
  return sheet;
}

// A point of the plane in the atlas.
vec3 giPlace(GiSheet sheet, vec2 offset)
{
  vec4 at = sheet.center + offset.x * sheet.stepU + offset.y * sheet.stepV;
  return at.xyz / at.w;
}

bool giIsOutside(GiSheet sheet, vec3 at)
{
  return any(lessThan(at.xy, sheet.area.xy)) || any(greaterThan(at.xy, sheet.area.zw));
}

// Depth of the texel that a place falls into, and the plane's there.
vec2 giDepths(GiSheet sheet, vec3 at)
{
  vec2 size = vec2(textureSize(atlas, 0));
  vec2 texel = floor(clamp(at.xy, sheet.area.xy, sheet.area.zw) * size);
  float plane = at.z + dot(sheet.slope, (texel + 0.5) / size - at.xy);
  return vec2(texelFetch(atlas, ivec2(texel), 0).r, min(plane, 1.0));
}

// The share of the four texels around a place that the light reaches, by their distance (Reeves, Salesin
// and Cook 1987, with bilinear weights).
float giOpen(GiSheet sheet, vec3 at)
{
  vec2 size = vec2(textureSize(atlas, 0));
  vec2 texel = clamp(at.xy, sheet.area.xy, sheet.area.zw) * size - 0.5;
  vec2 first = floor(texel);
  vec2 share = texel - first;
  vec4 drawn = textureGather(atlas, (first + 1.0) / size); // (0,1) (1,1) (1,0) (0,0)
  vec2 rise = sheet.slope / size;
  float plane = at.z + dot(sheet.slope, (first + 0.5) / size - at.xy);
  // Nothing is farther than the far plane, where the map is empty.
  vec4 open = step(min(plane + vec4(rise.y, rise.x + rise.y, rise.x, 0.0), 1.0), drawn);
  vec2 columns = mix(open.wx, open.zy, share.x);
  return mix(columns.x, columns.y, share.y);
}
