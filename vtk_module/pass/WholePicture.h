// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A picture larger than its window, as vtkWindowToImageFilter makes it: in tiles, each seen by a camera of its
 * own. What techniques find on the screen, occluders and reflections, would end at the edges of the tiles. So the
 * first tile draws the whole picture beside the window, and each tile takes its part of it.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <functional>
#include <optional>

class vtkRenderState;
class vtkRenderer;

namespace penumbra
{
class WholePicture
{
public:
  using Draw = std::function<void(const vtkRenderState*)>;

  /// Whether the renderer's window shows a tile of a larger picture now.
  static bool IsTile(vtkRenderer* renderer);

  /// Shows the renderer's part of a tile; draw draws the picture of a state to what is bound. Returns false, and
  /// shows nothing, where the picture is too large to be drawn at once, the window is multisampled, or the renderer
  /// draws onto what others have drawn there.
  bool Show(const vtkRenderState* state, const Draw& draw);

private:
  bool Make(const TextureDesc& color, const TextureDesc& depth);

  std::optional<Texture> Color;
  std::optional<Texture> Depth;
  FramebufferHandle Framebuffer;
};
}
