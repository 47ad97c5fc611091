// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Radiance of the environment, an equirectangular image in VTK's layout, and importance sampling of its directions.
// Needs shared/ray_surface.h. Variant: GI_RAY_SKY_CELLS (see raySkyMean).
layout(binding = GI_RAY_SKY_UNIT) uniform sampler2DArray raySky; // layer 0: diffuse; layer 1: highlights, if different
#ifdef GI_RAY_SKY_CELLS
layout(binding = GI_RAY_SKY_CELLS_UNIT) uniform sampler2D raySkyCells;
#endif
layout(binding = GI_RAY_SKY_TABLE_UNIT) uniform sampler2D raySkyTable;
uniform mat3 sceneToSky;
uniform ivec2 skyCells;

const float SKY_PI = 3.14159265358979;

vec2 raySkyCoordinates(vec3 direction)
{
  vec3 d = sceneToSky * direction;
  return vec2(atan(d.z, d.x) / (2.0 * SKY_PI), asin(clamp(d.y, -1.0, 1.0)) / SKY_PI) + 0.5;
}

vec3 raySkyRadiance(vec3 direction)
{
  return textureLod(raySky, vec3(raySkyCoordinates(direction), 0.0), 0.0).rgb;
}

// Radiance that highlights reflect, for which VTK may decode the image differently. Without a second layer the lookup
// is clamped to the first.
vec3 raySkyGloss(vec3 direction)
{
  return textureLod(raySky, vec3(raySkyCoordinates(direction), 1.0), 0.0).rgb;
}

#ifdef GI_RAY_SKY_CELLS
// Mean radiance over the solid angle that one of a few evenly distributed rays represents. A point lookup would miss
// a sun, or make it as large as that solid angle.
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

// Finds the last cell in a row of the table that begins at or before u.
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

// Probability density per solid angle of the directions in a cell.
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
  ivec2 cell = ivec2(raySkyCoordinates(direction) * vec2(skyCells));
  return raySkyDensityAt(clamp(cell, ivec2(0), skyCells - 1));
}

// Samples a direction: u selects a cell, and the density is uniform within it.
vec3 raySkySample(vec2 u, out float density)
{
  ivec2 cell;
  cell.y = raySkyFind(skyCells.y, skyCells.y, u.y);
  cell.x = raySkyFind(cell.y, skyCells.x, u.x);
  vec2 cellBegin = vec2(raySkyCumulative(cell.y, cell.x), raySkyCumulative(skyCells.y, cell.y));
  vec2 cellEnd = vec2(raySkyCumulative(cell.y, cell.x + 1), raySkyCumulative(skyCells.y, cell.y + 1));
  vec2 within = clamp((u - cellBegin) / max(cellEnd - cellBegin, vec2(1e-20)), 0.0, 1.0);
  float longitude = ((float(cell.x) + within.x) / float(skyCells.x) - 0.5) * 2.0 * SKY_PI;
  vec2 heights = sin((vec2(cell.y, cell.y + 1) / float(skyCells.y) - 0.5) * SKY_PI);
  float height = mix(heights.x, heights.y, within.y);
  float radius = sqrt(max(0.0, 1.0 - height * height));
  density = raySkyDensityAt(cell);
  return transpose(sceneToSky) * vec3(radius * cos(longitude), height, radius * sin(longitude));
}
