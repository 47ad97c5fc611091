// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What stands behind vtkGIPass: the techniques, the GPU resources of one window, and the memory of
 * each view.
 */
#pragma once

#include "vtkGIPass.h"

#include "capture/MotionTable.h"
#include "capture/SceneCapture.h"
#include "gpu/ContextGuard.h"
#include "gpu/HeldTextures.h"
#include "graph/FrameExecutor.h"
#include "graph/ViewState.h"
#include "light/ForwardHooks.h"
#include "light/LightTable.h"
#include "pass/DarkLamp.h"
#include "pass/SceneSignature.h"
#include "pass/WholePicture.h"
#include "rays/RayProps.h"
#include "technique/TechniqueRegistry.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkWeakPointer.h"

class vtkGIPass::Internals : public penumbra::ViewDirectory
{
public:
  Internals();
  ~Internals() override;

  /// Everything is made in this window's context from now on, which becomes current.
  void Enter(vtkOpenGLRenderWindow* window) { this->Guard->Enter(window); }

  /// Draw the opaque props of a frame. Returns the reason where that could not be done, else "".
  std::string RenderFrame(vtkGIPass* self, const vtkRenderState* state);

  /// The renderer's view has no pixels: nothing is drawn, and nothing is kept of an earlier frame as if it were.
  void SkipFrame(vtkRenderer* renderer);

  /// Show a frame that is a tile of a larger picture, which draw draws, if tiles are joined. Returns false where
  /// that is not so or could not be done; what was kept for a renderer's tiles goes where it shows none.
  bool ShowTile(const vtkRenderState* state, bool join, const penumbra::WholePicture::Draw& draw);

  /// Free what is in this window's context; nullptr: whatever window.
  void ReleaseGraphicsResources(vtkWindow* window);
  void Restart();
  bool ReadHistory(vtkRenderer* renderer, const std::string& name, vtkImageData* image);
  bool ReadRadiance(vtkRenderer* renderer, vtkImageData* image);

  /// One view is one renderer seen by one eye.
  using ViewKey = std::pair<vtkRenderer*, int>;
  struct Memory
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    std::string Name; ///< of its textures in the pool
    penumbra::SceneSignature Signature;
    penumbra::MotionTable Motion;
    penumbra::ViewState States;
    int StillFrames = 0;
    int Restarts = 0; ///< of those of the pass, that its frames know of
    int FrameNumber = 0;
    int FirstFrame = 0;                     ///< since the last Restart()
    vtkSmartPointer<vtkImageData> Radiance; ///< of the last frame, where it was kept
    penumbra::WholePicture Whole;           ///< larger than the window, while tiles are shown
  };
  const Memory* FindMemory(vtkRenderer* renderer) const;
  const penumbra::ViewState* FindView(vtkRenderer* renderer) const override;

  std::vector<vtkSmartPointer<vtkGITechnique>> Techniques;
  vtkSmartPointer<vtkOpenGLFXAAFilter> FxaaFilter = vtkSmartPointer<vtkOpenGLFXAAFilter>::New();
  std::string ShaderPath;
  std::string LastError;
  std::string Notes;
  std::string Statistics = "{}";
  int Restarts = 0; ///< times that the next frame was to know nothing of those before
  int CapturedProps = 0;
  penumbra::DarkLamp Dark; ///< while a picture is drawn
  penumbra::HeldTextures Held;
  vtkSmartPointer<vtkGIForwardHooks> Forward = vtkSmartPointer<vtkGIForwardHooks>::New();
  const penumbra::RayProps* DrawnByRays = nullptr; ///< what rays drew all of in this frame

private:
  void Free();
  Memory& Remember(vtkRenderer* renderer); ///< of the eye that is drawn now
  static std::string CheckContext();
  penumbra::View MakeView(vtkOpenGLRenderer* renderer, Memory& memory);
  penumbra::SceneSignature Sign(vtkOpenGLRenderer* renderer, const penumbra::View& view);
  void DrawFrame(vtkGIPass* self, const vtkRenderState* state, Memory& memory, bool alone);
  void KeepRadiance(penumbra::FrameBuilder& frame, Memory& memory);
  void WriteStatistics(
    const std::vector<penumbra::GpuTimer::Span>& spans, const penumbra::View& view);

  penumbra::ShaderLibrary Shaders;
  penumbra::ResourcePool Pool;
  penumbra::SceneCapture Capture{ Shaders };
  penumbra::LightTable Lights;
  std::map<ViewKey, Memory> Views;
  std::map<vtkRenderer*, penumbra::RayProps> Worlds; ///< of renderers in Views
  penumbra::Buffer ViewBlock;
  int ViewsMade = 0;
  bool ShadersUnchecked = false; ///< the last folder's did not compile
  vtkNew<vtkGIContextGuard> Guard;
};
