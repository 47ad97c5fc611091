// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGISkyLight
 * @brief   diffuse light from the environment, with its true visibility
 *
 * The renderer's environment texture lights all surfaces, Phong and PBR alike, where UseImageBasedLighting is on. Many
 * small shadow maps from directions of the sky, drawn by its radiance, tell how much of it a point sees. They need no
 * GPU and no rays, and stay while nothing but the camera moves. Still frames go on with other directions and average, so
 * that a still picture converges to the exact integral. Without an environment the technique does nothing.
 */
#ifndef vtkGISkyLight_h
#define vtkGISkyLight_h

#include "vtkGISkyLightParameters.h"

namespace penumbra
{
class FrameBuilder;
class FrameContext;
class Texture;
struct ForwardPart;
}

class VTKRENDERINGGI_EXPORT vtkGISkyLight : public vtkGISkyLightParameters
{
public:
  static vtkGISkyLight* New();
  vtkTypeMacro(vtkGISkyLight, vtkGISkyLightParameters);

  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;
  int GetRequiredFrames() override;
  bool IsFinished(vtkRenderer* renderer) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Number of maps drawn in the last frame of a renderer.
   */
  int GetDrawnMaps(vtkRenderer* renderer);

protected:
  vtkGISkyLight();
  ~vtkGISkyLight() override;

private:
  vtkGISkyLight(const vtkGISkyLight&) = delete;
  void operator=(const vtkGISkyLight&) = delete;

  struct ViewLight;
  struct Grid;
  const ViewLight* Find(vtkRenderer* renderer) const;
  void AddMaps(penumbra::FrameBuilder& frame, ViewLight& light);
  void AddLookups(penumbra::FrameBuilder& frame, ViewLight& light);
  void LookUp(penumbra::FrameContext& context, const ViewLight& light, const Grid& grid,
    int lookups, const penumbra::Texture& target);
  penumbra::ForwardPart MakeForwardPart(penumbra::FrameBuilder& frame, const ViewLight& light);
};

#endif
