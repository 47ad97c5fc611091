// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGILightmap
 * @brief   diffuse indirect light from a texture that was baked for the surfaces
 *
 * `penumbra bake lightmap` writes a lightmap; penumbra.load_bake() and `penumbra render --bake` load it. The baked
 * triangles are drawn over the pixels that show them, with one texture fetch each. Props that were not baked, such as
 * moving ones, get no light from the map; another technique can light them. A map may also include direct light with
 * its shadows; then only highlights are computed in each frame.
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

  /**
   * Use a baked map, or none (nullptr). Both arguments are copied.
   *
   * surfaces: triangles in world coordinates, counter-clockwise seen from the lit side, with normals and texture
   * coordinates at points (0 to 1, from the first row of the image on), and a string field array "scene" with the
   * DescribeScene() of the baked scene.
   *
   * light: a float image with 3 components, irradiance divided by pi. It may have 12: first moments follow, which are
   * used with normal maps. They are the means over the hemisphere of radiance times x, y and z of its direction in
   * the world, each in red, green and blue. The moment along the surface's normal may be reduced by a quarter of the
   * radiance near the horizon, because a normal keeps that light when it tilts; the baker does so. The image may then
   * have the same number of components again, for the direct light of all lights that do not follow the camera. These
   * do not light the surfaces again.
   *
   * Returns false, with an error that gives the reason, and keeps the previous map if the arguments are not of this
   * form.
   */
  bool SetBake(vtkPolyData* surfaces, vtkImageData* light);

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
};

#endif
