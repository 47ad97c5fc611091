// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rooms with translucent surfaces and volumes, which VTK draws itself, measured by display values.
 */
#pragma once

#include "RoomStage.h"

#include "vtkGIDDGI.h"
#include "vtkGIProbeBaker.h"
#include "vtkGISHProbes.h"

namespace penumbra_test
{
class ForwardStage : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("ddgi", 64, 48);
    this->Probes = vtkGIDDGI::SafeDownCast(this->Pass->GetTechnique("ddgi"));
    this->Baked = vtkGISHProbes::SafeDownCast(this->Pass->GetTechnique("sh-probes"));
    ASSERT_NE(this->Probes, nullptr);
    ASSERT_NE(this->Baked, nullptr);
    this->Probes->SetProbes(64);
  }

  /// Light the room with live probes, baked probes, both or neither. Baked probes are baked here, without the prop that
  /// the test changes.
  void LightBy(bool live, bool baked, vtkProp* changing = nullptr)
  {
    this->Probes->SetEnabled(live);
    this->Baked->SetEnabled(baked);
    if (baked)
    {
      const vtkSmartPointer<vtkProp> keep = changing;
      this->Scene.Renderer->RemoveViewProp(changing);
      vtkNew<vtkGIProbeBaker> baker;
      baker->SetProbes(216);
      baker->SetSamples(1024);
      vtkNew<vtkImageData> field;
      ASSERT_TRUE(baker->Bake(this->Scene.Renderer, field)) << baker->GetLastError();
      ASSERT_TRUE(this->Baked->SetBake(field)) << this->Baked->GetBakeError();
      if (changing)
      {
        this->Scene.Renderer->AddViewProp(changing);
      }
    }
  }

  /// Add a closed room in which every surface has the same radiance.
  vtkActor* AddFurnace()
  {
    vtkActor* room = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5);
    room->GetProperty()->SetAmbient(0.5 * Furnace);
    this->LookFrom(0.0, -0.9, 0.0, 0.0, 0.0, 0.0);
    return room;
  }

  /// Add an upright square that faces a camera on the negative y axis.
  vtkActor* AddQuad(double side, double albedo, double opacity, double x = 0.0, double y = 0.0)
  {
    const double half = 0.5 * side;
    vtkActor* quad = Paint(penumbra_test::AddQuad(this->Scene, { -half, 0.0, -half },
                             { half, 0.0, -half }, { -half, 0.0, half }),
      albedo);
    quad->SetPosition(x, y, 0.0);
    quad->GetProperty()->SetOpacity(opacity);
    return quad;
  }

  static void SetPBR(vtkActor* actor)
  {
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetMetallic(0.0);
    actor->GetProperty()->SetRoughness(1.0);
    actor->GetProperty()->SetBaseIOR(1.0); // no highlight
  }

  /// Mean display value, 0 to 1, of a square in the middle of the window after a number of frames. The square is a
  /// fifth of the window's height wide.
  double DisplayValue(int frames)
  {
    for (int i = 1; i < frames; ++i)
    {
      this->Scene.Window->Render();
    }
    const Picture picture = Shoot(this->Scene.Window);
    const int half = picture.Height / 10;
    return picture.MeanGrey(picture.Width / 2 - half, picture.Height / 2 - half,
             picture.Width / 2 + half, picture.Height / 2 + half) /
      255.0;
  }

  static constexpr double Furnace = 0.5;
  // Frames until DDGI has converged, and until a small change has reached it.
  static constexpr int FramesToConverge = 80;
  static constexpr int FramesToAdjust = 4;
  vtkGIDDGI* Probes = nullptr;
  vtkGISHProbes* Baked = nullptr;
};
}
