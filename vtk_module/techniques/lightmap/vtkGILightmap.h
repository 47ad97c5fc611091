// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGILightmap
 * @brief   diffuse indirect light from a texture that was baked for the surfaces
 *
 * `penumbra bake lightmap` writes the picture; vtkGIBakeFile brings it here.
 * The baked triangles are drawn over the pixels that show them, with one fetch each. Props that the bake does not
 * know, moving ones for instance, get no light from it: another technique lights them. A map may hold the lamps' own
 * light too, shadows included, of which highlights alone are then left to each frame.
 *
 * The bake is valid as long as the baked props, the lights and the environment do not change. From the first frame in
 * which one did, vtkGIPass::GetNotes() names it, and the map lights nothing.
 */
#ifndef vtkGILightmap_h
#define vtkGILightmap_h

#include "vtkGILightmapParameters.h"

#include <memory> // for the state
#include <string> // for text

class vtkImageData;
class vtkPolyData;
class vtkRenderer;

class VTKRENDERINGGI_EXPORT vtkGILightmap : public vtkGILightmapParameters
{
public:
  static vtkGILightmap* New();
  vtkTypeMacro(vtkGILightmap, vtkGILightmapParameters);

  ///@{
  /**
   * A baked map, read by vtkGIBakeFile or made by JoinBake().
   */
  const char* GetBakeFormat() override { return "penumbra lightmap"; }
  bool SetBake(vtkImageData* bake) override;
  const char* GetBakeError() override;
  ///@}

  ///@{
  /**
   * A map in two parts. surfaces: triangles in world coordinates, counter-clockwise from the
   * side that the light is for, with normals and texture coordinates (0 to 1, rows of the picture from the first
   * on) at points, and a field array of strings "scene" with DescribeScene() of what was baked. light: a float
   * image of 3 components, irradiance divided by pi, or of 12, followed by first moments for normals that pictures
   * bend: the means over the hemisphere of radiance times x, y and z of its direction in the world, each in red,
   * green and blue. Along the surface's normal they may be less, by a quarter of the radiance near the horizon,
   * which a normal keeps as it turns: the baker's are. As many components may follow with the same of the light that
   * arrives straight from the lamps: matter there is not lit by these again, but by lamps that follow the camera.
   * JoinBake() makes one image of both, which vtkGIBakeFile writes.
   */
  bool SetBake(vtkPolyData* surfaces, vtkImageData* light);
  bool JoinBake(vtkPolyData* surfaces, vtkImageData* light, vtkImageData* bake);
  ///@}

  /**
   * Whether there is a map, and whether it includes direct light.
   */
  bool HasBake();
  bool HasLampLight();

  /**
   * Describe everything that a bake of the renderer's scene depends on as text: the positions, shapes and appearance of
   * the visible props that rays see, the lights that do not follow the camera, and the environment.
   */
  static std::string DescribeScene(vtkRenderer* renderer);

  /**
   * The difference between the baked scene and the renderer's last frame, such as "light 1 moved"; "" if the map fits.
   */
  std::string GetMismatch(vtkRenderer* renderer);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGILightmap();
  ~vtkGILightmap() override;

private:
  vtkGILightmap(const vtkGILightmap&) = delete;
  void operator=(const vtkGILightmap&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Impl;
  std::string Error;
};

#endif
