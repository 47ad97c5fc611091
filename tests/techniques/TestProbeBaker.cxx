// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baking of probes: large numbers of them, altered fields, progress, and errors.
 */
#include "BakedStage.h"

#include "bake/GatherStage.h"
#include "techniques/sh_probes/AdaptivePlacement.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
class ProbeBaker : public BakedStage
{
protected:
  void AddRoom() { this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, Albedo); }

  static constexpr double Albedo = 0.7;
};
}

// Light that rises linearly along two axes tells neighbouring probes apart.
TEST_F(ProbeBaker, SixtyThousandProbesLightTheRoom)
{
  this->AddRoom();
  vtkNew<vtkImageData> described; // has the description of the scene
  this->Baker->SetProbes(27);
  ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, described)) << this->Baker->GetLastError();
  penumbra::ProbeField field(
    penumbra::ProbeGrid::Around({ -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, 60000));
  ASSERT_GT(field.Grids.Size(), 58240);
  const auto lightAt = [](double x, double y) { return 0.4 + 0.2 * x + 0.1 * y; };
  const std::vector<glm::dvec3> positions = field.Positions(0, field.Grids.Size());
  constexpr int numbers = penumbra::ProbeField::Distances;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    // Probes below the floor are dark and see nothing.
    const bool below = positions[i].z < -1.0;
    std::fill_n(&field.Distance[i * numbers], numbers, below ? 0.0f : 1.0f);
    const double light = below ? 0.0 : lightAt(positions[i].x, positions[i].y);
    const double uniform = light * std::sqrt(4.0 * 3.14159265);
    std::fill_n(&field.Light[i * penumbra::ProbeField::Harmonics], 3, static_cast<float>(uniform));
  }
  std::fill(field.Sight.begin(), field.Sight.end(), (1 << 13) - 1);
  field.Samples = 1;
  field.Scene = penumbra::ProbeField::FromImage(described).Scene;
  field.ToImage(this->Field, false);
  ASSERT_TRUE(this->Probes->SetBake(this->Field)) << this->Probes->GetBakeError();
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.7);
  camera->SetPosition(0.0, 0.0, 0.5);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(0.01, 5.0);
  const Values values = this->After(1);
  EXPECT_STREQ(this->Pass->GetNotes(), "");
  constexpr int width = 48;
  constexpr int height = 36;
  double largest = 0.0;
  for (int i = 0; i < width * height; ++i)
  {
    const double x = 0.7 * (2.0 * (i % width + 0.5) - width) / height;
    const double y = 0.7 * (2.0 * (i / width + 0.5) / height - 1.0);
    largest = std::max(largest, std::abs(values[i] / (Albedo * lightAt(x, y)) - 1.0));
  }
  std::printf("%d probes, largest error %.2f %%\n", field.Grids.Size(), 100.0 * largest);
  // A neighbour in place of the right probe gives an error of at least 2 %.
  EXPECT_LT(largest, 0.012);
}

// The slab is so thin that probes inside reach its surface. (A solid of reversed winding is not recognised: its probes
// stay inside, where they are dark and never visible. See SHProbes.WindingMakesNoDifference.)
TEST_F(ProbeBaker, ProbesLeaveSolids)
{
  this->AddRoom();
  this->Lamp->SetPosition(0.3, 0.2, 0.8);
  this->Lamp->SetIntensity(0.7);
  constexpr double low = -0.185, high = -0.05, side = 0.6;
  this->Baker->SetProbes(512); // a third apart
  const auto countInside = [&] {
    EXPECT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field))
      << this->Baker->GetLastError();
    const penumbra::ProbeField field = penumbra::ProbeField::FromImage(this->Field);
    int inside = 0;
    for (const glm::dvec3& at : field.Positions(0, field.Grids.Size()))
    {
      inside += std::abs(at.x) < side && std::abs(at.y) < side && at.z > low && at.z < high;
    }
    return inside;
  };
  this->AddBox(-side, side, -side, side, low, high, Albedo);
  this->Baker->RelocateOff();
  EXPECT_GT(countInside(), 8);
  this->Baker->RelocateOn();
  EXPECT_EQ(countInside(), 0);
}

// Every probe draws its own random directions, however many are traced at once.
TEST_F(ProbeBaker, ProbesAtOnePositionTraceDifferentRays)
{
  this->AddRoom();
  penumbra::GatherStage stage;
  stage.Prepare(this->Scene.Renderer);
  penumbra::ProbeGrid grid;
  grid.First = { 0.1, -0.4, -0.3 };
  grid.Spacing = { 1e-6, 0.9, 0.9 };
  grid.Counts = { 24, 2, 2 };
  penumbra::ProbeField field{ penumbra::ProbeGrids(grid) };
  ASSERT_TRUE(penumbra::TraceVisibility(stage, field, 0, [](double) { return true; }));
  double least = 1.0;
  constexpr int numbers = penumbra::ProbeField::Distances;
  for (int probe = 1; probe < grid.Counts.x; ++probe)
  {
    for (int other = 0; other < probe; ++other)
    {
      double difference = 0.0;
      for (int i = 0; i < numbers; i += 2)
      {
        difference +=
          std::abs(field.Distance[probe * numbers + i] - field.Distance[other * numbers + i]);
      }
      least = std::min(least, difference / (numbers / 2));
    }
  }
  std::printf("maps of distances differ by %.4f at least\n", least);
  EXPECT_GT(least, 0.001);
}

// One grid errs in a corner; several grids are right everywhere or wrong everywhere.
TEST_F(ProbeBaker, SeveralGridsAreKeptIfTheyErrLess)
{
  this->AddRoom();
  penumbra::GatherStage stage;
  stage.Prepare(this->Scene.Renderer);
  for (const double error : { 0.0, 3.0 })
  {
    int gathered = 0; // how often probes were gathered: twice in one grid, then twice in several
    const auto gather = [&](const std::vector<glm::dvec3>& points,
                          const std::vector<glm::dvec3>& normals, int, int,
                          std::vector<float>* surroundings) {
      if (surroundings)
      {
        surroundings->assign(3 * points.size(), 0.0f);
      }
      if (!normals.empty())
      {
        return std::vector<float>(3 * points.size(), 1.0f);
      }
      const bool several = gathered++ >= 2;
      std::vector<float> light(points.size() * penumbra::ProbeField::Harmonics, 0.0f);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const bool corner = glm::all(glm::greaterThan(points[i], glm::dvec3(0.4)));
        const double found = 1.0 + (several ? error : corner ? 1.0 : 0.0);
        std::fill_n(&light[i * penumbra::ProbeField::Harmonics], 3,
          static_cast<float>(found * std::sqrt(4.0 * 3.14159265)));
      }
      return light;
    };
    const penumbra::AdaptivePlacement placement{ stage, gather, [](double) { return true; },
      false };
    penumbra::TriedGrids tried;
    const auto field = placement.PlaceBest({ -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, 500, tried);
    ASSERT_TRUE(field.has_value());
    EXPECT_EQ(gathered, 4);
    std::printf("%d grids tried: %.3f of one's error\n", tried.Count, tried.Error);
    EXPECT_GT(tried.Count, 1);
    EXPECT_EQ(field->Grids.Count(), error == 0.0 ? tried.Count : 1);
    // Too few probes for several grids: nothing is gathered.
    EXPECT_TRUE(placement.PlaceBest({ -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, 90, tried).has_value());
    EXPECT_EQ(gathered, 4);
  }
}

TEST_F(ProbeBaker, AlteredFieldsAreRefused)
{
  this->AddRoom();
  this->Lamp->SetIntensity(1.0);
  this->Bake(27, 4);
  const auto expectRefused = [this](vtkImageData* image) {
    const std::string expected = "its checksum does not fit";
    EXPECT_FALSE(this->Probes->SetBake(image));
    EXPECT_EQ(std::string(this->Probes->GetBakeError()).find(expected), 0u)
      << this->Probes->GetBakeError();
    EXPECT_FALSE(this->Baker->AddSamples(this->Scene.Renderer, image, 1));
    EXPECT_EQ(std::string(this->Baker->GetLastError()).find(expected), 0u);
    // Fields without a checksum are accepted: earlier versions wrote none, and editing a field removes it.
    image->GetFieldData()->RemoveArray("checksum");
    EXPECT_TRUE(this->Probes->SetBake(image)) << this->Probes->GetBakeError();
  };
  vtkNew<vtkImageData> altered;
  for (const char* name : { "light", "distance", "offset", "sight", "backs" })
  {
    altered->DeepCopy(this->Field);
    vtkDataArray* array = altered->GetPointData()->GetArray(name);
    const vtkIdType last = array->GetNumberOfTuples() - 1;
    array->SetComponent(last, 0, array->GetComponent(last, 0) == 0.0 ? 1.0 : 0.0);
    expectRefused(altered);
  }
  for (const char* name : { "samples", "light scale" })
  {
    altered->DeepCopy(this->Field);
    vtkDataArray* array = altered->GetFieldData()->GetArray(name);
    array->SetComponent(0, 0, array->GetComponent(0, 0) + 1.0);
    expectRefused(altered);
  }
  altered->DeepCopy(this->Field);
  altered->SetSpacing(1.0, 1.0, 1.0);
  expectRefused(altered);
  altered->DeepCopy(this->Field);
  altered->SetOrigin(0.0, 0.0, 0.0);
  expectRefused(altered);
}

TEST_F(ProbeBaker, ProgressRisesToOneOnce)
{
  this->AddRoom();
  this->Lamp->SetIntensity(1.0);
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  std::vector<double> reports;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&reports);
  watch->SetCallback([](vtkObject*, unsigned long, void* list, void* progress) {
    static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(progress));
  });
  this->Baker->AddObserver(vtkCommand::ProgressEvent, watch);
  const auto expectOneRun = [&reports](const char* what) {
    ASSERT_FALSE(reports.empty()) << what;
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end())) << what;
    EXPECT_GE(reports.front(), 0.0) << what;
    EXPECT_DOUBLE_EQ(reports.back(), 1.0) << what;
    EXPECT_EQ(std::count(reports.begin(), reports.end(), 1.0), 1) << what;
    reports.clear();
  };
  this->Bake(64, 4);
  expectOneRun("one grid");
  ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field));
  expectOneRun("placement only");
  this->Baker->AdaptiveOn();
  for (const int probes : { 90, 91 }) // too few for several grids, and enough to try
  {
    this->Baker->SetProbes(probes);
    ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field));
    expectOneRun("adaptive");
  }
  this->Lamp->SwitchOff();
  ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field));
  expectOneRun("adaptive and dark");
}

TEST_F(ProbeBaker, ErrorsAreReportedBeforeBakingStarts)
{
  this->AddRoom();
  int reports = 0;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&reports);
  watch->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  this->Baker->AddObserver(vtkCommand::ProgressEvent, watch);
  vtkRenderer* renderer = this->Scene.Renderer;
  EXPECT_FALSE(this->Baker->Bake(renderer, nullptr));
  EXPECT_STREQ(this->Baker->GetLastError(), "there is no image to put the probes into.");
  EXPECT_FALSE(this->Baker->Place(renderer, nullptr));
  EXPECT_STREQ(this->Baker->GetLastError(), "there is no image to put the probes into.");
  EXPECT_FALSE(this->Baker->Bake(nullptr, this->Field));
  EXPECT_STRNE(this->Baker->GetLastError(), "");
  this->Baker->SetSpacing(0.02); // 102 x 102 x 102
  EXPECT_FALSE(this->Baker->Bake(renderer, this->Field));
  EXPECT_NE(
    std::string(this->Baker->GetLastError()).find("more than 828100 probes"), std::string::npos)
    << this->Baker->GetLastError();
  EXPECT_EQ(reports, 0);
  EXPECT_EQ(this->Field->GetNumberOfPoints(), 0);
  this->Baker->SetProbes(1 << 20);
  EXPECT_EQ(this->Baker->GetProbes(), vtkGIProbeBaker::MostProbes);
}
