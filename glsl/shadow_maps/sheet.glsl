// Receiver planes as a shadow map sees them. Each texel's depth is compared with the depth of the planes at that texel,
// so that neither the width of a texel nor that of the filter needs a bias (receiver-plane depth
// bias: Isidoro 2006, Shadow Mapping: GPU-based Tips and Techniques; at texel centres: Dou et al.
// 2014, Adaptive Depth Bias for Shadow Maps). One plane is the receiver's own facet, the other one represents
// the surrounding facets; a texel of the filter lies in one of them. Needs shared/shadow.h and a sampler2D named
// atlas.
struct GiSheet
{
  int map;
  vec4 area;   // the map's area in the atlas
  vec4 center; // the receiver in the atlas, before division by w
  vec4 stepU;  // steps in the first plane, one world unit along two axes
  vec4 stepV;
  vec3 middle; // the receiver in the atlas
  vec4 slopes; // gradients of the planes' depths in the atlas: xy first plane, zw second plane
};

vec2 giSlope(GiSheet sheet, vec4 stepU, vec4 stepV)
{
  vec3 du = stepU.xyz - sheet.middle * stepU.w;
  vec3 dv = stepV.xyz - sheet.middle * stepV.w;
  return vec2(du.z * dv.y - dv.z * du.y, dv.z * du.x - du.z * dv.x) / (du.x * dv.y - du.y * dv.x);
}

// U, V: axes across the light, slid along it into the first plane; L: toward the light; rise: additional rise of the
// axes along L in the second plane.
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

// Atlas position of a point of the first plane.
vec3 giAtlasPosition(GiSheet sheet, vec2 offset)
{
  vec4 at = sheet.center + offset.x * sheet.stepU + offset.y * sheet.stepV;
  return at.xyz / at.w;
}

bool giIsOutside(GiSheet sheet, vec3 at)
{
  return any(lessThan(at.xy, sheet.area.xy)) || any(greaterThan(at.xy, sheet.area.zw));
}

// Depth of the plane that is nearer to the light at a position in the atlas.
float giPlaneDepth(GiSheet sheet, vec2 place)
{
  vec2 away = place - sheet.middle.xy;
  return sheet.middle.z + min(dot(sheet.slopes.xy, away), dot(sheet.slopes.zw, away));
}

// Depth in the map at an atlas position, and the depth of the planes at that texel.
vec2 giMapAndPlaneDepth(GiSheet sheet, vec3 at)
{
  vec2 size = vec2(textureSize(atlas, 0));
  vec2 texel = floor(clamp(at.xy, sheet.area.xy, sheet.area.zw) * size);
  float plane = giPlaneDepth(sheet, (texel + 0.5) / size);
  return vec2(texelFetch(atlas, ivec2(texel), 0).r, min(plane, 1.0));
}

// Lit share of the four texels around an atlas position (Reeves, Salesin and Cook 1987, with bilinear weights).
float giLitShare(GiSheet sheet, vec3 at)
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
  // An empty texel holds the far plane's depth, which a receiver must not exceed.
  vec4 open = step(min(plane, 1.0), drawn);
  vec2 columns = mix(open.wx, open.zy, share.x);
  return mix(columns.x, columns.y, share.y);
}
