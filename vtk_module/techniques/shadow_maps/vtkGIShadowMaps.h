// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIShadowMaps
 * @brief   shadow maps for directional, cone and omnidirectional lights
 *
 * Every light but a headlight, whose shadows its own eye cannot see, gets a depth map (six if it
 * shines wider than a cone of 60 degrees half aperture, up to four cascades if it is directional and
 * the scene reaches from near to far), drawn by the props' own mappers: glyphs, impostors, clipping
 * and masked opacity cast what they show. All lie in one atlas. A per-pixel pass filters them into the
 * direct light's visibility, over a penumbra where lights have a size. Each map is kept until its
 * light, a caster, or what it shows changes.
 */
#ifndef vtkGIShadowMaps_h
#define vtkGIShadowMaps_h

#include "vtkGIShadowMapsParameters.h"

#include <memory> // for the resources

namespace penumbra
{
class Arguments;
class FrameContext;
class SceneCapture;
struct History;
}

class VTKRENDERINGGI_EXPORT vtkGIShadowMaps : public vtkGIShadowMapsParameters
{
public:
  static vtkGIShadowMaps* New();
  vtkTypeMacro(vtkGIShadowMaps, vtkGIShadowMapsParameters);

  const char* GetOfferedResource() override;
  int GetRank() override { return 1; }
  void Contribute(penumbra::FrameBuilder& frame) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Draw every map anew in every frame, also where nothing changed. For measuring; off by default.
   */
  vtkSetMacro(AlwaysRedraw, bool);
  vtkGetMacro(AlwaysRedraw, bool);
  vtkBooleanMacro(AlwaysRedraw, bool);

  /**
   * Of the last frame: lights that cast shadows, lights that would but exceeded MaximumLights or found
   * no room in Memory, and maps that were drawn rather than kept.
   */
  vtkGetMacro(ShadowedLights, int);
  vtkGetMacro(UnshadowedLights, int);
  vtkGetMacro(DrawnMaps, int);

  /**
   * Of the last frame: width of a texel in the first map of the strongest light, in world units; at
   * unit distance from the light where that is positional. 0 without a light that casts shadows.
   */
  vtkGetMacro(TexelWidth, double);

protected:
  vtkGIShadowMaps();
  ~vtkGIShadowMaps() override;

private:
  vtkGIShadowMaps(const vtkGIShadowMaps&) = delete;
  void operator=(const vtkGIShadowMaps&) = delete;

  struct Resources;
  struct ShownSquares;
  bool MakePlan(penumbra::FrameBuilder& frame);
  void DrawMaps(penumbra::FrameContext& context, penumbra::SceneCapture& scene,
    const penumbra::History& atlas, ShownSquares& before);
  void ShadeForward(penumbra::FrameBuilder& frame);
  penumbra::Arguments FilterArguments(bool volume);

  bool AlwaysRedraw = false;
  int ShadowedLights = 0;
  int UnshadowedLights = 0;
  int DrawnMaps = 0;
  double TexelWidth = 0.0;
  std::unique_ptr<Resources> Impl;
};

#endif
