// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGILightGatherer
 * @brief   gathers the light that arrives at points of a renderer's scene, by path tracing on the GPU
 *
 * Bakes are made with it. It counts light that was reflected at least once or emitted by a surface or the
 * environment, and direct light of lights only with IncludeLamps. Russian roulette ends the paths, so the mean has no
 * bias except that of Bounces. Lights that follow the camera (headlights and camera lights) cannot be baked, and are
 * left out.
 *
 * Light is radiance in the units of VTK's materials: a light of colour c at normal incidence gives an irradiance of pi
 * times c.
 *
 * Results are means over Samples paths. Paths are numbered: the average of a call with FirstSample = a and Samples = n
 * and one with FirstSample = a + n and as many samples is the result of a single call with 2n samples. The paths of a
 * point depend on its coordinates and Seed, not on other points.
 *
 * ProgressEvent is invoked with the fraction of the work that is done, a double from 0 to 1. An observer may call
 * AbortOn().
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
   * Number of paths from each point, 256 by default. Powers of two are distributed most evenly.
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
   * Maximum number of reflections of a path, 64 by default. With it a closed box of reflectance 0.8 lacks 0.0001 % of
   * its light.
   */
  vtkSetClampMacro(Bounces, int, 1, 10000);
  vtkGetMacro(Bounces, int);
  ///@}

  ///@{
  /**
   * Seed of the random paths, 0 by default.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Include direct light of lights. Off by default.
   */
  vtkSetMacro(IncludeLamps, bool);
  vtkGetMacro(IncludeLamps, bool);
  vtkBooleanMacro(IncludeLamps, bool);
  ///@}

  ///@{
  /**
   * Include light that was reflected, or emitted by surfaces and the environment. On by default. Without it no paths
   * are traced, and surroundings are 0.
   */
  vtkSetMacro(IncludeIndirect, bool);
  vtkGetMacro(IncludeIndirect, bool);
  vtkBooleanMacro(IncludeIndirect, bool);
  ///@}

  ///@{
  /**
   * For points with normals, also return how light is distributed over the hemisphere. Off by default.
   */
  vtkSetMacro(Directional, bool);
  vtkGetMacro(Directional, bool);
  vtkBooleanMacro(Directional, bool);
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

  /**
   * Gather light at points (three components, world coordinates).
   *
   * Without normals (nullptr), light gets 27 components: nine spherical harmonics, bands 0 to 2, of the incoming
   * radiance, each for red, green and blue, in the order of Ramamoorthi and Hanrahan 2001 (1; y, z, x; xy, yz,
   * 3z^2 - 1, xz, x^2 - y^2). They are orthonormal over the sphere: radiance 1 from all directions gives sqrt(4 pi) in
   * the first.
   *
   * With normals (three components, unit length), it gets 3 components: irradiance divided by pi. With Directional, 12
   * more follow, each for red, green and blue: the mean of the radiance L over the hemisphere, and the means of L x,
   * L y and L z for unit directions (x, y, z) in the world. Points lie on surfaces or slightly off them; rays start a
   * few millionths of the scene's size away along the normal.
   *
   * surroundings, if not nullptr, gets three components: the share of rays that hit a backface, the share that hit any
   * surface, and the mean distance of the hits (0 if there are none).
   *
   * Returns false, with the reason in GetLastError() and unchanged arrays, if the arrays have other shapes, the
   * renderer has no OpenGL 4.3 window, or the scene does not fit into memory; without a reason if it was aborted.
   */
  bool Gather(vtkRenderer* renderer, vtkDataArray* points, vtkDataArray* normals,
    vtkFloatArray* light, vtkFloatArray* surroundings = nullptr);

  /**
   * Numbers of the last call: lights that were left out because they follow the camera, and visible props of kinds
   * that rays do not see.
   */
  int GetNumberOfLampsLeftOut();
  int GetNumberOfPropsLeftOut();

  /**
   * The reason why the last call returned false, or "".
   */
  const char* GetLastError();

  /**
   * Free GPU resources, such as the scene for rays. They keep the render window alive until then.
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
  double MaximumAlbedo = 1.0;
  bool EnergyCompensation = false;

private:
  vtkGILightGatherer(const vtkGILightGatherer&) = delete;
  void operator=(const vtkGILightGatherer&) = delete;

  bool Trace(vtkRenderer* renderer, vtkDataArray* points, vtkDataArray* normals,
    std::size_t numbers, std::vector<double>& sums);

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
