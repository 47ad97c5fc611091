// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVGISettings
 * @brief   global illumination of one of ParaView's render views
 *
 * Holds a vtkGIPass and sets it as the render pass of the view's vtkPVSynchronizedRenderer. It replaces neither the
 * view nor its representations, so it can be switched on and off at any time. ParaView's server manager creates one as
 * part of each render view and passes it to vtkView::AddRepresentation(), the only method of a view that hands over the
 * view itself; it does not become a representation. SetView() does the same for a view that was created before the
 * plugin was loaded.
 *
 * Another render pass, such as OSPRay's ray tracing, is left alone. Once it is removed, the next frame uses this pass
 * again.
 *
 * @sa vtkGIPass
 */
#ifndef vtkPVGISettings_h
#define vtkPVGISettings_h

#include "vtkPVGIParameters.h"
#include "vtkPenumbraParaViewModule.h" // for the export macro

#include <memory> // for the implementation

class vtkGIPass;
class vtkPVRenderView;

class VTKPENUMBRAPARAVIEW_EXPORT vtkPVGISettings : public vtkPVGIParameters
{
public:
  static vtkPVGISettings* New();
  vtkTypeMacro(vtkPVGISettings, vtkPVGIParameters);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Light the view with the pass, or leave lighting to ParaView. Off by default.
   */
  void SetEnabled(bool enabled);
  bool GetEnabled() const;

  /**
   * Number of frames drawn for one still picture, at least 1 (the default). One frame is drawn while the camera
   * moves.
   */
  void SetStillFrames(int frames);

  /**
   * Milliseconds that a frame may take while the camera moves; 0 (the default) for no limit. Other values are brought into
   * the range from 1 to 10000. Still pictures and screenshots have the techniques' own settings.
   *
   * @sa vtkGIPass::SetFrameBudget()
   */
  void SetFrameBudget(double milliseconds);

  /**
   * Draw a vtkGIFrameChart of the last frame over the view, though not in screenshots. Off by default. It waits for the
   * GPU in each frame, and only the process that draws the view shows it.
   */
  void SetFrameChart(bool shown);

  /**
   * The cost of the last frame, while there is a budget or the chart is shown: see vtkGIPass::GetStatistics().
   */
  const char* GetStatistics();

  ///@{
  /**
   * The view's look (see vtkGILook), by its name or the path of a file; "as-is" (the default) for the view's own lights and
   * background. It is applied at the next frame, on top of the other settings, and removed with it. GetLookProblem() is
   * the reason why it could not be read, in one sentence, or "".
   */
  void SetLook(const char* nameOrPath);
  const char* GetLookProblem();
  ///@}

  ///@{
  /**
   * Files of baked light, read at the next frame that uses them. BakeProbes() writes the file of probes; "" keeps
   * baked probes in memory only.
   */
  void SetLightmapFile(const char* path);
  void SetSHProbesFile(const char* path);
  ///@}

  ///@{
  /**
   * Settings of BakeProbes(): maximum number of probes (27 to vtkGIProbeBaker's MostProbes, by default 1024), and
   * number of paths from each (1 to 16777216, by default 256).
   */
  vtkSetMacro(ProbesToBake, int);
  vtkSetMacro(SamplesToBake, int);
  ///@}

  /**
   * Bake probes in the view's current scene with vtkGIProbeBaker. Refused on several ranks and with a server.
   */
  void BakeProbes();

  ///@{
  /**
   * Reason why light could not be baked, read or written, in one sentence; "" if it could.
   */
  const char* GetLightmapProblem();
  const char* GetSHProbesProblem();
  ///@}

  /**
   * Set the view to light; nullptr for none.
   */
  void SetView(vtkPVRenderView* view);

  /**
   * The pass that lights the view.
   */
  vtkGIPass* GetPass();

protected:
  vtkPVGISettings();
  ~vtkPVGISettings() override;

  bool AddToView(vtkView* view) override;
  void SetSetting(const char* property, double value) override;

private:
  vtkPVGISettings(const vtkPVGISettings&) = delete;
  void operator=(const vtkPVGISettings&) = delete;

  void BeginFrame();
  void UpdateRenderPass();
  void UpdateChart();

  class Internals;
  std::unique_ptr<Internals> Impl;
  int ProbesToBake = 1024;
  int SamplesToBake = 256;
};

#endif
