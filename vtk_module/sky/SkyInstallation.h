// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A sky in a renderer: what it has set there, and what was there before.
 *
 * The installation observes the renderer, which thereby owns it. It keeps the sky alive, and knows the renderer only
 * weakly, so that there is no cycle of references.
 */
#pragma once

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkGISkySource;
class vtkLight;
class vtkOpenGLRenderer;
class vtkSkybox;
class vtkTexture;

namespace penumbra
{
class SkyInstallation : public vtkCommand
{
public:
  /// Install a sky. The renderer owns the result.
  static SkyInstallation* Install(vtkGISkySource* sky, vtkOpenGLRenderer* renderer);

  vtkOpenGLRenderer* GetRenderer() const;
  /// Make the sky the environment again if another one was set since, which Remove() then restores.
  void TakeEnvironment();
  /// Bring the renderer up to date: the image only if it changed, the axes if the camera did.
  void Update();
  /// Restore the renderer. The object may be deleted on return.
  void Remove();

  void Execute(vtkObject* caller, unsigned long event, void* data) override;

protected:
  SkyInstallation() = default;
  ~SkyInstallation() override;

private:
  bool IsCurrent() const; ///< whether the renderer still shows this sky's texture
  void Show(bool skybox);

  vtkSmartPointer<vtkGISkySource> Sky;
  vtkWeakPointer<vtkOpenGLRenderer> Renderer;
  unsigned long Observer = 0;
  vtkNew<vtkTexture> Texture;
  vtkSmartPointer<vtkSkybox> Skybox;
  vtkSmartPointer<vtkLight> Sun; ///< in the renderer's list of lights

  struct
  {
    vtkSmartPointer<vtkTexture> Texture;
    bool Srgb = false;
    double Up[3];
    double Right[3];
    bool ImageBasedLighting = false;
    bool Harmonics = false;
    unsigned int FilterSamples = 0;
    unsigned int TableSize = 0;
    unsigned int TableSamples = 0;
  } Before;
};
}
