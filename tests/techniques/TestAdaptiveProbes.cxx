// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked probes in several grids: energy, leaks, less error than one grid where detail is concentrated, and what is no
 * such bake.
 */
#include "BakedStage.h"

#include "vtkGILightGatherer.h"

#include "bake/GatherStage.h"
#include "techniques/sh_probes/AdaptivePlacement.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
class AdaptiveProbes : public BakedStage
{
protected:
  static constexpr std::array<double, 6> SmallRoom = { 9.0, 10.65, 6.0, 7.65, 0.0, 1.25 };

  /// A hall of 30 x 24 x 8 with a small room of 1.6 x 1.6 x 1.2 in it, open on one side, and things in that.
  void AddHall()
  {
    this->AddBox(0.0, 30.0, 0.0, 24.0, 0.0, 8.0, 0.7);
    this->AddBox(9.0, 9.05, 6.0, 7.6, 0.0, 1.2, 0.7);
    this->AddBox(10.6, 10.65, 6.0, 7.6, 0.0, 1.2, 0.7)->GetProperty()->SetColor(1.0, 0.3, 0.2);
    this->AddBox(9.0, 10.65, 7.6, 7.65, 0.0, 1.2, 0.7);
    this->AddBox(9.0, 10.65, 6.0, 7.65, 1.2, 1.25, 0.7);
    this->AddBox(9.3, 9.6, 7.0, 7.3, 0.0, 0.6, 0.6);
    this->AddBox(10.1, 10.4, 6.8, 7.2, 0.0, 0.3, 0.6)->GetProperty()->SetColor(0.3, 0.5, 1.0);
    this->Lamp->SetPosition(9.9, 6.9, 0.95);
    this->Lamp->SetIntensity(0.5);
    this->HallLamp->SetLightTypeToSceneLight();
    this->HallLamp->PositionalOn();
    this->HallLamp->SetConeAngle(180.0);
    this->HallLamp->SetPosition(20.0, 10.0, 7.0);
    this->Scene.Renderer->AddLight(this->HallLamp);
    this->LookFrom(9.7, 5.3, 0.9, 9.9, 7.2, 0.4);
    this->Scene.Renderer->GetActiveCamera()->SetClippingRange(0.02, 60.0);
  }

  /// In a grid around all, and a finer one around a box, without choosing.
  void BakeAround(const std::array<double, 6>& box, int probes, int finer, int samples)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    vtkNew<vtkImageData> alone; // knows the scene
    this->Baker->SetProbes(27);
    ASSERT_TRUE(this->Baker->Place(renderer, alone)) << this->Baker->GetLastError();
    std::array<double, 6> bounds{};
    renderer->ComputeVisiblePropBounds(bounds.data());
    const penumbra::ProbeGrid around = penumbra::ProbeGrid::Around(bounds, probes);
    const penumbra::ProbeGrid part =
      around.Part({ box[0], box[2], box[4] }, { box[1], box[3], box[5] }, finer);
    penumbra::GatherStage stage;
    stage.Prepare(renderer);
    const auto gather = [&](const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>&,
                          int, int count, std::vector<float>*) {
      vtkNew<vtkDoubleArray> places;
      places->SetNumberOfComponents(3);
      for (const glm::dvec3& point : points)
      {
        places->InsertNextTuple3(point.x, point.y, point.z);
      }
      vtkNew<vtkGILightGatherer> gatherer;
      vtkNew<vtkFloatArray> light;
      gatherer->SetSamples(count);
      EXPECT_TRUE(gatherer->Gather(renderer, places, nullptr, light));
      return std::vector<float>(
        light->GetPointer(0), light->GetPointer(0) + light->GetNumberOfValues());
    };
    const penumbra::AdaptivePlacement placement{ stage, gather, [](double) { return true; }, true };
    auto field =
      placement.Place(penumbra::ProbeGrids(std::vector<penumbra::ProbeGrid>{ around, part }));
    field->Scene = penumbra::ProbeField::FromImage(alone).Scene;
    field->ToImage(this->Field, false);
    ASSERT_TRUE(this->Baker->AddSamples(renderer, this->Field, samples))
      << this->Baker->GetLastError();
    ASSERT_TRUE(this->Probes->SetBake(this->Field)) << this->Probes->GetBakeError();
    ASSERT_EQ(this->Baker->CountGrids(this->Field), 2);
  }

  vtkNew<vtkLight> HallLamp;

  struct Grid
  {
    int Counts[3] = { 0, 0, 0 };
    std::array<double, 6> Bounds{};
    double Cell() const { return (this->Bounds[1] - this->Bounds[0]) / (this->Counts[0] - 1); }
  };
  std::vector<Grid> Grids()
  {
    std::vector<Grid> grids(this->Baker->CountGrids(this->Field));
    for (std::size_t i = 0; i < grids.size(); ++i)
    {
      EXPECT_TRUE(this->Baker->GetGrid(
        this->Field, static_cast<int>(i), grids[i].Counts, grids[i].Bounds.data()));
    }
    return grids;
  }

  /// Indirect light as the probes give it.
  Values Indirect()
  {
    Values with = this->After(1);
    EXPECT_STREQ(this->Pass->GetNotes(), "");
    this->Probes->EnabledOff();
    const Values without = this->After(1);
    this->Probes->EnabledOn();
    for (std::size_t i = 0; i < with.size(); ++i)
    {
      with[i] -= without[i];
    }
    return with;
  }

  /// Mean squared error, over the truth's square and a hundredth of its mean's.
  static double RelativeError(const Values& values, const Values& truth)
  {
    const double least = 0.01 * Mean(truth) * Mean(truth);
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sum += (values[i] - truth[i]) * (values[i] - truth[i]) / (truth[i] * truth[i] + least);
    }
    return sum / static_cast<double>(values.size());
  }
};
}

// Balls close together over a large plane.
TEST_F(AdaptiveProbes, ErrLessWhereDetailIsConcentrated)
{
  this->AddBox(-30.0, 30.0, -30.0, 30.0, -0.1, 0.0, 0.7);
  for (int i = 0; i < 18; ++i)
  {
    const double turn = 0.6 * i;
    this->AddBall(6.0 + 1.2 * std::cos(turn), -4.0 + 1.2 * std::sin(turn), 0.6 + 0.15 * i, 0.5);
  }
  this->Lamp->SetPosition(2.0, -10.0, 9.0);
  this->Lamp->SetIntensity(1.0);
  this->LookFrom(4.5, -9.5, 2.5, 6.0, -4.0, 1.6);
  this->Pass->GetTechnique("ray-traced-shadows")->EnabledOn();
  Values truth = this->Traced(8, 128);
  const Values direct = this->Traced(0, 32);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    truth[i] -= direct[i];
  }
  double errors[2];
  for (const bool adaptive : { false, true })
  {
    this->Bake(900, 128, adaptive);
    EXPECT_LE(this->Field->GetNumberOfPoints(), 900);
    errors[adaptive] = RelativeError(this->Indirect(), truth);
    std::printf("%d grids, %lld probes: relMSE %.4f\n", this->Baker->CountGrids(this->Field),
      static_cast<long long>(this->Field->GetNumberOfPoints()), errors[adaptive]);
  }
  EXPECT_GT(this->Grids().size(), 1u);
  EXPECT_EQ(this->Baker->CountGrids(this->Field), this->Baker->GetNumberOfTriedGrids());
  EXPECT_LT(this->Baker->GetErrorOfTriedGrids(), 0.9);
  EXPECT_LT(errors[1], 0.75 * errors[0]);
}

// Where light is the same everywhere it is so across the borders of grids, whatever is near.
TEST_F(AdaptiveProbes, ConstantLightIsExact)
{
  this->AddHall();
  this->Lamp->SetIntensity(0.0);
  this->HallLamp->SetIntensity(0.0);
  this->BakeAround(SmallRoom, 120, 300, 1);
  constexpr double radiance = 0.4;
  vtkNew<vtkFloatArray> even;
  even->SetName("light");
  even->SetNumberOfComponents(27);
  even->SetNumberOfTuples(this->Field->GetNumberOfPoints());
  even->FillValue(0.0f);
  for (vtkIdType i = 0; i < even->GetNumberOfTuples(); ++i)
  {
    for (int color = 0; color < 3; ++color)
    {
      even->SetTypedComponent(i, color, static_cast<float>(radiance * std::sqrt(4.0 * 3.14159265)));
    }
  }
  this->Field->GetPointData()->AddArray(even);
  this->Field->GetFieldData()->RemoveArray("checksum"); // altered on purpose
  ASSERT_TRUE(this->Probes->SetBake(this->Field)) << this->Probes->GetBakeError();
  // What is seen has one of four reflectances.
  double most = 0.0;
  for (const double far : { 0.0, 3.0 })
  {
    this->LookFrom(9.7 - far, 5.3 - far, 0.9 + 0.5 * far, 9.3, 8.9, 1.5 + 0.3 * far);
    this->Scene.Renderer->GetActiveCamera()->SetClippingRange(0.02, 60.0);
    for (const double value : this->Indirect())
    {
      const double nearest = std::min({ std::abs(value - 0.7 * radiance),
        std::abs(value - 0.6 * radiance), std::abs(value - 0.7 * radiance * 1.5 / 3.0),
        std::abs(value - 0.6 * radiance * 1.8 / 3.0) });
      most = std::max(most, nearest / radiance);
    }
  }
  std::printf("largest error %.3f %%\n", 100.0 * most);
  // Reflectances are kept in 255 steps, light in halves.
  EXPECT_LT(most, 0.5 / 255.0 + 0.0005);
}

// Everything gives off E and reflects r: E / (1 - r) arrives.
TEST_F(AdaptiveProbes, ClosedEnclosureKeepsItsEnergy)
{
  constexpr double emission = 0.1;
  constexpr double albedo = 0.7;
  this->AddBox(-3.0, 1.0, -2.0, 1.0, -1.0, 1.0, albedo)->GetProperty()->SetAmbient(emission);
  this->AddBox(0.0, 0.4, -0.6, -0.2, -1.0, -0.3, albedo)->GetProperty()->SetAmbient(emission);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->BakeAround({ -0.3, 0.7, -0.9, 0.1, -1.0, 0.0 }, 125, 125, 8192);
  EXPECT_TRUE(this->Baker->Fits(this->Scene.Renderer, this->Field)) << this->Baker->GetLastError();
  this->ExpectEverywhere(emission / (1.0 - albedo), 0.0033, 0.05);
}

// A finer grid stands across the wall between a lit room and a dark one, and ends in both.
TEST_F(AdaptiveProbes, ARoomNextDoorStaysDark)
{
  constexpr double thickness = 0.02;
  this->AddBox(-2.0, -0.5 * thickness, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->AddBox(0.5 * thickness, 2.0, -1.0, 1.0, -1.0, 1.0, 0.7);
  this->Lamp->SetIntensity(1.0);
  this->Lamp->SetPosition(-1.2, 0.3, 0.4);
  this->BakeAround({ -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 }, 256, 256, 256);
  const Grid finer = this->Grids()[1];
  std::printf("cells of %.2f from %.2f to %.2f\n", finer.Cell(), finer.Bounds[0], finer.Bounds[1]);
  EXPECT_LT(finer.Bounds[0], -0.5);
  EXPECT_GT(finer.Bounds[1], 0.5);
  this->LookFrom(-1.8, -0.8, 0.8, -0.5, 0.5, -0.5);
  const double bright = Mean(this->Indirect());
  this->Pass->GetTechnique("ray-traced-shadows")->EnabledOn();
  double most = 0.0;
  for (const double x : { 1.8, 0.2 })
  {
    this->LookFrom(x, -0.8, 0.8, 0.5 + 0.1 * x, 0.5, -0.5);
    for (const double value : this->Indirect())
    {
      most = std::max(most, value);
    }
  }
  std::printf(
    "dark room: at most %.3f %% of the lit one's indirect light\n", 100.0 * most / bright);
  EXPECT_GT(bright, 0.02);
  EXPECT_LT(most, 0.01 * bright);
}

TEST_F(AdaptiveProbes, RefuseGridsThatAreNone)
{
  this->AddHall();
  this->BakeAround(SmallRoom, 64, 80, 1);
  const auto refused = [this](const char* reason, auto change) {
    vtkNew<vtkImageData> other;
    other->DeepCopy(this->Field);
    change(vtkDoubleArray::SafeDownCast(other->GetFieldData()->GetArray("grids")), other.Get());
    EXPECT_FALSE(this->Probes->SetBake(other));
    EXPECT_NE(std::string(this->Probes->GetBakeError()).find(reason), std::string::npos)
      << this->Probes->GetBakeError();
    EXPECT_EQ(this->Baker->CountGrids(other), 0);
  };
  refused("array 'grids'", [](auto*, auto* image) { image->GetFieldData()->RemoveArray("grids"); });
  refused("spacing", [](auto* grids, auto*) { grids->SetComponent(1, 4, 0.0); });
  refused("spacing", [](auto* grids, auto*) { grids->SetComponent(1, 1, std::nan("")); });
  refused("2 probes", [](auto* grids, auto*) { grids->SetComponent(1, 6, 1.0); });
  refused("2 probes", [](auto* grids, auto*) { grids->SetComponent(0, 6, 1e12); });
  refused("numbers of probes",
    [](auto* grids, auto*) { grids->SetComponent(0, 6, grids->GetComponent(0, 6) + 1.0); });
  refused("array 'grids'", [](auto* grids, auto*) {
    const std::vector<double> first(grids->GetPointer(0), grids->GetPointer(0) + 9);
    while (grids->GetNumberOfTuples() < 7)
    {
      grids->InsertNextTuple(first.data());
    }
  });
  refused("more than 828100 probes", [](auto* grids, auto*) {
    for (int i = 0; i < 2; ++i)
    {
      grids->SetComponent(i, 6, 900.0);
      grids->SetComponent(i, 7, 300.0);
      grids->SetComponent(i, 8, 2.0);
    }
  });
  refused("checksum", [](auto* grids, auto*) { grids->SetComponent(1, 4, 0.123); });
  int counts[3];
  double bounds[6];
  EXPECT_FALSE(this->Baker->GetGrid(this->Field, 9, counts, bounds));
  EXPECT_NE(std::string(this->Baker->GetLastError()), "");
}
