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

  /**
   * The file of the baked probes; "" keeps them in memory only. It is read before the next frame that they light, and
   * written by BakeProbes().
   */
  void SetProbesFile(const char* path);

  ///@{
  /**
   * Parameters of BakeProbes(): maximum number of probes (27 to vtkGIProbeBaker's MostProbes, by default 1024), and
   * number of paths from each (1 to 16777216, by default 256).
   */
  void SetProbesToBake(int probes);
  void SetSamplesToBake(int samples);
  ///@}

  /**
   * Bake probes from the view's current scene with vtkGIProbeBaker. Refused on several ranks and with a server.
   */
  void BakeProbes();

  /**
   * The reason why probes could not be baked, read or written, in one sentence, or "".
   */
  const char* GetProbesProblem();

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
};

#endif
