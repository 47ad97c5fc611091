// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIShadowMaps
 * @brief   shadow maps for directional, cone and omnidirectional lights
 *
 * Every light except headlights, whose shadows are hidden from the camera, gets a depth map: six if its
 * cone is wider than 60 degrees half aperture, up to four cascades if it is directional and the scene
 * reaches from near to far. The props' own mappers draw the maps, so glyphs, impostors, clipped and
 * masked geometry cast shadows of what they show. All maps share one atlas. A per-pixel pass filters them
 * into the visibility of direct light, over a penumbra if lights have a size. A map is redrawn only if
 * its light, its view or a caster changed.
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
   * Redraw every map in every frame, even if nothing changed. For measurements; off by default.
   */
  vtkSetMacro(AlwaysRedraw, bool);
  vtkGetMacro(AlwaysRedraw, bool);
  vtkBooleanMacro(AlwaysRedraw, bool);

  /**
   * Numbers of the last frame: lights that cast shadows; lights that do not because they exceed
   * MaximumLights or Memory; maps that were redrawn.
   */
  vtkGetMacro(ShadowedLights, int);
  vtkGetMacro(UnshadowedLights, int);
  vtkGetMacro(DrawnMaps, int);

  /**
   * Width of a texel in the first map of the strongest light of the last frame, in world units; at
   * distance 1 from the light if it is positional. 0 if no light casts shadows.
   */
  vtkGetMacro(TexelWidth, double);

protected:
  vtkGIShadowMaps();
  ~vtkGIShadowMaps() override;

private:
  vtkGIShadowMaps(const vtkGIShadowMaps&) = delete;
  void operator=(const vtkGIShadowMaps&) = delete;

  struct Resources;
  struct AtlasContents;
  bool UpdatePlan(penumbra::FrameBuilder& frame);
  void DrawMaps(penumbra::FrameContext& context, penumbra::SceneCapture& scene,
    const penumbra::History& atlas, AtlasContents& contents);
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
