// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baking of probes: very many of them, what was altered since, progress, and what cannot be baked.
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
class ProbesBaker : public BakedStage
{
protected:
  void AddRoom() { this->AddBox(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, Albedo); }

  static constexpr double Albedo = 0.7;
};
}

// Light that grows evenly along two axes tells each probe's place from every other's.
TEST_F(ProbesBaker, SixtyThousandProbesAreShown)
{
  this->AddRoom();
  vtkNew<vtkImageData> few; // knows the scene
  this->Baker->SetProbes(27);
  ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, few)) << this->Baker->GetLastError();
  penumbra::ProbeField field(
    penumbra::ProbeGrid::Around({ -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, 60000));
  ASSERT_GT(field.Grids.Size(), 58240);
  const auto lightAt = [](double x, double y) { return 0.4 + 0.2 * x + 0.1 * y; };
  const std::vector<glm::dvec3> places = field.Positions(0, field.Grids.Size());
  constexpr int numbers = penumbra::ProbeField::Distances;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    // Those below the floor are dark, and see nothing.
    const bool below = places[i].z < -1.0;
    std::fill_n(&field.Distance[i * numbers], numbers, below ? 0.0f : 1.0f);
    const double light = below ? 0.0 : lightAt(places[i].x, places[i].y);
    const double even = light * std::sqrt(4.0 * 3.14159265);
    std::fill_n(&field.Light[i * penumbra::ProbeField::Harmonics], 3, static_cast<float>(even));
  }
  std::fill(field.Sight.begin(), field.Sight.end(), (1 << 13) - 1);
  field.Samples = 1;
  field.Scene = penumbra::ProbeField::FromImage(few).Scene;
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
  double most = 0.0;
  for (int i = 0; i < width * height; ++i)
  {
    const double x = 0.7 * (2.0 * (i % width + 0.5) - width) / height;
    const double y = 0.7 * (2.0 * (i / width + 0.5) / height - 1.0);
    most = std::max(most, std::abs(values[i] / (Albedo * lightAt(x, y)) - 1.0));
  }
  std::printf("%d probes, largest error %.2f %%\n", field.Grids.Size(), 100.0 * most);
  // One probe beside the right one makes 2 % and more.
  EXPECT_LT(most, 0.012);
}

// Where a surface is near enough to go through. (Of what is wound the other way nobody knows that it is solid: its probes
// stay in the dark, and are seen from nowhere. See SHProbes.WindingMakesNoDifference.)
TEST_F(ProbesBaker, ProbesLeaveSolids)
{
  this->AddRoom();
  this->Lamp->SetPosition(0.3, 0.2, 0.8);
  this->Lamp->SetIntensity(0.7);
  constexpr double low = -0.185, high = -0.05, side = 0.6;
  this->Baker->SetProbes(512); // a third apart
  const auto countWithin = [&] {
    EXPECT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field))
      << this->Baker->GetLastError();
    const penumbra::ProbeField field = penumbra::ProbeField::FromImage(this->Field);
    int within = 0;
    for (const glm::dvec3& at : field.Positions(0, field.Grids.Size()))
    {
      within += std::abs(at.x) < side && std::abs(at.y) < side && at.z > low && at.z < high;
    }
    return within;
  };
  this->AddBox(-side, side, -side, side, low, high, Albedo);
  this->Baker->RelocateOff();
  EXPECT_GT(countWithin(), 8);
  this->Baker->RelocateOn();
  EXPECT_EQ(countWithin(), 0);
}

// What a probe meets is drawn anew for each, however many are looked from at once.
TEST_F(ProbesBaker, ProbesAtOnePlaceDrawRaysOfTheirOwn)
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

// Of a grid that errs in a corner, and several that are right everywhere or wrong everywhere.
TEST_F(ProbesBaker, SeveralGridsStayWhereTheyErrLess)
{
  this->AddRoom();
  penumbra::GatherStage stage;
  stage.Prepare(this->Scene.Renderer);
  for (const double error : { 0.0, 3.0 })
  {
    int gathered = 0; // light of probes: twice of one grid, then twice of several
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
    // Nothing is gathered for too few to share.
    EXPECT_TRUE(placement.PlaceBest({ -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, 90, tried).has_value());
    EXPECT_EQ(gathered, 4);
  }
}

TEST_F(ProbesBaker, AlteredFieldsAreRefused)
{
  this->AddRoom();
  this->Lamp->SetIntensity(1.0);
  this->Bake(27, 4);
  const auto refused = [this](vtkImageData* image) {
    const std::string says = "its checksum does not fit";
    EXPECT_FALSE(this->Probes->SetBake(image));
    EXPECT_EQ(std::string(this->Probes->GetBakeError()).find(says), 0u)
      << this->Probes->GetBakeError();
    EXPECT_FALSE(this->Baker->AddSamples(this->Scene.Renderer, image, 1));
    EXPECT_EQ(std::string(this->Baker->GetLastError()).find(says), 0u);
    // Earlier versions wrote none; whoever alters a field takes it away.
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
    refused(altered);
  }
  for (const char* name : { "samples", "light scale" })
  {
    altered->DeepCopy(this->Field);
    vtkDataArray* array = altered->GetFieldData()->GetArray(name);
    array->SetComponent(0, 0, array->GetComponent(0, 0) + 1.0);
    refused(altered);
  }
  altered->DeepCopy(this->Field);
  altered->SetSpacing(1.0, 1.0, 1.0);
  refused(altered);
  altered->DeepCopy(this->Field);
  altered->SetOrigin(0.0, 0.0, 0.0);
  refused(altered);
}

TEST_F(ProbesBaker, ProgressRunsOnce)
{
  this->AddRoom();
  this->Lamp->SetIntensity(1.0);
  this->Lamp->SetPosition(0.3, -0.2, 0.4);
  std::vector<double> told;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&told);
  watch->SetCallback([](vtkObject*, unsigned long, void* list, void* progress) {
    static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(progress));
  });
  this->Baker->AddObserver(vtkCommand::ProgressEvent, watch);
  const auto once = [&told](const char* what) {
    ASSERT_FALSE(told.empty()) << what;
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end())) << what;
    EXPECT_GE(told.front(), 0.0) << what;
    EXPECT_DOUBLE_EQ(told.back(), 1.0) << what;
    EXPECT_EQ(std::count(told.begin(), told.end(), 1.0), 1) << what;
    told.clear();
  };
  this->Bake(64, 4);
  once("one grid");
  ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field));
  once("places alone");
  this->Baker->AdaptiveOn();
  for (const int probes : { 90, 91 }) // too few for several grids, and enough to try
  {
    this->Baker->SetProbes(probes);
    ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field));
    once("adaptive");
  }
  this->Lamp->SwitchOff();
  ASSERT_TRUE(this->Baker->Place(this->Scene.Renderer, this->Field));
  once("adaptive and dark");
}

TEST_F(ProbesBaker, SaysWhatIsMissingAtOnce)
{
  this->AddRoom();
  int told = 0;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&told);
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
  EXPECT_EQ(told, 0);
  EXPECT_EQ(this->Field->GetNumberOfPoints(), 0);
  this->Baker->SetProbes(1 << 20);
  EXPECT_EQ(this->Baker->GetProbes(), vtkGIProbeBaker::MostProbes);
}
