// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVGISettings
 * @brief   the global illumination of one of ParaView's render views
 *
 * Holds a vtkGIPass and puts it where the view's passes are made (vtkPVSynchronizedRenderer), without
 * taking the place of the view or of its representations: it can be switched on and off at any time.
 * ParaView's server manager makes one as part of each render view, and tells it the view by
 * vtkView::AddRepresentation(), the one method of a view that hands the view over; it never becomes a
 * representation of it. SetView() does the same for a view that was made before the plugin was loaded.
 *
 * What takes the place of the render pass for a time, as ray tracing by OSPRay does, is left alone; the
 * pass is put back at the next frame.
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
   * Light the view by the pass, or leave it to ParaView. Off by default.
   */
  void SetEnabled(bool enabled);
  bool GetEnabled() const;

  /**
   * How many frames are drawn for one still picture, at least 1 (the default). While the camera is
   * moved it is one.
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
   * What BakeProbes() takes: probes at most (27 to vtkGIProbeBaker's MostProbes, by default 1024), and paths from
   * each (1 to 16777216, by default 256).
   */
  vtkSetMacro(ProbesToBake, int);
  vtkSetMacro(SamplesToBake, int);
  ///@}

  /**
   * Bake probes from what the view shows now, as vtkGIProbeBaker does. Refused on several ranks and with a server.
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
   * The view to light; nullptr to leave the one it had.
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

  void Place();

  class Internals;
  std::unique_ptr<Internals> Impl;
  int ProbesToBake = 1024;
  int SamplesToBake = 256;
};

#endif
