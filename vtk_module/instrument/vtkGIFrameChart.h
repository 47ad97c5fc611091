// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIFrameChart
 * @brief   draws where the time of a frame of vtkGIPass goes, and what more time would buy
 *
 * A frame has a limited number of milliseconds, and each term of the light is precomputed, approximated or amortised. A bar stacks the
 * passes of the last frame by these approaches, with a line at the budget. If the statistics have a budget, earlier frames
 * follow below, and for each knob the error of its levels over their cost.
 *
 * The item fills its scene, unless SetArea() gives it a part. As an overlay of a window:
 *
 * @code
 * vtkNew<vtkGIFrameChart> chart;
 * chart->SetArea(10, 10, 640, 200);
 * vtkNew<vtkContextActor> actor;
 * actor->GetScene()->AddItem(chart);
 * renderer->AddActor(actor);
 * // after each frame, for the next one:
 * chart->SetStatistics(pass->GetStatistics());
 * @endcode
 *
 * @sa vtkGIPass::GetStatistics()
 */
#ifndef vtkGIFrameChart_h
#define vtkGIFrameChart_h

#include "vtkContextItem.h"
#include "vtkRenderingGIModule.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class VTKRENDERINGGI_EXPORT vtkGIFrameChart : public vtkContextItem
{
public:
  static vtkGIFrameChart* New();
  vtkTypeMacro(vtkGIFrameChart, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Show the statistics of a frame. If the text is no such JSON, it returns false, GetLastError() tells why, and the chart
   * keeps what it shows.
   */
  bool SetStatistics(const char* json);

  /**
   * Reason why SetStatistics() or WriteSVG() returned false; empty if they did not.
   */
  const char* GetLastError();

  ///@{
  /**
   * Title of the chart, such as the name of the scene. Default: none.
   */
  void SetTitle(const char* title);
  const char* GetTitle();
  ///@}

  ///@{
  /**
   * A dark translucent panel, for overlays, instead of a white page. Default: on.
   */
  vtkSetMacro(Panel, bool);
  vtkGetMacro(Panel, bool);
  vtkBooleanMacro(Panel, bool);
  ///@}

  ///@{
  /**
   * The part of the scene to draw in, in pixels: left, bottom, width, height. A width or height of 0 stands for the rest of
   * the scene. Default: the complete scene.
   */
  vtkSetVector4Macro(Area, int);
  vtkGetVector4Macro(Area, int);
  ///@}

  /**
   * Write the chart to a file (.svg), in pixels, on a white page. Needs no OpenGL. Returns false, and GetLastError() tells
   * why, if that is impossible.
   */
  bool WriteSVG(const char* path, int width, int height);

  bool Paint(vtkContext2D* painter) override;

protected:
  vtkGIFrameChart();
  ~vtkGIFrameChart() override;

private:
  vtkGIFrameChart(const vtkGIFrameChart&) = delete;
  void operator=(const vtkGIFrameChart&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Impl;
  bool Panel = true;
  int Area[4] = { 0, 0, 0, 0 };
};

#endif
