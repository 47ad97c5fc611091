// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A white sheet to lay pictures and words on.
#ifndef penumbra_tool_Canvas_h
#define penumbra_tool_Canvas_h

#include "image/Picture.h"

#include <array>
#include <string>

namespace penumbra::tool
{
class Canvas
{
public:
  using Color = std::array<float, 3>;

  Canvas(int width, int height);

  /// The picture with each of its pixels as a square of so many, its upper left corner there.
  void Place(const Picture& picture, int x, int y, int enlarged = 1);
  /// Frames stand outside of their rectangle.
  void Frame(int x, int y, int width, int height, int thickness, const Color& color);
  /// A line of text, its upper left corner there; text that the sheet is too narrow for is cut off.
  void Write(const std::string& text, int x, int y, int size, const Color& color = { 0, 0, 0 });

  const Picture& Get() const { return this->Sheet; }

private:
  void Fill(int x, int y, int width, int height, const Color& color);

  Picture Sheet;
};
}

#endif
