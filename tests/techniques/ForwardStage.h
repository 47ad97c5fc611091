// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rooms with things in them that VTK draws itself, measured by what is displayed.
 */
#pragma once

#include "RoomStage.h"

#include "vtkGIDDGI.h"
#include "vtkGIProbeBaker.h"
#include "vtkGISHProbes.h"

#include <vtkPlaneSource.h>

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

  /// Light from these alone; baked anew where baked ones are among them, without what may change.
  void LightBy(bool live, bool baked, vtkProp* mover = nullptr)
  {
    this->Probes->SetEnabled(live);
    this->Baked->SetEnabled(baked);
    if (baked)
    {
      const vtkSmartPointer<vtkProp> keep = mover;
      this->Scene.Renderer->RemoveViewProp(mover);
      vtkNew<vtkGIProbeBaker> baker;
      baker->SetProbes(216);
      baker->SetSamples(1024);
      vtkNew<vtkImageData> field;
      ASSERT_TRUE(baker->Bake(this->Scene.Renderer, field)) << baker->GetLastError();
      ASSERT_TRUE(this->Baked->SetBake(field)) << this->Baked->GetBakeError();
      if (mover)
      {
        this->Scene.Renderer->AddViewProp(mover);
      }
    }
  }

  /// A closed room in which everything sends out the same radiance.
  vtkActor* AddFurnace()
  {
    vtkActor* room = this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.5);
    room->GetProperty()->SetAmbient(0.5 * Furnace);
    this->LookFrom(0.0, -0.9, 0.0, 0.0, 0.0, 0.0);
    return room;
  }

  /// Upright, facing the eye of LookFrom(0, -y, 0, ...).
  vtkActor* AddQuad(double side, double albedo, double opacity, double x = 0.0, double y = 0.0)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-0.5 * side, 0.0, -0.5 * side);
    plane->SetPoint1(0.5 * side, 0.0, -0.5 * side);
    plane->SetPoint2(-0.5 * side, 0.0, 0.5 * side);
    vtkActor* quad = Paint(this->Scene.Add(plane), albedo);
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

  /// The mean display value, 0 to 1, of the middle of the window, a fifth of its height wide.
  double Middle(int frames)
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
  // Frames after which DDGI's light has arrived, and after a change of a little thing.
  static constexpr int Settled = 80;
  static constexpr int Few = 4;
  vtkGIDDGI* Probes = nullptr;
  vtkGISHProbes* Baked = nullptr;
};
}
