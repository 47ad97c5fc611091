// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of the surroundings, a picture of longitude and latitude as VTK lays it out, and
// directions picked in proportion to it. Needs shared/ray_surface.h. Variant: GI_RAY_SKY_CELLS (see raySkyMean).
layout(binding = GI_RAY_SKY_UNIT) uniform sampler2DArray raySky; // for matter; for highlights where that differs
#ifdef GI_RAY_SKY_CELLS
layout(binding = GI_RAY_SKY_CELLS_UNIT) uniform sampler2D raySkyCells;
#endif
layout(binding = GI_RAY_SKY_TABLE_UNIT) uniform sampler2D raySkyTable;
uniform mat3 sceneToSky;
uniform ivec2 skyCells;

const float SKY_PI = 3.14159265358979;

vec2 raySkyPlace(vec3 direction)
{
  vec3 d = sceneToSky * direction;
  return vec2(atan(d.z, d.x) / (2.0 * SKY_PI), asin(clamp(d.y, -1.0, 1.0)) / SKY_PI) + 0.5;
}

vec3 raySkyRadiance(vec3 direction)
{
  return textureLod(raySky, vec3(raySkyPlace(direction), 0.0), 0.0).rgb;
}

// What highlights reflect: VTK may decode the picture otherwise for them. A layer that is not there is the last.
vec3 raySkyGloss(vec3 direction)
{
  return textureLod(raySky, vec3(raySkyPlace(direction), 1.0), 0.0).rgb;
}

#ifdef GI_RAY_SKY_CELLS
// The mean over the part of the sphere that a ray stands for, where a few rays are spread evenly: single rays would miss
// a sun, or take it for as large as that part.
vec3 raySkyMean(vec3 direction)
{
  vec3 d = sceneToSky * direction;
  return textureLod(raySkyCells, vec2(atan(d.z, d.x) / (2.0 * SKY_PI), 0.5 * d.y) + 0.5, 0.0).rgb;
}
#endif

float raySkyCumulative(int row, int cell)
{
  return texelFetch(raySkyTable, ivec2(cell, row), 0).r;
}

// The last cell of a row of the table that begins at u or before.
int raySkyFind(int row, int cells, float u)
{
  int low = 0;
  int high = cells;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool before = raySkyCumulative(row, middle) <= u;
    low = before ? middle : low;
    high = before ? high : middle;
  }
  return low;
}

// Per solid angle, for a direction at this place of the picture.
float raySkyDensityAt(ivec2 cell)
{
  float band = raySkyCumulative(skyCells.y, cell.y + 1) - raySkyCumulative(skyCells.y, cell.y);
  float part = raySkyCumulative(cell.y, cell.x + 1) - raySkyCumulative(cell.y, cell.x);
  vec2 latitude = (vec2(cell.y, cell.y + 1) / float(skyCells.y) - 0.5) * SKY_PI;
  float angle = 2.0 * SKY_PI / float(skyCells.x) * (sin(latitude.y) - sin(latitude.x));
  return band * part / angle;
}

float raySkyDensity(vec3 direction)
{
  ivec2 cell = ivec2(raySkyPlace(direction) * vec2(skyCells));
  return raySkyDensityAt(clamp(cell, ivec2(0), skyCells - 1));
}

// Evenly within the cell that u picks.
vec3 raySkySample(vec2 u, out float density)
{
  ivec2 cell;
  cell.y = raySkyFind(skyCells.y, skyCells.y, u.y);
  cell.x = raySkyFind(cell.y, skyCells.x, u.x);
  vec2 from = vec2(raySkyCumulative(cell.y, cell.x), raySkyCumulative(skyCells.y, cell.y));
  vec2 to = vec2(raySkyCumulative(cell.y, cell.x + 1), raySkyCumulative(skyCells.y, cell.y + 1));
  vec2 within = clamp((u - from) / max(to - from, vec2(1e-20)), 0.0, 1.0);
  float longitude = ((float(cell.x) + within.x) / float(skyCells.x) - 0.5) * 2.0 * SKY_PI;
  vec2 heights = sin((vec2(cell.y, cell.y + 1) / float(skyCells.y) - 0.5) * SKY_PI);
  float height = mix(heights.x, heights.y, within.y);
  float radius = sqrt(max(0.0, 1.0 - height * height));
  density = raySkyDensityAt(cell);
  return transpose(sceneToSky) * vec3(radius * cos(longitude), height, radius * sin(longitude));
}
