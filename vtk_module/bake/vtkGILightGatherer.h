// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGILightGatherer
 * @brief   the light that arrives at points of a renderer's scene, by path tracing on the GPU
 *
 * What bakes are made with. Light counts that was reflected at least once, or that a surface or the
 * environment gives off; straight from the lamps only with IncludeLamps. Every path is followed until
 * chance ends it (Russian roulette), so that the mean has no bias but that of Bounces. Lamps that follow the
 * camera (headlights, camera lights) have no place in what is kept, and are left out.
 *
 * All light is radiance as VTK's materials count it: a lamp of colour c that shines straight on a surface
 * stands for an irradiance of pi times c.
 *
 * Results are means over Samples paths. Paths are numbered: a call with FirstSample = a and Samples = n, and
 * one with FirstSample = a + n and as many samples, average to what one call with 2n samples returns. The
 * paths of a point depend on its coordinates and Seed, not on what other points are asked for.
 *
 * ProgressEvent is invoked with the share of the work that is done, a double from 0 to 1; an observer may
 * call AbortOn().
 */
#ifndef vtkGILightGatherer_h
#define vtkGILightGatherer_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

#include <memory> // for the implementation
#include <vector> // for sums

class vtkDataArray;
class vtkFloatArray;
class vtkRenderer;
class vtkWindow;

class VTKRENDERINGGI_EXPORT vtkGILightGatherer : public vtkObject
{
public:
  static vtkGILightGatherer* New();
  vtkTypeMacro(vtkGILightGatherer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Paths from each point; 256 by default. Powers of two are spread most evenly.
   */
  vtkSetClampMacro(Samples, int, 1, 1 << 24);
  vtkGetMacro(Samples, int);
  ///@}

  ///@{
  /**
   * The number of the first path, 0 by default.
   */
  vtkSetClampMacro(FirstSample, int, 0, 1 << 30);
  vtkGetMacro(FirstSample, int);
  ///@}

  ///@{
  /**
   * Reflections after which a path ends in any case; 64 by default, after which a closed box that reflects
   * 0.8 of its light lacks 0.0001 %.
   */
  vtkSetClampMacro(Bounces, int, 1, 10000);
  vtkGetMacro(Bounces, int);
  ///@}

  ///@{
  /**
   * Another seed makes other paths; 0 by default.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Count light that arrives straight from lamps too. Off by default.
   */
  vtkSetMacro(IncludeLamps, bool);
  vtkGetMacro(IncludeLamps, bool);
  vtkBooleanMacro(IncludeLamps, bool);
  ///@}

  ///@{
  /**
   * Count light that was reflected, or is given off by surfaces and the environment. On by default. Without it no
   * path is followed, and surroundings are 0.
   */
  vtkSetMacro(IncludeIndirect, bool);
  vtkGetMacro(IncludeIndirect, bool);
  vtkBooleanMacro(IncludeIndirect, bool);
  ///@}

  ///@{
  /**
   * Of points with normals, return how light is spread over the hemisphere too. Off by default.
   */
  vtkSetMacro(Directional, bool);
  vtkGetMacro(Directional, bool);
  vtkBooleanMacro(Directional, bool);
  ///@}

  ///@{
  /**
   * End the call that runs, soon. Each call switches it off as it begins.
   */
  vtkSetMacro(Abort, bool);
  vtkGetMacro(Abort, bool);
  vtkBooleanMacro(Abort, bool);
  ///@}

  /**
   * Gather light at points (three components, world coordinates).
   *
   * Without normals (nullptr) light has 27 components: the nine spherical harmonics of bands 0 to 2 of the
   * radiance from all around, of red, green and blue each, in the order of Ramamoorthi and Hanrahan 2001 (1;
   * y, z, x; xy, yz, 3z^2 - 1, xz, x^2 - y^2), orthonormal over the sphere: radiance 1 from everywhere is
   * sqrt(4 pi) in the first.
   *
   * With normals (three components, unit) it has 3: irradiance divided by pi. With Directional 12 more
   * follow, of red, green and blue each: the mean of radiance L over the hemisphere, and the means of L x,
   * L y and L z, of unit directions (x, y, z) in the world. Points lie on surfaces or a little off them;
   * rays start a few millionths of the scene's size off, along the normal.
   *
   * surroundings, if not nullptr, gets three components: the share of rays that met the back of a surface,
   * the share that met any surface, and the mean distance of those (0 where there were none).
   *
   * Returns false, with a sentence in GetLastError() and the arrays as they were, for points of another
   * shape, a renderer without an OpenGL 4.3 window, or a scene that does not fit into memory; and without
   * one where it was aborted.
   */
  bool Gather(vtkRenderer* renderer, vtkDataArray* points, vtkDataArray* normals,
    vtkFloatArray* light, vtkFloatArray* surroundings = nullptr);

  /**
   * Of the last call: lamps that follow the camera and were left out, and visible props of kinds that rays
   * do not see.
   */
  int GetNumberOfLampsLeftOut();
  int GetNumberOfPropsLeftOut();

  /**
   * Why the last call returned false, or "".
   */
  const char* GetLastError();

  /**
   * Free what is kept on the GPU, such as the scene for rays. The render window lives on until then.
   */
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkGILightGatherer();
  ~vtkGILightGatherer() override;

  int Samples = 256;
  int FirstSample = 0;
  int Bounces = 64;
  int Seed = 0;
  bool IncludeLamps = false;
  bool IncludeIndirect = true;
  bool Directional = false;
  bool Abort = false;

private:
  vtkGILightGatherer(const vtkGILightGatherer&) = delete;
  void operator=(const vtkGILightGatherer&) = delete;

  bool Trace(vtkRenderer* renderer, vtkDataArray* points, vtkDataArray* normals,
    std::size_t numbers, std::vector<double>& sums);

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
