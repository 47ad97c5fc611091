// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVGISettings
 * @brief   the global illumination settings of one of ParaView's render views
 *
 * Holds a vtkGIPass and sets it on the view's vtkPVSynchronizedRenderer. It replaces neither the view nor its
 * representations, and can be switched on and off at any time. ParaView's server manager creates one as part of each
 * render view, and passes the view to it by vtkView::AddRepresentation(), which is the only method that hands over the
 * view. The object does not become a representation. SetView() does the same for a view that was created before the
 * plugin was loaded.
 *
 * Other render passes, such as OSPRay's ray tracing, are left alone while they are active. The pass is set again at the
 * next frame after that.
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
   * Light the view with the pass, or let ParaView draw it. Off by default.
   */
  void SetEnabled(bool enabled);
  bool GetEnabled() const;

  /**
   * Number of frames that are drawn for one still picture, at least 1 (the default). During interaction it is one.
   */
  void SetStillFrames(int frames);

  ///@{
  /**
   * Files of baked light, read at the next frame that they light. That of probes is written by BakeProbes(); "" where
   * these are kept in memory alone.
   */
  void SetLightmapFile(const char* path);
  void SetSHProbesFile(const char* path);
  ///@}

  ///@{
  /**
   * Parameters of BakeProbes(): maximum number of probes (27 to vtkGIProbeBaker's MostProbes, by default 1024), and
   * number of paths from each (1 to 16777216, by default 256).
   */
  vtkSetMacro(ProbesToBake, int);
  vtkSetMacro(SamplesToBake, int);
  ///@}

  /**
   * Bake probes from the view's current scene with vtkGIProbeBaker. Refused on several ranks and with a server.
   */
  void BakeProbes();

  ///@{
  /**
   * Why light could not be baked, read or written, in one sentence, or "".
   */
  const char* GetLightmapProblem();
  const char* GetSHProbesProblem();
  ///@}

  /**
   * The view to light; nullptr detaches from the current one.
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

  void UpdateRenderPass();

  class Internals;
  std::unique_ptr<Internals> Impl;
  int ProbesToBake = 1024;
  int SamplesToBake = 256;
};

#endif
