// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Images on surfaces, filtered as a texture unit does. There are no mipmaps, as the many paths through a pixel
// average them. Needs shared/ray_surface.h with GI_RAY_PICTURES.

vec4 rayPixel(int first, uvec4 shape, ivec2 at)
{
  int index = at.y * int(shape.x) + at.x;
  vec4 value;
  if ((shape.z & GI_PICTURE_FLOATS) != 0u)
  {
    value = uintBitsToFloat(texelFetch(rayPictures, first + index));
  }
  else
  {
    value = unpackUnorm4x8(texelFetch(rayPictures, first + (index >> 2))[index & 3]);
  }
  if ((shape.z & GI_PICTURE_SRGB) != 0u)
  {
    vec3 low = value.rgb / 12.92;
    vec3 high = pow((value.rgb + 0.055) / 1.055, vec3(2.4));
    value.rgb = mix(high, low, vec3(lessThanEqual(value.rgb, vec3(0.04045))));
  }
  return value;
}

// Wraps the coordinates of a pixel outside the image. Returns false where the border's colour applies.
bool rayWrap(int mode, ivec2 size, inout ivec2 at)
{
  bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size));
  if (mode == GI_PICTURE_REPEAT)
  {
    at -= size * ivec2(floor(vec2(at) / vec2(size)));
  }
  else if (mode == GI_PICTURE_MIRROR)
  {
    at -= 2 * size * ivec2(floor(vec2(at) / vec2(2 * size)));
    at = min(at, 2 * size - 1 - at);
  }
  at = clamp(at, ivec2(0), size - 1);
  return inside || mode != GI_PICTURE_BORDER;
}

vec4 rayPicture(int head, vec2 coordinates)
{
  uvec4 shape = texelFetch(rayPictures, head);
  ivec2 size = ivec2(shape.xy);
  int mode = int(shape.z >> GI_PICTURE_WRAP_SHIFT) & 3;
  int first = head + 2;
  // Beyond this limit floats no longer distinguish pixels. NaN shows the first pixel.
  vec2 position = clamp(coordinates, vec2(-1e6), vec2(1e6)) * vec2(size);
  position = mix(position, vec2(0.0), isnan(coordinates));
  bool nearest = (shape.z & GI_PICTURE_NEAREST) != 0u;
  vec2 corner = nearest ? floor(position) : floor(position - 0.5);
  vec2 weight = nearest ? vec2(0.0) : position - 0.5 - corner;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < (nearest ? 1 : 4); ++i)
  {
    ivec2 step = ivec2(i & 1, i >> 1);
    ivec2 at = ivec2(corner) + step;
    bool inside = rayWrap(mode, size, at);
    vec4 value = inside ? rayPixel(first, shape, at)
                        : uintBitsToFloat(texelFetch(rayPictures, head + 1));
    vec2 share = mix(1.0 - weight, weight, vec2(step));
    sum += share.x * share.y * value;
  }
  return sum;
}
