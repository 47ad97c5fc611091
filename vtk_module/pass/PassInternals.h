// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The implementation of vtkGIPass: the techniques, the GPU resources of one window, and the state of each view.
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
#include "pass/FrameBudget.h"
#include "pass/FrameStatistics.h"
#include "pass/PlaceholderLight.h"
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

  /// Make this window's context current, and create all resources in it from now on.
  void Enter(vtkOpenGLRenderWindow* window) { this->Guard->Enter(window); }

  /// Draw the opaque props of a frame. Returns the reason if that failed, else "".
  std::string RenderFrame(vtkGIPass* self, const vtkRenderState* state);

  /// Decide on the levels of the next frame together with other processes.
  void ShareBudget(vtkGIPass* self, vtkRenderer* renderer,
    const std::function<void(double* values, int count)>& maximum);

  /// Tell that a frame is over, with everything that VTK draws after the opaque props, or that it failed.
  void EndFrame();

  /// Skip a frame without pixels, and drop the radiance of the previous frame.
  void SkipFrame(vtkRenderer* renderer);

  /// Show a frame that is a tile of a larger picture, which is drawn by draw, if tiles are joined. Returns false if
  /// it is not a tile or that failed. The larger picture is freed if the renderer does not show a tile.
  bool ShowTile(const vtkRenderState* state, bool join, const penumbra::WholePicture::Draw& draw);

  /// Free the resources in this window's context; in any window's if nullptr.
  void ReleaseGraphicsResources(vtkWindow* window);
  void Restart();
  bool ReadHistory(vtkRenderer* renderer, const std::string& name, vtkImageData* image);
  bool ReadRadiance(vtkRenderer* renderer, vtkImageData* image);
  /// Statistics of the last frame, as JSON. Waits for its times.
  const std::string& ReadStatistics();

  /// A view is one renderer seen by one eye.
  using ViewKey = std::pair<vtkRenderer*, int>;
  struct ViewRecord
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    std::string Name; ///< name of its textures in the pool
    penumbra::SceneSignature Signature;
    penumbra::MotionTable Motion;
    penumbra::ViewState States;
    int StillFrames = 0;
    int Restarts = 0; ///< the pass's Restarts at its last frame
    int FrameNumber = 0;
    int FirstFrame = 0;        ///< since the last Restart()
    bool RadianceKept = false; ///< whether the last frame's radiance was kept
    std::optional<penumbra::GpuTimer> Timer; ///< while times are wanted
    penumbra::FrameStatistics Statistics;
    penumbra::FrameBudget Budget;
    penumbra::WholePicture Whole;           ///< larger than the window, while tiles are shown
  };
  const ViewRecord* FindRecord(vtkRenderer* renderer) const;
  const penumbra::ViewState* FindView(vtkRenderer* renderer) const override;

  std::vector<vtkSmartPointer<vtkGITechnique>> Techniques;
  vtkSmartPointer<vtkOpenGLFXAAFilter> FxaaFilter = vtkSmartPointer<vtkOpenGLFXAAFilter>::New();
  std::string ShaderPath;
  std::string LastError;
  std::string Notes;
  int Restarts = 0; ///< number of calls of Restart()
  int CapturedProps = 0;
  penumbra::PlaceholderLight Placeholder; ///< added while a picture is drawn
  penumbra::HeldTextures Held;
  vtkSmartPointer<vtkGIForwardHooks> Forward = vtkSmartPointer<vtkGIForwardHooks>::New();
  const penumbra::RayProps* DrawnByRays = nullptr; ///< scene that rays have drawn in this frame

private:
  void FreeResources();
  ViewRecord& FindOrAddRecord(vtkRenderer* renderer); ///< for the eye that is being drawn
  static std::string CheckContext();
  penumbra::View MakeView(vtkOpenGLRenderer* renderer, ViewRecord& record);
  penumbra::SceneSignature Sign(vtkOpenGLRenderer* renderer, const penumbra::View& view);
  /// Returns false if the frame is incomplete because the user aborted it.
  bool DrawFrame(
    vtkGIPass* self, const vtkRenderState* state, ViewRecord& record, bool standsAlone);
  void ForgetView(const ViewKey& key); ///< free what is kept for a view that is gone
  static void KeepRadiance(penumbra::FrameBuilder& frame);
  void BeginTimes(ViewRecord& record, bool wanted);
  /// Lower the techniques' settings for this frame, as far as its budget demands.
  void ApplyBudget(
    vtkGIPass* self, vtkOpenGLRenderer* renderer, ViewRecord& record, penumbra::View& view);
  void PutSettingsBack();
  void TakeTimes(ViewRecord& record, std::vector<penumbra::TimedFrame> frames);

  penumbra::ShaderLibrary Shaders;
  penumbra::ResourcePool Pool;
  penumbra::SceneCapture Capture{ Shaders };
  penumbra::LightTable Lights;
  std::map<ViewKey, ViewRecord> Views;
  std::map<vtkRenderer*, penumbra::RayProps> RayScenes; ///< one per renderer in Views
  penumbra::Buffer ViewBlock;
  int ViewCount = 0;
  ViewRecord* Timed = nullptr;     ///< of the frame whose parts are being timed
  ViewRecord* Governed = nullptr;  ///< whose budget has lowered settings in this frame
  ViewRecord* LastTimed = nullptr; ///< of the last frame that was timed
  std::size_t ProgramsBefore = 0;  ///< number of programs when the frame began
  std::string StatisticsText;
  bool ShadersInvalid = false; ///< those of the last folder did not compile
  vtkNew<vtkGIContextGuard> Guard;
};
