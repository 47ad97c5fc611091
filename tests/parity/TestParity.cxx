// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The pass with every technique off draws stock VTK's picture. Its capture into the G-buffer and its direct light are
// compared with a renderer without a pass.
#include "Cases.h"
#include "Picture.h"

#include "vtkGILightmap.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>

#include <cstdio>

namespace penumbra_test
{
namespace
{
struct Row
{
  std::string Name;
  Difference Found;
  double Captured;
};
std::vector<Row> Table;

// Share of pixels that came through the G-buffer, summed over the renderers.
double CapturedShare(Stage& stage, const std::vector<vtkSmartPointer<vtkGIPass>>& passes)
{
  double share = 0.0;
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    vtkNew<vtkImageData> radiance;
    vtkObject* renderer = stage.Window->GetRenderers()->GetItemAsObject(static_cast<int>(i));
    if (passes[i]->GetRadiance(static_cast<vtkRenderer*>(renderer), radiance))
    {
      const auto* values = static_cast<float*>(radiance->GetScalarPointer());
      const vtkIdType count = radiance->GetNumberOfPoints();
      vtkIdType captured = 0;
      for (vtkIdType p = 0; p < count; ++p)
      {
        captured += values[4 * p + 3] > 0.5f;
      }
      share += static_cast<double>(captured) / count;
    }
  }
  return share;
}

class Parity : public testing::TestWithParam<ParityCase>
{
protected:
  void SetUp() override
  {
    if (!HasBackend())
    {
      GTEST_SKIP() << "no such backend here";
    }
  }
  static void TearDownTestSuite()
  {
    std::printf(
      "\n%-36s %10s %10s %5s %8s %9s\n", "case", "within 2", "depth", "max", "mean", "captured");
    for (const auto& row : Table)
    {
      std::printf("%-36s %9.4f%% %9.4f%% %5d %8.4f %8.2f%%\n", row.Name.c_str(),
        100.0 * row.Found.Within, 100.0 * row.Found.DepthWithin, row.Found.Max, row.Found.Mean,
        100.0 * row.Captured);
    }
    std::printf("\n");
  }
};

// Give every renderer a lightmap whose only triangles are out of sight.
void AddEmptyMaps(Stage& stage, const std::vector<vtkSmartPointer<vtkGIPass>>& passes)
{
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    vtkNew<vtkPlaneSource> far;
    far->SetCenter(1e6, 1e6, 1e6);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(far->GetOutputPort());
    triangles->Update();
    vtkObject* renderer = stage.Window->GetRenderers()->GetItemAsObject(static_cast<int>(i));
    vtkNew<vtkStringArray> scene;
    scene->SetName("scene");
    scene->InsertNextValue(vtkGILightmap::DescribeScene(static_cast<vtkRenderer*>(renderer)));
    triangles->GetOutput()->GetFieldData()->AddArray(scene);
    vtkNew<vtkImageData> light;
    light->SetDimensions(1, 1, 1);
    light->AllocateScalars(VTK_FLOAT, 3);
    light->GetPointData()->GetScalars()->Fill(1.0);
    auto* map = vtkGILightmap::SafeDownCast(passes[i]->GetTechnique("lightmap"));
    ASSERT_TRUE(map->SetBake(triangles->GetOutput(), light));
    map->EnabledOn();
  }
}

TEST_P(Parity, EqualsStock)
{
  const ParityCase& row = GetParam();
  Picture stock;
  {
    Stage stage;
    row.Build(stage);
    stock = Shoot(stage.Window);
  }
  Stage stage;
  row.Build(stage);
  const auto passes = stage.SetPasses();
  const Picture ours = Shoot(stage.Window);
  for (const auto& pass : passes)
  {
    EXPECT_STREQ("", pass->GetLastError());
    pass->KeepRadianceOn();
  }
  // A second frame with kept radiance: the same picture, and the pixels that were captured.
  const Picture again = Shoot(stage.Window);
  const double captured = CapturedShare(stage, passes);
  // A lightmap without visible surfaces changes nothing, whichever target it shares.
  AddEmptyMaps(stage, passes);
  const Picture mapped = Shoot(stage.Window);
  for (const auto& pass : passes)
  {
    EXPECT_STREQ("", pass->GetLastError());
    EXPECT_STREQ("", pass->GetNotes());
  }

  const Difference found = Compare(stock, ours, 2);
  Table.push_back({ row.Name, found, captured });
  EXPECT_GT(Busyness(stock), 0.005) << "the case shows nothing";
  EXPECT_GE(found.Within, row.Share);
  EXPECT_GE(found.DepthWithin, row.Share);
  EXPECT_GE(Compare(ours, again, 1).Within, row.Share) << "the second frame differs";
  // Without a lamp VTK draws unlit colours, which any lightmap replaces.
  if (vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->GetLightingComplexity() > 0 ||
    stage.Renderer->GetEnvironmentTexture())
  {
    EXPECT_GE(Compare(again, mapped, 1).Within, row.Share) << "empty maps change the picture";
  }
  EXPECT_EQ(row.Captured, captured > 0.001) << "captured share: " << captured;
  if (HasFailure())
  {
    const std::string name = row.Id();
    Save(stock, name + "-stock");
    Save(ours, name + "-ours");
    Save(Amplified(stock, ours), name + "-difference");
  }
}

INSTANTIATE_TEST_SUITE_P(
  Cases, Parity, testing::ValuesIn(AllCases()), [](const auto& info) { return info.param.Id(); });
}
}
