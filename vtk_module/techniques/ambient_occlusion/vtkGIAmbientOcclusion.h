// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIAmbientOcclusion
 * @brief   how open a surface is to light from all around, from the depth buffer
 *
 * By horizons: in planes around the view direction, how high the surroundings rise over a pixel's
 * surface, and in closed form the light above. Or by points in the hemisphere over it, each hidden
 * or not. At full or half resolution; filters aware of depth and normal average the noise away. The
 * result multiplies ambient and indirect light
 * only, never direct light or emission. Occluders off the screen, or behind what is seen, are not
 * known.
 */
#ifndef vtkGIAmbientOcclusion_h
#define vtkGIAmbientOcclusion_h

#include "vtkGIAmbientOcclusionParameters.h"

#include <map>    // for variants of shaders
#include <memory> // for the resources
#include <string> // for variants of shaders

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

  // Fill in the pass that samples. variant: what its shader is compiled with.
  void DeclareHemisphere(penumbra::PassDeclaration& pass,
    std::map<std::string, std::string> variant, double radius, const penumbra::Drawing& drawing);
  void DeclareHorizon(penumbra::PassDeclaration& pass, std::map<std::string, std::string> variant,
    double radius, double thickness, const penumbra::Drawing& drawing);

  struct Resources;
  std::unique_ptr<Resources> Impl;
};

#endif
