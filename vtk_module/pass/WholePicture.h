// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A picture that is larger than its window. vtkWindowToImageFilter makes it in tiles, each with its own camera, so
 * that screen-space occlusion and reflections would end at the tiles' edges. Therefore the first tile draws the whole
 * picture off screen, and each tile copies its part of it.
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

  /// Whether the renderer's window currently shows a tile of a larger picture.
  static bool IsTile(vtkRenderer* renderer);

  /// Show the renderer's part of a tile. draw: draws a state's picture to the bound framebuffer. Returns false, and
  /// shows nothing, if the picture is too large to be drawn at once, the window is multisampled, or the renderer draws
  /// onto the window's content.
  bool Show(const vtkRenderState* state, const Draw& draw);

private:
  bool CreateTargets(const TextureDesc& color, const TextureDesc& depth);

  std::optional<Texture> Color;
  std::optional<Texture> Depth;
  FramebufferHandle Framebuffer;
};
}
