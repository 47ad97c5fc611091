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
 * The pass rasters every opaque prop once into a G-buffer, resolves direct light per pixel from
 * every light of the renderer, and lets its techniques add visibility, indirect light and
 * filtering. Translucent props, volumes and annotations are drawn as VTK draws them, in VTK's
 * order. With every technique off the picture equals stock VTK's.
 *
 * One pass may serve several renderers of one window; each keeps its own history. It may also move between
 * windows, or serve several, but has resources in one context at a time: each change of window begins again, shaders
 * included. Give each window a pass of its own where both are drawn often.
 *
 * @sa vtkGITechnique
 */
#ifndef vtkGIPass_h
#define vtkGIPass_h

#include "vtkRenderPass.h"
#include "vtkRenderingGIModule.h"

#include <memory> // for the implementation

class vtkGITechnique;
class vtkImageData;
class vtkRenderer;

class VTKRENDERINGGI_EXPORT vtkGIPass : public vtkRenderPass
{
public:
  static vtkGIPass* New();
  vtkTypeMacro(vtkGIPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* state) override;

  /**
   * Free what the pass has on the GPU, if it is in this window's context; nullptr: in whatever window's. May be called
   * at any time, whatever context is current: the next Render() makes all again. Windows call it by themselves.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Switch techniques and choose their parameters together: "off" (the default: stock VTK's
   * picture), "fast", "balanced" or "high". Returns false, with an error, for another name.
   * Parameters changed afterwards keep their new value.
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
   * Copy the last frame's linear radiance of opaque surfaces and background into a float image of
   * four components (red, green, blue, and 1 where a surface was captured, 0 elsewhere), of the
   * size that the window had then. Needs KeepRadiance. Returns false where the last frame of that renderer was not kept.
   */
  bool GetRadiance(vtkRenderer* renderer, vtkImageData* image);

  /**
   * Copy a texture that a technique keeps for a renderer from frame to frame into a float image of
   * four components and the window's size: the path tracer's sums, "path-tracing.albedo" (rgb, and
   * the samples that met a surface), "path-tracing.normal" (in the world, and the distance along
   * the line of sight) and "path-tracing.encoded" (its fourth component: the samples' squared
   * luminance). Returns false where there is none of that name.
   */
  bool GetBuffer(vtkRenderer* renderer, const char* name, vtkImageData* image);

  /**
   * Have the next frame show nothing that was found in frames before, so that a picture that is kept depends
   * on the scene alone. Averages over frames start again, and probes that are updated live forget what they
   * know and do a scene's first updates in that one frame, which takes so much longer.
   */
  void Restart();

  ///@{
  /**
   * Draw a picture that is larger than its window, as vtkWindowToImageFilter::SetScale() makes it in tiles, as a
   * whole with its first tile, so that what is found on the screen, occlusion for instance, does not end at the
   * tiles' edges. Off by default: a window that shows a tile for ever, one of a wall of displays, is no such
   * picture. Windows without multisampling, and up to 7680 x 4320 pixels, as far as the GPU's textures reach;
   * others are drawn tile by tile, as are renderers that draw onto what is there: layers above the first, and
   * those with PreserveColorBuffer, PreserveDepthBuffer or without Erase. The picture is kept until the
   * renderer's next frame that is no tile of it.
   */
  vtkSetMacro(JoinTiles, bool);
  vtkGetMacro(JoinTiles, bool);
  vtkBooleanMacro(JoinTiles, bool);
  ///@}

  /**
   * Whether the last Render() drew nothing, as its tile was copied from the picture that JoinTiles drew with the
   * first: to render it again changes nothing.
   */
  vtkGetMacro(CopiedTile, bool);

  /**
   * Number of still frames averaged in the last picture of a renderer: 1 for a first frame.
   */
  int GetAccumulatedFrames(vtkRenderer* renderer);

  ///@{
  /**
   * A folder whose shaders replace the built-in ones of the same relative name, for work on
   * shaders without rebuilding. The environment variable PENUMBRA_SHADER_PATH sets the default.
   */
  void SetShaderPath(const char* path);
  const char* GetShaderPath();
  ///@}

  ///@{
  /**
   * Measure each pass of the frame on the GPU. GetStatistics() gives the last frame's as JSON:
   * milliseconds per pass, textures and bytes in the pool, lights, frames accumulated.
   */
  vtkSetMacro(CollectStatistics, bool);
  vtkGetMacro(CollectStatistics, bool);
  vtkBooleanMacro(CollectStatistics, bool);
  const char* GetStatistics();
  ///@}

  /**
   * What the techniques had to say of the last frame, a sentence a line, or "": lights left without
   * shadow, for instance.
   */
  const char* GetNotes();

  /**
   * The sentence that says why the last Render() drew nothing of its own, or "" where all is well.
   */
  const char* GetLastError();

protected:
  vtkGIPass();
  ~vtkGIPass() override;

  char* Preset = nullptr;
  bool KeepRadiance = false;
  bool CollectStatistics = false;
  bool JoinTiles = false;
  bool CopiedTile = false;

private:
  vtkGIPass(const vtkGIPass&) = delete;
  void operator=(const vtkGIPass&) = delete;

  void RenderPicture(const vtkRenderState* state);

  friend class vtkGIPassOrder; // tests/pass/TestPlan.cxx: techniques in another order
  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
