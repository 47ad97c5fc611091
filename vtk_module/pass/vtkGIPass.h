// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIPass
 * @brief   global illumination for a renderer
 *
 * Set one on a renderer:
 * @code
 * vtkNew<vtkGIPass> gi;
 * gi->SetPreset("balanced");
 * renderer->SetPass(gi);
 * @endcode
 *
 * The pass draws every opaque prop once into a G-buffer, computes the direct light of all the renderer's lights per
 * pixel, and lets its techniques add visibility, indirect light and filtering. Translucent props, volumes and
 * annotations are drawn as VTK draws them, in VTK's order. With every technique off the picture equals stock VTK's.
 *
 * One pass may serve several renderers of one window; each keeps its own history. It may also move between windows, or
 * serve several, but has resources in one context at a time: each change of window starts from scratch, including the
 * shaders. If several windows are drawn often, give each its own pass.
 *
 * @sa vtkGITechnique
 */
#ifndef vtkGIPass_h
#define vtkGIPass_h

#include "vtkRenderPass.h"
#include "vtkRenderingGIModule.h"

#include <functional> // for ShareFrameBudget
#include <memory>     // for the implementation

class vtkGITechnique;
class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;

class VTKRENDERINGGI_EXPORT vtkGIPass : public vtkRenderPass
{
public:
  static vtkGIPass* New();
  vtkTypeMacro(vtkGIPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* state) override;

  /**
   * Free the pass's GPU resources if they are in this window's context, or in any context if nullptr. May be called at
   * any time and with any current context; the next Render() creates them again. Windows call it by themselves.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Switch techniques on and off and set their parameters: "off" (the default, stock VTK's picture), "fast",
   * "balanced", "high" or "reference". Returns false, with an error, for another name. Parameters that are changed
   * afterwards keep their new values.
   */
  bool SetPreset(const char* preset);
  vtkGetStringMacro(Preset);
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  ///@}

  ///@{
  /**
   * The techniques, by index or by name ("shadow-maps"). An unknown name gives nullptr.
   */
  int GetNumberOfTechniques();
  vtkGITechnique* GetTechnique(int index);
  vtkGITechnique* GetTechnique(const char* name);
  ///@}

  ///@{
  /**
   * Keep the linear radiance of each frame for GetRadiance(). Off by default, as it costs memory
   * and a second output.
   */
  vtkSetMacro(KeepRadiance, bool);
  vtkGetMacro(KeepRadiance, bool);
  vtkBooleanMacro(KeepRadiance, bool);
  ///@}

  /**
   * Copy the last frame's linear radiance of opaque surfaces and background into a float image of four components (red,
   * green, blue, and 1 where a surface was captured, 0 elsewhere), of the window's size in that frame. Needs
   * KeepRadiance, and the window's graphics resources. Returns false if the renderer's last frame was not kept, or its resources
   * have been released.
   */
  bool GetRadiance(vtkRenderer* renderer, vtkImageData* image);

  /**
   * Copy a history that a technique keeps for a renderer into a float image of four components and the window's size,
   * such as the path tracer's sums: "path-tracing.albedo" (rgb, and the number of samples that hit a surface),
   * "path-tracing.normal" (in the world, and the distance along the line of sight) and "path-tracing.encoded" (its
   * fourth component is the sum of the samples' squared luminance). Returns false if there is none of that name.
   */
  bool GetBuffer(vtkRenderer* renderer, const char* name, vtkImageData* image);

  /**
   * Let the next frame use nothing from previous frames, so that a saved picture depends only on the scene. Averages
   * over frames start again. Live probes start from scratch and do the first updates of a scene within that one frame,
   * which takes correspondingly longer.
   */
  void Restart();

  ///@{
  /**
   * Draw a picture that is larger than its window, which vtkWindowToImageFilter::SetScale() makes in tiles, as a whole
   * with its first tile, so that screen-space effects such as occlusion do not end at the tiles' edges. Off by default,
   * because a window that always shows a tile, as in a display wall, never needs the whole picture. Works for windows
   * without multisampling and pictures up to 7680 x 4320 pixels, if the GPU supports textures of that size. Other
   * pictures are drawn tile by tile, and so are renderers that draw onto existing content: layers above the first, and
   * renderers with PreserveColorBuffer, PreserveDepthBuffer or without Erase. The picture is kept until the renderer's
   * next frame that is not a tile.
   */
  vtkSetMacro(JoinTiles, bool);
  vtkGetMacro(JoinTiles, bool);
  vtkBooleanMacro(JoinTiles, bool);
  ///@}

  /**
   * Whether the last Render() only copied its tile from the picture that JoinTiles drew with the first tile. Rendering
   * it again changes nothing.
   */
  vtkGetMacro(CopiedTile, bool);

  /**
   * Number of still frames averaged in the last picture of a renderer: 1 for a first frame.
   */
  int GetAccumulatedFrames(vtkRenderer* renderer);

  ///@{
  /**
   * A folder whose shaders replace the built-in ones with the same relative name, to develop shaders without
   * rebuilding. The environment variable PENUMBRA_SHADER_PATH sets the default.
   */
  void SetShaderPath(const char* path);
  const char* GetShaderPath();
  ///@}

  ///@{
  /**
   * Milliseconds that a frame may take while anything moves; 0, the default, for no limit. Range: 1 to 10000. Techniques then
   * use lower settings than their own (see docs/frame-budget.md), as far as that is needed on this machine: the steps that
   * cost the least accuracy, by measured times and errors. They get their own settings back in the
   * frames that are drawn 150 ms after the last change or later, at once or after eight frames at levels between; nothing draws
   * these frames by itself, see vtkGIRefinement. Tiles of larger pictures, and the frames from Restart() to the next change, have
   * their own settings too, so that still pictures do not depend on the machine. The limit is that of the window; renderers
   * that share this pass share it. Returns false, with an error, for another value.
   */
  bool SetFrameBudget(double milliseconds);
  vtkGetMacro(FrameBudget, double);
  ///@}

  ///@{
  /**
   * Use 1/DesiredUpdateRate of the window as the limit where that rate is above 1 frame per second, as interactors
   * set it while the user turns the scene, and FrameBudget otherwise. Off by default.
   */
  vtkSetMacro(UseDesiredUpdateRate, bool);
  vtkGetMacro(UseDesiredUpdateRate, bool);
  vtkBooleanMacro(UseDesiredUpdateRate, bool);
  ///@}

  ///@{
  /**
   * Draw with the techniques' own settings, whatever the budget: for programs that know which of their pictures are still
   * ones. The budget keeps what it has learned of costs, and does not learn from these pictures. Off by default.
   */
  vtkSetMacro(StillPicture, bool);
  vtkGetMacro(StillPicture, bool);
  vtkBooleanMacro(StillPicture, bool);
  ///@}

  /**
   * Whether the frame budget lowered settings of techniques in the last picture of a renderer.
   */
  bool HasLoweredSettings(vtkRenderer* renderer);

#ifndef __VTK_WRAP__
  /**
   * For processes that draw one picture together: let the next frame have the same levels in all of them, by the times of the
   * slowest. All must call it before each frame that moves, also those that draw nothing of it, as it may wait for the
   * others. maximum: replaces values by their maximum over the processes. Does nothing without a budget, which must be the
   * same everywhere.
   */
  void ShareFrameBudget(
    vtkRenderer* renderer, const std::function<void(double* values, int count)>& maximum);
#endif

  ///@{
  /**
   * Measure each pass of the frame on the GPU. GetStatistics() returns those of the last frame as JSON: milliseconds
   * per pass, textures and bytes in the pool, lights, accumulated frames; with a frame budget, also the levels in force, their
   * predicted costs and errors, and the times of the last 120 frames. It waits for the GPU; frames do
   * not, except with software OpenGL, which finishes each pass before the next to time it.
   */
  vtkSetMacro(CollectStatistics, bool);
  vtkGetMacro(CollectStatistics, bool);
  vtkBooleanMacro(CollectStatistics, bool);
  const char* GetStatistics();
  ///@}

  /**
   * The techniques' notes about the last frame, one sentence per line, or "". For example, how many lights cast no
   * shadow.
   */
  const char* GetNotes();

  /**
   * The reason why the last Render() fell back to VTK's own drawing, or "" if it did not.
   */
  const char* GetLastError();

protected:
  vtkGIPass();
  ~vtkGIPass() override;

  char* Preset = nullptr;
  bool KeepRadiance = false;
  bool CollectStatistics = false;
  double FrameBudget = 0.0;
  bool UseDesiredUpdateRate = false;
  bool StillPicture = false;
  bool JoinTiles = false;
  bool CopiedTile = false;

private:
  vtkGIPass(const vtkGIPass&) = delete;
  void operator=(const vtkGIPass&) = delete;

  static constexpr double MaximumFrameBudget = 10000.0;
  void RenderPicture(const vtkRenderState* state);
  double CurrentFrameBudget(vtkRenderWindow* window) const;

  friend class vtkGIPassOrder; // tests/pass/TestPlan.cxx: techniques in another order
  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
