// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked probes in several grids: energy, leaks, a smaller error than with one grid where detail is concentrated, and
 * invalid bakes.
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

  /// Add a hall of 30 x 24 x 8. In it stands a small room of 1.6 x 1.6 x 1.2, open on one side, with two boxes.
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
    ShineAllRound(this->HallLamp);
    this->HallLamp->SetPosition(20.0, 10.0, 7.0);
    this->Scene.Renderer->AddLight(this->HallLamp);
    this->LookFrom(9.7, 5.3, 0.9, 9.9, 7.2, 0.4);
    this->Scene.Renderer->GetActiveCamera()->SetClippingRange(0.02, 60.0);
  }

  /// Bake one grid around the scene and a finer one around a box, without a search for grids.
  void BakeTwoGrids(const std::array<double, 6>& box, int probes, int finer, int samples)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    vtkNew<vtkImageData> described; // has the description of the scene
    this->Baker->SetProbes(27);
    ASSERT_TRUE(this->Baker->Place(renderer, described)) << this->Baker->GetLastError();
    std::array<double, 6> bounds{};
    renderer->ComputeVisiblePropBounds(bounds.data());
    const penumbra::ProbeGrid outer = penumbra::ProbeGrid::Around(bounds, probes);
    const penumbra::ProbeGrid inner =
      outer.Part({ box[0], box[2], box[4] }, { box[1], box[3], box[5] }, finer);
    penumbra::GatherStage stage;
    stage.Prepare(renderer);
    const auto gather = [&](const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>&,
                          int, int count, std::vector<float>*) {
      vtkNew<vtkDoubleArray> positions;
      positions->SetNumberOfComponents(3);
      for (const glm::dvec3& point : points)
      {
        positions->InsertNextTuple3(point.x, point.y, point.z);
      }
      vtkNew<vtkGILightGatherer> gatherer;
      vtkNew<vtkFloatArray> light;
      gatherer->SetSamples(count);
      EXPECT_TRUE(gatherer->Gather(renderer, positions, nullptr, light));
      return std::vector<float>(
        light->GetPointer(0), light->GetPointer(0) + light->GetNumberOfValues());
    };
    const penumbra::AdaptivePlacement placement{ stage, gather, [](double) { return true; }, true };
    auto field =
      placement.Place(penumbra::ProbeGrids(std::vector<penumbra::ProbeGrid>{ outer, inner }));
    field->Scene = penumbra::ProbeField::FromImage(described).Scene;
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

  /// Light that the probes add to each pixel.
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

  /// Mean squared error, relative to the square of the reference plus a hundredth of its squared mean.
  static double RelativeError(const Values& values, const Values& reference)
  {
    const double floor = 0.01 * Mean(reference) * Mean(reference);
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sum += (values[i] - reference[i]) * (values[i] - reference[i]) /
        (reference[i] * reference[i] + floor);
    }
    return sum / static_cast<double>(values.size());
  }
};
}

// Balls close together over a large plane.
TEST_F(AdaptiveProbes, ErrLessThanOneGridWhereDetailIsConcentrated)
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
  Values reference = this->Traced(8, 128);
  const Values direct = this->Traced(0, 32);
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    reference[i] -= direct[i];
  }
  double errors[2];
  for (const bool adaptive : { false, true })
  {
    this->Bake(900, 128, adaptive);
    EXPECT_LE(this->Field->GetNumberOfPoints(), 900);
    errors[adaptive] = RelativeError(this->Indirect(), reference);
    std::printf("%d grids, %lld probes: relMSE %.4f\n", this->Baker->CountGrids(this->Field),
      static_cast<long long>(this->Field->GetNumberOfPoints()), errors[adaptive]);
  }
  EXPECT_GT(this->Grids().size(), 1u);
  EXPECT_EQ(this->Baker->CountGrids(this->Field), this->Baker->GetNumberOfTriedGrids());
  EXPECT_LT(this->Baker->GetErrorOfTriedGrids(), 0.9);
  EXPECT_LT(errors[1], 0.75 * errors[0]);
}

// Uniform light stays uniform across the borders of grids, whatever is nearby.
TEST_F(AdaptiveProbes, ReproduceUniformLight)
{
  this->AddHall();
  this->Lamp->SetIntensity(0.0);
  this->HallLamp->SetIntensity(0.0);
  this->BakeTwoGrids(SmallRoom, 120, 300, 1);
  constexpr double radiance = 0.4;
  vtkNew<vtkFloatArray> uniform;
  uniform->SetName("light");
  uniform->SetNumberOfComponents(27);
  uniform->SetNumberOfTuples(this->Field->GetNumberOfPoints());
  uniform->FillValue(0.0f);
  for (vtkIdType i = 0; i < uniform->GetNumberOfTuples(); ++i)
  {
    for (int color = 0; color < 3; ++color)
    {
      uniform->SetTypedComponent(
        i, color, static_cast<float>(radiance * std::sqrt(4.0 * 3.14159265)));
    }
  }
  this->Field->GetPointData()->AddArray(uniform);
  this->Field->GetFieldData()->RemoveArray("checksum"); // altered on purpose
  ASSERT_TRUE(this->Probes->SetBake(this->Field)) << this->Probes->GetBakeError();
  // Visible surfaces have one of four reflectances.
  double largest = 0.0;
  for (const double far : { 0.0, 3.0 })
  {
    this->LookFrom(9.7 - far, 5.3 - far, 0.9 + 0.5 * far, 9.3, 8.9, 1.5 + 0.3 * far);
    this->Scene.Renderer->GetActiveCamera()->SetClippingRange(0.02, 60.0);
    for (const double value : this->Indirect())
    {
      const double nearest = std::min({ std::abs(value - 0.7 * radiance),
        std::abs(value - 0.6 * radiance), std::abs(value - 0.7 * radiance * 1.5 / 3.0),
        std::abs(value - 0.6 * radiance * 1.8 / 3.0) });
      largest = std::max(largest, nearest / radiance);
    }
  }
  std::printf("largest error %.3f %%\n", 100.0 * largest);
  // Reflectances are stored in 8 bits, light in half floats.
  EXPECT_LT(largest, 0.5 / 255.0 + 0.0005);
}

// All surfaces emit E and reflect r, so that the radiosity is E / (1 - r) everywhere.
TEST_F(AdaptiveProbes, ClosedEnclosureKeepsItsEnergy)
{
  constexpr double emission = 0.1;
  constexpr double albedo = 0.7;
  this->AddBox(-3.0, 1.0, -2.0, 1.0, -1.0, 1.0, albedo)->GetProperty()->SetAmbient(emission);
  this->AddBox(0.0, 0.4, -0.6, -0.2, -1.0, -0.3, albedo)->GetProperty()->SetAmbient(emission);
  this->LookFrom(0.7, 0.6, 0.8, -0.5, -0.6, -0.3);
  this->BakeTwoGrids({ -0.3, 0.7, -0.9, 0.1, -1.0, 0.0 }, 125, 125, 8192);
  EXPECT_TRUE(this->Baker->Fits(this->Scene.Renderer, this->Field)) << this->Baker->GetLastError();
  this->ExpectRadiosity(emission / (1.0 - albedo), 0.0033, 0.05);
}

// The finer grid reaches across the wall between a lit room and a dark one and ends in both.
TEST_F(AdaptiveProbes, ARoomNextDoorStaysDark)
{
  constexpr double thickness = 0.02;
  this->AddTwoRooms(thickness);
  this->Lamp->SetIntensity(1.0);
  this->BakeTwoGrids({ -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 }, 256, 256, 256);
  const Grid finer = this->Grids()[1];
  std::printf("cells of %.2f from %.2f to %.2f\n", finer.Cell(), finer.Bounds[0], finer.Bounds[1]);
  EXPECT_LT(finer.Bounds[0], -0.5);
  EXPECT_GT(finer.Bounds[1], 0.5);
  this->LookFrom(-1.8, -0.8, 0.8, -0.5, 0.5, -0.5);
  const double bright = Mean(this->Indirect());
  this->Pass->GetTechnique("ray-traced-shadows")->EnabledOn();
  double largest = 0.0;
  for (const double x : { 1.8, 0.2 })
  {
    this->LookFrom(x, -0.8, 0.8, 0.5 + 0.1 * x, 0.5, -0.5);
    for (const double value : this->Indirect())
    {
      largest = std::max(largest, value);
    }
  }
  std::printf(
    "dark room: at most %.3f %% of the lit one's indirect light\n", 100.0 * largest / bright);
  EXPECT_GT(bright, 0.02);
  EXPECT_LT(largest, 0.01 * bright);
}

TEST_F(AdaptiveProbes, RefuseInvalidGrids)
{
  this->AddHall();
  this->BakeTwoGrids(SmallRoom, 64, 80, 1);
  const auto expectRefused = [this](const char* reason, auto change) {
    vtkNew<vtkImageData> other;
    other->DeepCopy(this->Field);
    change(vtkDoubleArray::SafeDownCast(other->GetFieldData()->GetArray("grids")), other.Get());
    EXPECT_FALSE(this->Probes->SetBake(other));
    EXPECT_NE(std::string(this->Probes->GetBakeError()).find(reason), std::string::npos)
      << this->Probes->GetBakeError();
    EXPECT_EQ(this->Baker->CountGrids(other), 0);
  };
  expectRefused(
    "array 'grids'", [](auto*, auto* image) { image->GetFieldData()->RemoveArray("grids"); });
  expectRefused("spacing", [](auto* grids, auto*) { grids->SetComponent(1, 4, 0.0); });
  expectRefused("spacing", [](auto* grids, auto*) { grids->SetComponent(1, 1, std::nan("")); });
  expectRefused("2 probes", [](auto* grids, auto*) { grids->SetComponent(1, 6, 1.0); });
  expectRefused("2 probes", [](auto* grids, auto*) { grids->SetComponent(0, 6, 1e12); });
  expectRefused("numbers of probes",
    [](auto* grids, auto*) { grids->SetComponent(0, 6, grids->GetComponent(0, 6) + 1.0); });
  expectRefused("array 'grids'", [](auto* grids, auto*) {
    const std::vector<double> first(grids->GetPointer(0), grids->GetPointer(0) + 9);
    while (grids->GetNumberOfTuples() < 7)
    {
      grids->InsertNextTuple(first.data());
    }
  });
  expectRefused("more than 828100 probes", [](auto* grids, auto*) {
    for (int i = 0; i < 2; ++i)
    {
      grids->SetComponent(i, 6, 900.0);
      grids->SetComponent(i, 7, 300.0);
      grids->SetComponent(i, 8, 2.0);
    }
  });
  expectRefused("checksum", [](auto* grids, auto*) { grids->SetComponent(1, 4, 0.123); });
  int counts[3];
  double bounds[6];
  EXPECT_FALSE(this->Baker->GetGrid(this->Field, 9, counts, bounds));
  EXPECT_NE(std::string(this->Baker->GetLastError()), "");
}
