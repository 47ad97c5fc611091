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
// 8K: with some hundred bytes a pixel in the textures of a frame, a few gigabytes.
constexpr double MostPixels = 7680.0 * 4320.0;

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

// Where a renderer is in the whole picture, the tile, and what both share; the picture's size is 1.
struct Places
{
  Rectangle All;
  Rectangle Tile;
  Rectangle Shared;

  explicit Places(vtkRenderer* renderer)
    : All(renderer->GetViewport())
    , Tile(renderer->GetRenderWindow()->GetTileViewport())
    , Shared(this->All)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Shared.Low[axis] =
        std::clamp(this->All.Low[axis], this->Tile.Low[axis], this->Tile.High[axis]);
      this->Shared.High[axis] =
        std::clamp(this->All.High[axis], this->Tile.Low[axis], this->Tile.High[axis]);
    }
  }
  bool IsEmpty() const { return this->Shared.Size(0) <= 0.0 || this->Shared.Size(1) <= 0.0; }
  // Tiles are drawn from the lower left on.
  bool IsFirst() const
  {
    return this->Shared.Low[0] == this->All.Low[0] && this->Shared.Low[1] == this->All.Low[1];
  }
};

// Undoes what vtkWindowToImageFilter does to a tile's camera, and gives the renderer all of the picture, for as
// long as this lives.
class WholeView
{
public:
  WholeView(vtkRenderer* renderer, const Places& places)
    : Window(renderer->GetRenderWindow())
    , Camera(renderer->GetActiveCamera())
    , Angle(this->Camera->GetViewAngle())
    , Scale(this->Camera->GetParallelScale())
  {
    this->Window->GetTileViewport(this->Tile);
    this->Camera->GetWindowCenter(this->Center);
    const double share = places.Shared.Size(1) / places.All.Size(1);
    const auto center = [&](int axis) {
      return this->Center[axis] -
        2.0 * (places.Shared.Middle(axis) - places.All.Middle(axis)) / places.Shared.Size(axis);
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

// The renderer's own list is culled to the tile.
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

// Of the window, which the whole picture does not have.
bool KeepsWhatIsThere(vtkRenderer* renderer)
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
    static_cast<double>(width) * height <= MostPixels;
}
}

bool WholePicture::IsTile(vtkRenderer* renderer)
{
  int scale[2];
  renderer->GetRenderWindow()->GetTileScale(scale);
  return scale[0] > 1 || scale[1] > 1;
}

bool WholePicture::Make(const TextureDesc& color, const TextureDesc& depth)
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
  const Places places(renderer);
  const int* size = window->GetSize(); // of all tiles
  const TextureDesc color = { BoundFormat(GL_COLOR_ATTACHMENT0), size[0], size[1], 0 };
  const TextureDesc depth = { BoundFormat(GL_DEPTH_ATTACHMENT), size[0], size[1], 0 };
  if (places.IsEmpty() || KeepsWhatIsThere(renderer) || BoundSamples() > 0 || !color.Format ||
    !depth.IsDepth() || !Fits(size[0], size[1]) || (!places.IsFirst() && !this->Framebuffer))
  {
    return false;
  }
  vtkOpenGLState* gl = window->GetState();
  const GLuint bound = BoundFramebuffer();
  if (places.IsFirst())
  {
    const ScopedState saved(gl);
    const bool made = this->Make(color, depth);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound); // as VTK's cache of the state has it
    if (made)
    {
      const WholeView view(renderer, places);
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
  int area[4]; // of the tile: x, y, width, height
  renderer->GetTiledSizeAndOrigin(&area[2], &area[3], &area[0], &area[1]);
  const int x = area[0] + static_cast<int>(std::lround(places.Tile.Low[0] * size[0]));
  const int y = area[1] + static_cast<int>(std::lround(places.Tile.Low[1] * size[1]));
  gl->PushReadFramebufferBinding();
  gl->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer.Get());
  gl->vtkglBlitFramebuffer(x, y, x + area[2], y + area[3], area[0], area[1], area[0] + area[2],
    area[1] + area[3], GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl->PopReadFramebufferBinding();
  return true;
}
}
