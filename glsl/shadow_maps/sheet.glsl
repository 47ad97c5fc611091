// The planes that a receiver lies in, as a shadow map sees them: depths are compared texel by texel with
// the planes' own, so that neither a texel's width nor a filter's needs a bias (receiver-plane depth
// bias: Isidoro 2006, Shadow Mapping: GPU-based Tips and Techniques; at the texels' centres: Dou et al.
// 2014, Adaptive Depth Bias for Shadow Maps). One plane is the receiver's own facet, the other one stands
// for the facets around it: the filter's texels lie in either. Needs shared/shadow.h and a sampler2D named
// atlas.
struct GiSheet
{
  int map;
  vec4 area;   // of the map in the atlas
  vec4 center; // of the receiver, in the atlas before division
  vec4 stepU;  // to points of the first plane one world unit off along two axes
  vec4 stepV;
  vec3 middle; // of the receiver, in the atlas
  vec4 slopes; // change of the planes' depths with the place in the atlas: xy first, zw second
};

vec2 giSlope(GiSheet sheet, vec4 stepU, vec4 stepV)
{
  vec3 du = stepU.xyz - sheet.middle * stepU.w;
  vec3 dv = stepV.xyz - sheet.middle * stepV.w;
  return vec2(du.z * dv.y - dv.z * du.y, dv.z * du.x - du.z * dv.x) / (du.x * dv.y - du.y * dv.x);
}

// U, V: across the light, slid along it into the first plane; rise: how much farther they go toward the
// light, at L, in the second plane.
GiSheet giSheet(int map, vec3 P, vec3 U, vec3 V, vec3 L, vec2 rise)
{
  mat4 toMap = shadowMaps[map].ViewToMap;
  GiSheet sheet;
  sheet.map = map;
  sheet.area = shadowMaps[map].Area;
  sheet.center = toMap * vec4(P, 1.0);
  sheet.stepU = toMap * vec4(U, 0.0);
  sheet.stepV = toMap * vec4(V, 0.0);
  sheet.middle = sheet.center.xyz / sheet.center.w;
  vec4 light = toMap * vec4(L, 0.0);
  sheet.slopes.xy = giSlope(sheet, sheet.stepU, sheet.stepV);
  sheet.slopes.zw = giSlope(sheet, sheet.stepU + rise.x * light, sheet.stepV + rise.y * light);
  return sheet;
}

// A point of the first plane in the atlas.
vec3 giPlace(GiSheet sheet, vec2 offset)
{
  vec4 at = sheet.center + offset.x * sheet.stepU + offset.y * sheet.stepV;
  return at.xyz / at.w;
}

bool giIsOutside(GiSheet sheet, vec3 at)
{
  return any(lessThan(at.xy, sheet.area.xy)) || any(greaterThan(at.xy, sheet.area.zw));
}

// Depth of the plane that is nearer to the light at a place.
float giPlaneDepth(GiSheet sheet, vec2 place)
{
  vec2 away = place - sheet.middle.xy;
  return sheet.middle.z + min(dot(sheet.slopes.xy, away), dot(sheet.slopes.zw, away));
}

// Depth of the texel that a place falls into, and the planes' there.
vec2 giDepths(GiSheet sheet, vec3 at)
{
  vec2 size = vec2(textureSize(atlas, 0));
  vec2 texel = floor(clamp(at.xy, sheet.area.xy, sheet.area.zw) * size);
  float plane = giPlaneDepth(sheet, (texel + 0.5) / size);
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
  vec2 corner = (first + 0.5) / size;
  vec2 next = 1.0 / size;
  vec4 plane = vec4(giPlaneDepth(sheet, corner + vec2(0.0, next.y)), giPlaneDepth(sheet, corner + next),
    giPlaneDepth(sheet, corner + vec2(next.x, 0.0)), giPlaneDepth(sheet, corner));
  // Nothing is farther than the far plane, where the map is empty.
  vec4 open = step(min(plane, 1.0), drawn);
  vec2 columns = mix(open.wx, open.zy, share.x);
  return mix(columns.x, columns.y, share.y);
}
