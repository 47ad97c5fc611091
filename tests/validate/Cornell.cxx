// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cornell.h"

#include "Shapes.h"

namespace validate
{
void BuildCornellBox(Studio& studio, int pixels)
{
  studio.Clear(pixels, pixels);
  const Material white = Painted({ { 0.73, 0.73, 0.73 } });
  const Material red = Painted({ { 0.65, 0.05, 0.05 } });
  const Material green = Painted({ { 0.12, 0.45, 0.15 } });
  studio.Add(Floor(-1.0, 1.0, -1.0, 1.0, -1.0), white);
  // The lamp fills a hole in the ceiling. Below a closed ceiling, light would be trapped between the two and found by
  // few paths with large weights.
  constexpr double lamp = 0.25;
  studio.Add(Ceiling(-lamp, lamp, -lamp, lamp, 1.0), Matte(0.0, 12.0));
  studio.Add(Ceiling(-1.0, 1.0, -1.0, -lamp, 1.0), white);
  studio.Add(Ceiling(-1.0, 1.0, lamp, 1.0, 1.0), white);
  studio.Add(Ceiling(-1.0, -lamp, -lamp, lamp, 1.0), white);
  studio.Add(Ceiling(lamp, 1.0, -lamp, lamp, 1.0), white);
  const auto wall = [](double x0, double y0, double x1, double y1) {
    return Quad(
      { { { { x0, y0, -1.0 } }, { { x1, y1, -1.0 } }, { { x1, y1, 1.0 } }, { { x0, y0, 1.0 } } } });
  };
  studio.Add(wall(-1.0, 1.0, 1.0, 1.0), white);
  studio.Add(wall(-1.0, -1.0, -1.0, 1.0), red);
  studio.Add(wall(1.0, 1.0, 1.0, -1.0), green);
  studio.Add(Box({ { -0.63, -0.05, -1.0 } }, { { -0.05, 0.53, 0.2 } }, 18.0), white);
  studio.Add(Box({ { 0.05, -0.63, -1.0 } }, { { 0.63, -0.05, -0.4 } }, -17.0), white);
  studio.Look({ { 0.0, -3.9, 0.0 } }, { { 0.0, 0.0, 0.0 } }, 39.0);
}
}
