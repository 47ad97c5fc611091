// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pass/WholePicture.h"

#include "gpu/BoundFramebuffer.h"
#include "gpu/ScopedState.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra
{
namespace
{
// 8K. The textures of a frame have some hundred bytes per pixel, which makes a few gigabytes.
constexpr double MaximumPixels = 7680.0 * 4320.0;

struct Rectangle
{
  double Low[2];
  double High[2];

  explicit Rectangle(const double* bounds)
    : Low{ bounds[0], bounds[1] }
    , High{ bounds[2], bounds[3] }
  {
  }
  double Size(int axis) const { return this->High[axis] - this->Low[axis]; }
  double Middle(int axis) const { return 0.5 * (this->High[axis] + this->Low[axis]); }
};

// The renderer's rectangle in the whole picture, the tile, and their intersection. The picture's size is 1.
struct TileLayout
{
  Rectangle Whole;
  Rectangle Tile;
  Rectangle Intersection;

  explicit TileLayout(vtkRenderer* renderer)
    : Whole(renderer->GetViewport())
    , Tile(renderer->GetRenderWindow()->GetTileViewport())
    , Intersection(this->Whole)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Intersection.Low[axis] =
        std::clamp(this->Whole.Low[axis], this->Tile.Low[axis], this->Tile.High[axis]);
      this->Intersection.High[axis] =
        std::clamp(this->Whole.High[axis], this->Tile.Low[axis], this->Tile.High[axis]);
    }
  }
  bool IsEmpty() const
  {
    return this->Intersection.Size(0) <= 0.0 || this->Intersection.Size(1) <= 0.0;
  }
  // Tiles are drawn starting from the lower left.
  bool IsFirst() const
  {
    return this->Intersection.Low[0] == this->Whole.Low[0] &&
      this->Intersection.Low[1] == this->Whole.Low[1];
  }
};

// While it lives, undoes vtkWindowToImageFilter's changes to the camera for a tile, and gives the renderer the whole
// picture.
class WholeView
{
public:
  WholeView(vtkRenderer* renderer, const TileLayout& layout)
    : Window(renderer->GetRenderWindow())
    , Camera(renderer->GetActiveCamera())
    , Angle(this->Camera->GetViewAngle())
    , Scale(this->Camera->GetParallelScale())
  {
    this->Window->GetTileViewport(this->Tile);
    this->Camera->GetWindowCenter(this->Center);
    const double share = layout.Intersection.Size(1) / layout.Whole.Size(1);
    const auto center = [&](int axis) {
      return this->Center[axis] -
        2.0 * (layout.Intersection.Middle(axis) - layout.Whole.Middle(axis)) /
        layout.Intersection.Size(axis);
    };
    const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(this->Angle)) / share;
    this->Camera->SetWindowCenter(center(0), center(1));
    this->Camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(half)));
    this->Camera->SetParallelScale(this->Scale / share);
    this->Window->SetTileViewport(0.0, 0.0, 1.0, 1.0);
  }
  ~WholeView()
  {
    this->Window->SetTileViewport(this->Tile);
    this->Camera->SetWindowCenter(this->Center[0], this->Center[1]);
    this->Camera->SetViewAngle(this->Angle);
    this->Camera->SetParallelScale(this->Scale);
  }
  WholeView(const WholeView&) = delete;
  WholeView& operator=(const WholeView&) = delete;

private:
  vtkRenderWindow* Window;
  vtkCamera* Camera;
  double Angle;
  double Scale;
  double Center[2];
  double Tile[4];
};

// All visible props, because the renderer's own list is culled to the tile.
std::vector<vtkProp*> VisibleProps(vtkRenderer* renderer)
{
  std::vector<vtkProp*> visible;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility())
    {
      visible.push_back(prop);
    }
  }
  return visible;
}

// Whether the renderer draws onto the window's content, which the whole picture does not have.
bool PreservesContent(vtkRenderer* renderer)
{
  return renderer->GetPreserveColorBuffer() || renderer->GetPreserveDepthBuffer() ||
    !renderer->GetErase();
}

bool Fits(int width, int height)
{
  GLint side = 0;
  GLint viewport[2] = {};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  return width <= std::min(side, viewport[0]) && height <= std::min(side, viewport[1]) &&
    static_cast<double>(width) * height <= MaximumPixels;
}
}

bool WholePicture::IsTile(vtkRenderer* renderer)
{
  int scale[2];
  renderer->GetRenderWindow()->GetTileScale(scale);
  return scale[0] > 1 || scale[1] > 1;
}

bool WholePicture::CreateTargets(const TextureDesc& color, const TextureDesc& depth)
{
  if (this->Framebuffer && this->Color->Desc() == color && this->Depth->Desc() == depth)
  {
    return true;
  }
  this->Color.emplace(color);
  this->Depth.emplace(depth);
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  this->Framebuffer = FramebufferHandle(name);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Color->Get(), 0);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, depth.DepthAttachment(), GL_TEXTURE_2D, this->Depth->Get(), 0);
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool WholePicture::Show(const vtkRenderState* state, const Draw& draw)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const TileLayout layout(renderer);
  const int* size = window->GetSize(); // of all tiles together
  const TextureDesc color = { BoundFormat(GL_COLOR_ATTACHMENT0), size[0], size[1], 0 };
  const TextureDesc depth = { BoundFormat(GL_DEPTH_ATTACHMENT), size[0], size[1], 0 };
  if (layout.IsEmpty() || PreservesContent(renderer) || BoundSamples() > 0 || !color.Format ||
    !depth.IsDepth() || !Fits(size[0], size[1]) || (!layout.IsFirst() && !this->Framebuffer))
  {
    return false;
  }
  vtkOpenGLState* gl = window->GetState();
  const GLuint bound = BoundFramebuffer();
  if (layout.IsFirst())
  {
    const ScopedState saved(gl);
    const bool made = this->CreateTargets(color, depth);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound); // the binding in VTK's state cache
    if (made)
    {
      const WholeView view(renderer, layout);
      std::vector<vtkProp*> props = VisibleProps(renderer);
      vtkRenderState whole(renderer);
      whole.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
      gl->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer.Get());
      draw(&whole);
    }
    if (!made)
    {
      *this = WholePicture();
      return false;
    }
  }
  int area[4]; // x, y, width and height of the tile
  renderer->GetTiledSizeAndOrigin(&area[2], &area[3], &area[0], &area[1]);
  const int x = area[0] + static_cast<int>(std::lround(layout.Tile.Low[0] * size[0]));
  const int y = area[1] + static_cast<int>(std::lround(layout.Tile.Low[1] * size[1]));
  gl->PushReadFramebufferBinding();
  gl->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer.Get());
  gl->vtkglBlitFramebuffer(x, y, x + area[2], y + area[3], area[0], area[1], area[0] + area[2],
    area[1] + area[3], GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl->PopReadFramebufferBinding();
  return true;
}
}
