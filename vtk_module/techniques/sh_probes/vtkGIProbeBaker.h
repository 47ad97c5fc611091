// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIProbeBaker
 * @brief   puts probes into a renderer's scene and gathers the light that arrives there
 *
 * What it makes is for vtkGISHProbes: an image whose points are the places of a grid of probes, or where there are
 * several grids all of their probes in a row, grid by grid, x first; with these arrays at points: "light" (27 components: vtkGILightGatherer's harmonics of radiance), "distance" (512: the mean and
 * standard deviation of how far surfaces are, in an octahedral map of 16 x 16 directions, rows first, in units of
 * 1.5 diagonals of a cell, at most 1), "offset" (3: how far the probe stands off its place, in cells), "sight" (a
 * bit for each of 13 neighbours that it sees) and "backs" (0 to 255: the share of directions in which it sees
 * backs of surfaces); and field arrays "format", "scene" (what the bake depends on), "samples", "light scale", "checksum" (of
 * the grid and all of these: a field that was altered since is refused, unless that array is removed) and, of several
 * grids, "grids" (9: the first place, the spacing and the counts of each).
 * Compact() stores light and distance as half floats, light over "light scale".
 *
 * ProgressEvent is invoked with the share of the work that is done, a double from 0 to 1; an observer may call
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
   * So many probes can be shown: what textures of 16384 texels a side hold, that all graphics cards have.
   */
  enum : int
  {
    MostProbes = 828100 // 910 x 910
  };

  ///@{
  /**
   * How many probes at most fill the bounds of the visible props, in grids of nearly cubic cells, the first of which
   * reaches half a cell beyond; 27 to MostProbes, 1024 by default.
   */
  vtkSetClampMacro(Probes, int, 27, MostProbes);
  vtkGetMacro(Probes, int);
  ///@}

  ///@{
  /**
   * Largest distance between neighbours, world units, in one grid; 0, the default, leaves it to Probes.
   */
  vtkSetClampMacro(Spacing, double, 0.0, 1e300);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Share the probes among a grid around all and finer ones, up to five, where the light of one grid errs most. That
   * is found out with some paths at points of the surfaces; where several grids err hardly less, there is one. Off by
   * default. Nothing where Spacing is set.
   */
  vtkSetMacro(Adaptive, bool);
  vtkGetMacro(Adaptive, bool);
  vtkBooleanMacro(Adaptive, bool);
  ///@}

  ///@{
  /**
   * Move probes off surfaces that are close, and out of what is solid. On by default.
   */
  vtkSetMacro(Relocate, bool);
  vtkGetMacro(Relocate, bool);
  vtkBooleanMacro(Relocate, bool);
  ///@}

  ///@{
  /**
   * As vtkGILightGatherer's; Samples are what Bake() takes. 1024 samples, 64 bounces, seed 0 by default.
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
   * End the call that runs, soon. Each call switches it off as it begins.
   */
  vtkSetMacro(Abort, bool);
  vtkGetMacro(Abort, bool);
  vtkBooleanMacro(Abort, bool);
  ///@}

  ///@{
  /**
   * Place probes in the scene as it is shown now, without light yet; then add the light of so many more samples,
   * as often as wanted: the mean of all is kept, as if they had been taken at once. Or all of it, with Compact().
   * They return false, with a sentence in GetLastError() and the field as it was, for a renderer without an
   * OpenGL 4.3 window, a scene without bounds or too large, or a field that is not of this scene; and without a
   * sentence where they were aborted.
   */
  bool Place(vtkRenderer* renderer, vtkImageData* field);
  bool AddSamples(vtkRenderer* renderer, vtkImageData* field, int samples);
  bool Bake(vtkRenderer* renderer, vtkImageData* field);
  ///@}

  /**
   * The same field with half floats. Returns false, with a sentence, where it is none.
   */
  bool Compact(vtkImageData* field, vtkImageData* compact);

  /**
   * Whether a field was placed in the scene as it is shown now. If not, GetLastError() says what differs.
   */
  bool Fits(vtkRenderer* renderer, vtkImageData* field);

  ///@{
  /**
   * The grids of a field, 0 where it is none; and of one of them, the first being around all, how many probes it has
   * along each axis and from where to where they stand (as VTK's bounds). Returns false, with a sentence in
   * GetLastError(), where there is no such grid.
   */
  int CountGrids(vtkImageData* field);
  bool GetGrid(vtkImageData* field, int number, int counts[3], double bounds[6]);
  ///@}

  ///@{
  /**
   * How many grids were tried in place of one when probes were last placed, 0 where none were, as where Adaptive is off
   * or too little was to be gained; and what they left of one grid's squared error, as far as a few paths tell (below zero
   * by chance where there is next to none).
   */
  int GetNumberOfTriedGrids();
  double GetErrorOfTriedGrids();
  ///@}

  /**
   * The samples that a field is the mean of, or -1 with a sentence in GetLastError() where it is none.
   */
  int CountSamples(vtkImageData* field);

  /**
   * Of the last call: lamps that follow the camera and were left out, and visible props of kinds that rays do not
   * see.
   */
  int GetNumberOfLampsLeftOut();
  int GetNumberOfPropsLeftOut();

  /**
   * Why the last call returned false, or "".
   */
  const char* GetLastError();

  /**
   * Free what is kept on the GPU. The render window lives on until then.
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
  int Seed = 0;
  bool Abort = false;

private:
  vtkGIProbeBaker(const vtkGIProbeBaker&) = delete;
  void operator=(const vtkGIProbeBaker&) = delete;

  bool Tell(double progress);
  void Forward(vtkObject* caller, unsigned long event, void* progress);

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
