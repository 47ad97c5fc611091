// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A renderer with one of its lights under study: what of it arrives, by shadow maps and by rays.
#ifndef penumbra_tool_ShadowBench_h
#define penumbra_tool_ShadowBench_h

#include "lab/BiasMeasures.h"
#include "scene/model/SceneModel.h"

#include <vtkGIPass.h>
#include <vtkLight.h>
#include <vtkProp.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkGITechnique;

namespace penumbra::tool
{
/// Puts a pass of its own on the renderer and switches the other lights off, but headlights, which cast
/// no shadows and let see what lies in them. Hides what is translucent, whose shadows are no matter of a
/// bias. All is given back at its end. Masks are the pass's linear radiance with shadows, between that without the
/// light and that without shadows: materials, textures and highlights cancel out.
class ShadowBench
{
public:
  /// The window has an OpenGL context, and the renderer is in it. Of the settings, the values of
  /// parameters count: what is switched on is the bench's business, and lights have no size. Throws a
  /// Failure where the renderer has no light that can cast shadows in view.
  ShadowBench(
    vtkRenderWindow* window, vtkRenderer* renderer, const TechniqueSettings& settings = {});
  ~ShadowBench();
  ShadowBench(const ShadowBench&) = delete;
  ShadowBench& operator=(const ShadowBench&) = delete;

  vtkRenderWindow* Window() const { return this->Target; }
  vtkGIPass* Pass() const { return this->Illumination; }
  vtkGITechnique* Maps() const;
  vtkLight* Lamp() const { return this->Studied; }
  /// Other lights of the scene that would cast shadows.
  int OtherLamps() const { return this->Others; }
  /// Things that light shines through, left out.
  std::size_t LeftOut() const { return this->Hidden.size(); }

  /// Draws the view without the light, without shadows and with rays; throws a Failure where nothing in
  /// view is lit. Lengths are in texels of the map as its parameters are now.
  LitView TraceTruth();

  /// Draws the view with shadow maps; after TraceTruth(), from the same camera.
  std::vector<float> DrawMask();
  /// Draws the view with rays again, for the window to show.
  void ShowTruth();

  /// World width of a texel of the last mask, at unit distance where the light is positional; and of
  /// one in the middle of what the light reaches.
  double Texel() const;
  double TexelInTheMiddle() const { return this->MiddleTexel; }

private:
  enum class Shadows
  {
    None,
    Maps,
    Rays
  };

  void ChooseLamp();
  void HideTranslucent();
  void Configure(TechniqueSettings settings);
  std::vector<float> Shoot(Shadows shadows);
  std::vector<LitView::Vector> ReadPlaces() const;
  void PlaceAcross(LitView& view);
  std::vector<float> Share(const std::vector<float>& shot) const;

  vtkSmartPointer<vtkRenderWindow> Target;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderPass> Before;
  vtkSmartPointer<vtkGIPass> Illumination;
  vtkSmartPointer<vtkLight> Studied;
  std::vector<std::pair<vtkSmartPointer<vtkLight>, int>> Switches;
  std::vector<vtkSmartPointer<vtkProp>> Hidden;
  int Others = 0;
  double MiddleTexel = 0;
  std::vector<float> Unlit; ///< radiance, red, green, blue
  std::vector<float> Open;
};
}

#endif
