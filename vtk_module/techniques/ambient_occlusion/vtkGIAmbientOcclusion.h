// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIAmbientOcclusion
 * @brief   visibility of ambient light, approximated from the depth buffer
 *
 * The horizon method finds, in slices around the view direction, how high the surroundings rise above
 * a pixel's surface, and integrates the light above them in closed form. The hemisphere method counts
 * how many points in the hemisphere above the surface are hidden. Both work at full or half resolution;
 * filters that respect depth and normals average the noise. The result multiplies ambient and indirect
 * light, never direct light or emission. Occluders that are off the screen or behind visible surfaces
 * are missed.
 */
#ifndef vtkGIAmbientOcclusion_h
#define vtkGIAmbientOcclusion_h

#include "vtkGIAmbientOcclusionParameters.h"

#include <map>    // for shader variants
#include <memory> // for the resources
#include <string> // for shader variants

namespace penumbra
{
class PassDeclaration;
struct Drawing;
}

class VTKRENDERINGGI_EXPORT vtkGIAmbientOcclusion : public vtkGIAmbientOcclusionParameters
{
public:
  static vtkGIAmbientOcclusion* New();
  vtkTypeMacro(vtkGIAmbientOcclusion, vtkGIAmbientOcclusionParameters);

  const char* GetOfferedResource() override;
  void Plan(penumbra::LightingPlan& plan, penumbra::FrameBuilder& frame) override;
  void Contribute(penumbra::FrameBuilder& frame) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGIAmbientOcclusion();
  ~vtkGIAmbientOcclusion() override;

private:
  vtkGIAmbientOcclusion(const vtkGIAmbientOcclusion&) = delete;
  void operator=(const vtkGIAmbientOcclusion&) = delete;

  // Complete the sampling pass. variant: the defines of its shader.
  void DeclareHemisphere(penumbra::PassDeclaration& pass,
    std::map<std::string, std::string> variant, double radius, const penumbra::Drawing& drawing);
  void DeclareHorizon(penumbra::PassDeclaration& pass, std::map<std::string, std::string> variant,
    double radius, double thickness, const penumbra::Drawing& drawing);

  struct Resources;
  std::unique_ptr<Resources> Impl;
};

#endif
