// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIProbeBaker
 * @brief   places probes in a renderer's scene and gathers the light that arrives there
 *
 * The result is a field for vtkGISHProbes: an image whose points are the points of a grid of probes, or all probes in a
 * row, grid by grid, x first, if there are several grids. Its point arrays are:
 * - "light", 27 components: radiance in spherical harmonics, see vtkGILightGatherer;
 * - "distance", 512 components: the mean and standard deviation of distances to surfaces, in an octahedral map of
 *   16 x 16 directions, row by row, in units of 1.5 diagonals of a cell, at most 1;
 * - "offset", 3 components: offset of the probe from its grid point, in cells;
 * - "sight": a bit for each of 13 neighbours that is visible;
 * - "backs", 0 to 255: the share of directions in which the probe sees backfaces.
 *
 * Its field arrays are "format"; "scene", which describes what the bake depends on; "samples"; "light scale";
 * "checksum", of the grid and all of these arrays (a field that was altered is refused, unless this array is removed);
 * and with several grids "grids", 9 components: position of the first probe, spacing and counts of each grid.
 * Compact() stores light and distances as half floats, light relative to "light scale".
 *
 * ProgressEvent is invoked with the fraction of the work that is done, a double from 0 to 1. An observer may call
 * AbortOn().
 */
#ifndef vtkGIProbeBaker_h
#define vtkGIProbeBaker_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

#include <memory> // for the implementation

class vtkImageData;
class vtkRenderer;
class vtkWindow;

class VTKRENDERINGGI_EXPORT vtkGIProbeBaker : public vtkObject
{
public:
  static vtkGIProbeBaker* New();
  vtkTypeMacro(vtkGIProbeBaker, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Maximum number of probes: as many as fit into textures of 16384 x 16384 texels, which all GPUs support.
   */
  enum : int
  {
    MostProbes = 828100 // 910 x 910
  };

  ///@{
  /**
   * Maximum number of probes that fill the bounds of the visible props, in grids of nearly cubic cells. The first grid
   * extends half a cell beyond the bounds. 27 to MostProbes, 1024 by default.
   */
  vtkSetClampMacro(Probes, int, 27, MostProbes);
  vtkGetMacro(Probes, int);
  ///@}

  ///@{
  /**
   * Maximum distance between neighbouring probes of a single grid, in world units. 0, the default, derives it from
   * Probes.
   */
  vtkSetClampMacro(Spacing, double, 0.0, 1e300);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Share the probes between a grid around the whole scene and up to five finer ones, placed where the light of a
   * single grid has the largest errors. These are estimated with a few paths at points on surfaces. If several grids
   * have hardly smaller errors, a single grid is used. Off by default; ignored if Spacing is set.
   */
  vtkSetMacro(Adaptive, bool);
  vtkGetMacro(Adaptive, bool);
  vtkBooleanMacro(Adaptive, bool);
  ///@}

  ///@{
  /**
   * Move probes away from close surfaces, and out of solid objects. On by default.
   */
  vtkSetMacro(Relocate, bool);
  vtkGetMacro(Relocate, bool);
  vtkBooleanMacro(Relocate, bool);
  ///@}

  ///@{
  /**
   * The same as those of vtkGILightGatherer. Samples is used by Bake(). 1024 samples, 64 bounces and seed 0 by default.
   */
  vtkSetClampMacro(Samples, int, 1, 1 << 24);
  vtkGetMacro(Samples, int);
  vtkSetClampMacro(Bounces, int, 1, 10000);
  vtkGetMacro(Bounces, int);
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Reflection of the surfaces, as by the parameters of vtkGIReflectance: the share of the light that a white surface
   * reflects, 1 by default, and whether rough metals keep their light, off by default. Pictures must be drawn with the
   * values of the bake.
   */
  vtkSetClampMacro(MaximumAlbedo, double, 0.0, 1.0);
  vtkGetMacro(MaximumAlbedo, double);
  vtkSetMacro(EnergyCompensation, bool);
  vtkGetMacro(EnergyCompensation, bool);
  vtkBooleanMacro(EnergyCompensation, bool);
  ///@}

  ///@{
  /**
   * Abort the running call soon. Each call switches this off when it starts.
   */
  vtkSetMacro(Abort, bool);
  vtkGetMacro(Abort, bool);
  vtkBooleanMacro(Abort, bool);
  ///@}

  ///@{
  /**
   * Place() puts probes into the scene as it is now, without light. AddSamples() adds the light of further samples, and
   * may be called repeatedly: the mean over all calls is the same as of a single one. Bake() does both and Compact().
   * They return false, with the reason in GetLastError() and the field unchanged, if the renderer has no OpenGL 4.3
   * window, the scene has no bounds or is too large, or the field belongs to another scene; without a reason if they
   * were aborted.
   */
  bool Place(vtkRenderer* renderer, vtkImageData* field);
  bool AddSamples(vtkRenderer* renderer, vtkImageData* field, int samples);
  bool Bake(vtkRenderer* renderer, vtkImageData* field);
  ///@}

  /**
   * Convert a field to half floats. Returns false, with the reason in GetLastError(), if it is not a valid field.
   */
  bool Compact(vtkImageData* field, vtkImageData* compact);

  /**
   * Whether a field was placed in the scene as it is now. If not, GetLastError() says what differs.
   */
  bool Fits(vtkRenderer* renderer, vtkImageData* field);

  ///@{
  /**
   * CountGrids(): the number of grids of a field, 0 if it is not valid. GetGrid(): the number of probes of one grid
   * along each axis, and the bounds of their positions; the first grid surrounds the whole scene. GetGrid() returns
   * false, with the reason in GetLastError(), if there is no such grid.
   */
  int CountGrids(vtkImageData* field);
  bool GetGrid(vtkImageData* field, int number, int counts[3], double bounds[6]);
  ///@}

  ///@{
  /**
   * Number of grids that were tried in place of one when probes were last placed: 0 if none were, because Adaptive is
   * off or little was to be gained. The error is their squared error as a fraction of the single grid's, estimated with
   * a few paths, so that it may be negative if it is almost zero.
   */
  int GetNumberOfTriedGrids();
  double GetErrorOfTriedGrids();
  ///@}

  /**
   * Number of samples in a field, or -1, with the reason in GetLastError(), if it is not a valid field.
   */
  int CountSamples(vtkImageData* field);

  /**
   * Numbers of the last call: lights that were left out because they follow the camera, and visible props of kinds that
   * rays do not see.
   */
  int GetNumberOfLampsLeftOut();
  int GetNumberOfPropsLeftOut();

  /**
   * The reason why the last call returned false, or "".
   */
  const char* GetLastError();

  /**
   * Free GPU resources. They keep the render window alive until then.
   */
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkGIProbeBaker();
  ~vtkGIProbeBaker() override;

  int Probes = 1024;
  double Spacing = 0.0;
  bool Adaptive = false;
  bool Relocate = true;
  int Samples = 1024;
  int Bounces = 64;
  double MaximumAlbedo = 1.0;
  bool EnergyCompensation = false;
  int Seed = 0;
  bool Abort = false;

private:
  vtkGIProbeBaker(const vtkGIProbeBaker&) = delete;
  void operator=(const vtkGIProbeBaker&) = delete;

  bool ReportProgress(double progress);
  void ForwardProgress(vtkObject* caller, unsigned long event, void* progress);

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
