// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays see glyphs and clipping planes as VTK draws them.
#include "Agreement.h"

#include "vtkActorCollection.h"
#include "vtkBitArray.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkGITechnique.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkSphereSource.h"

#include <atomic>

using namespace penumbra_test;

namespace
{
vtkSmartPointer<vtkPolyData> Points(int across)
{
  vtkNew<vtkPoints> points;
  std::map<std::string, vtkSmartPointer<vtkFloatArray>> arrays;
  for (const char* name : { "value", "direction", "rotation", "quaternion", "size", "shape" })
  {
    arrays[name] = vtkSmartPointer<vtkFloatArray>::New();
    arrays[name]->SetName(name);
  }
  for (const char* name : { "direction", "rotation", "size" })
  {
    arrays[name]->SetNumberOfComponents(3);
  }
  arrays["quaternion"]->SetNumberOfComponents(4);
  vtkNew<vtkBitArray> mask;
  mask->SetName("mask");
  for (int i = 0; i < across * across; ++i)
  {
    points->InsertNextPoint(i % across, i / across, 0.0);
    const double angle = 0.7 * i;
    arrays["value"]->InsertNextValue(static_cast<float>(i) / (across * across));
    arrays["direction"]->InsertNextTuple3(std::cos(angle), std::sin(angle), 0.3);
    arrays["rotation"]->InsertNextTuple3(20.0 * i, 35.0 * i, 50.0 * i);
    arrays["quaternion"]->InsertNextTuple4(
      std::cos(angle), 0.0, 0.6 * std::sin(angle), 0.8 * std::sin(angle));
    arrays["size"]->InsertNextTuple3(0.5 + 0.03 * (i % 7), 0.6 + 0.05 * (i % 5), 0.8);
    arrays["shape"]->InsertNextValue(static_cast<float>(i % 3));
    mask->InsertNextValue(i % 4 != 1);
  }
  // Opposite to the glyph: a rotation by 180 degrees, whose axis is not unique.
  arrays["direction"]->SetTuple3(0, -1.0, 0.0, 0.0);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  for (const auto& array : arrays)
  {
    data->GetPointData()->AddArray(array.second);
  }
  data->GetPointData()->AddArray(mask);
  data->GetPointData()->SetActiveScalars("value");
  return data;
}

vtkSmartPointer<vtkGlyph3DMapper> AddGlyphs(Stage& stage, int across = 4, int resolution = 48)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(resolution);
  cone->SetRadius(0.4);
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(Points(across));
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetScaleFactor(0.8);
  mapper->ScalarVisibilityOff();
  stage.Add(mapper)->GetProperty()->SetSpecular(0.2);
  return mapper;
}
}

TEST(PathsGlyphs, ByDirectionWithColours)
{
  Stage stage;
  auto mapper = AddGlyphs(stage);
  mapper->SetOrientationArray("direction");
  mapper->ScalarVisibilityOn();
  LightFromCamera(stage);
  ExpectAgreement(stage, "glyphs-direction");
}

TEST(PathsGlyphs, ByRotationAndComponents)
{
  Stage stage;
  auto mapper = AddGlyphs(stage);
  mapper->SetOrientationModeToRotation();
  mapper->SetOrientationArray("rotation");
  mapper->SetScaleModeToScaleByVectorComponents();
  mapper->SetScaleArray("size");
  LightFromCamera(stage);
  ExpectAgreement(stage, "glyphs-rotation");
}

TEST(PathsGlyphs, ByQuaternionAndClampedMagnitude)
{
  Stage stage;
  auto mapper = AddGlyphs(stage);
  mapper->SetOrientationModeToQuaternion();
  mapper->SetOrientationArray("quaternion");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleArray("value");
  mapper->ClampingOn();
  mapper->SetRange(-0.5, 0.6);
  LightFromCamera(stage);
  ExpectAgreement(stage, "glyphs-quaternion");
}

TEST(PathsGlyphs, MaskedAndOfSeveralShapesWithAScaledActor)
{
  Stage stage;
  auto mapper = AddGlyphs(stage);
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  mapper->SetSourceConnection(1, cube->GetOutputPort());
  mapper->SetSourceConnection(2, sphere->GetOutputPort());
  mapper->SourceIndexingOn();
  mapper->SetSourceIndexArray("shape");
  mapper->MaskingOn();
  mapper->SetMaskArray("mask");
  mapper->ScalarVisibilityOn();
  vtkActor* actor = stage.Renderer->GetActors()->GetLastActor();
  actor->SetScale(1.0, 1.4, 1.0);
  actor->RotateZ(20.0);
  LightFromCamera(stage);
  ExpectAgreement(stage, "glyphs-shapes");
}

TEST(PathsGlyphs, TablesOfShapesAndBlocksOfPoints)
{
  Stage stage;
  auto mapper = AddGlyphs(stage);
  vtkNew<vtkMultiBlockDataSet> table;
  vtkNew<vtkMultiBlockDataSet> pair;
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.5, 0.0, -0.3, 0.3, -0.3, 0.3);
  cube->Update();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.3, 0.0, 0.0);
  sphere->SetRadius(0.3);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  sphere->Update();
  pair->SetBlock(0, cube->GetOutput());
  pair->SetBlock(1, sphere->GetOutput());
  table->SetBlock(0, pair);
  table->SetBlock(1, cube->GetOutput());
  mapper->SetSourceTableTree(table);
  mapper->UseSourceTableTreeOn();
  mapper->SourceIndexingOn();
  mapper->SetSourceIndexArray("shape");
  mapper->SetOrientationArray("direction");
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> inner;
  blocks->SetBlock(0, Points(4));
  vtkSmartPointer<vtkPolyData> other = Points(3);
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
  {
    double p[3];
    other->GetPoint(i, p);
    other->GetPoints()->SetPoint(i, p[0] + 5.0, p[1], p[2]);
  }
  inner->SetBlock(0, other);
  blocks->SetBlock(1, inner);
  mapper->SetInputDataObject(blocks);
  LightFromCamera(stage);
  ExpectAgreement(stage, "glyphs-table");
}

namespace
{
/// Counts how often single points are read, as gathering glyphs does.
class CountedPoints : public vtkPolyData
{
public:
  static CountedPoints* New();
  vtkTypeMacro(CountedPoints, vtkPolyData);
  using vtkPolyData::GetPoint;
  void GetPoint(vtkIdType i, double x[3]) override
  {
    ++this->Reads;
    this->vtkPolyData::GetPoint(i, x);
  }
  std::atomic<long> Reads{ 0 };
};
vtkStandardNewMacro(CountedPoints);
}

// penumbra_bench glyphs measures the time of many more.
TEST(PathsGlyphs, AreGatheredOnce)
{
  constexpr int across = 50;
  Stage stage;
  auto mapper = AddGlyphs(stage, across, 3);
  vtkNew<CountedPoints> points;
  points->ShallowCopy(mapper->GetInput());
  mapper->SetInputData(points);
  mapper->SetOrientationArray("direction");
  LightFromCamera(stage);
  stage.Window->SetSize(16, 16);
  auto pass = stage.SetPasses().front();
  vtkGITechnique* paths = pass->GetTechnique("path-tracing");
  paths->SetParameter("bounces", 0);
  stage.Window->Render();
  paths->EnabledOn();
  const auto reads = [&] {
    const long before = points->Reads;
    stage.Window->Render();
    return points->Reads - before;
  };
  EXPECT_GE(reads(), across * across);
  EXPECT_EQ(reads(), 0);
  stage.Renderer->GetActiveCamera()->Azimuth(5.0);
  EXPECT_EQ(reads(), 0) << "the camera moved";
  mapper->SetScaleFactor(0.7);
  EXPECT_GE(reads(), across * across) << "the glyphs changed";
}

namespace
{
void AddTorus(Stage& stage, int planes)
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(0.6);
  torus->SetCrossSectionRadius(0.25);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(100);
  source->SetVResolution(60);
  vtkActor* actor = stage.Add(source);
  for (int i = 0; i < planes; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.1, 0.1 * i, 0.0);
    plane->SetNormal(i == 0 ? 1.0 : -0.3, 0.2, i == 0 ? -0.4 : -0.9);
    actor->GetMapper()->AddClippingPlane(plane);
  }
}
}

TEST(PathsClipping, ByOnePlane)
{
  Stage stage;
  AddTorus(stage, 1);
  LightFromCamera(stage);
  ExpectAgreement(stage, "clipped");
}

TEST(PathsClipping, ByPlanesOfTheWorldWithABackfaceProperty)
{
  Stage stage;
  AddTorus(stage, 2);
  vtkNew<vtkProperty> inside;
  inside->SetColor(0.2, 0.3, 0.9);
  vtkActor* actor = stage.Renderer->GetActors()->GetLastActor();
  actor->SetBackfaceProperty(inside);
  actor->SetPosition(1000.0, 2000.0, 0.0);
  vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    planes->GetItem(i)->SetOrigin(1000.0, 2000.0, 0.1 * i);
  }
  LightFromCamera(stage);
  ExpectAgreement(stage, "clipped-far-away");
}

TEST(PathsClipping, OfGlyphs)
{
  Stage stage;
  auto mapper = AddGlyphs(stage);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1.7, 0.0, 0.0);
  plane->SetNormal(1.0, 0.1, 0.0);
  mapper->AddClippingPlane(plane);
  LightFromCamera(stage);
  ExpectAgreement(stage, "glyphs-clipped");
}

namespace
{
// Expect that rays show a change in the next frame, although they keep data from frame to frame.
void ExpectVisible(Stage& stage, const std::function<void()>& change)
{
  auto pass = stage.SetPasses().front();
  vtkGITechnique* paths = pass->GetTechnique("path-tracing");
  paths->EnabledOn();
  paths->SetParameter("bounces", 0);
  paths->SetParameter("samples", 1);
  const Picture before = Shoot(stage.Window);
  change();
  const Picture after = Shoot(stage.Window);
  stage.Renderer->SetPass(nullptr);
  const Picture raster = Shoot(stage.Window);
  EXPECT_LT(Compare(before, after, 2).Within, 0.995) << "the change is not visible";
  EXPECT_GE(Compare(after, raster, 3).Within, 0.999);
}
}

TEST(PathsChanges, OfGlyphsAreVisibleAtOnce)
{
  Stage stage;
  auto mapper = AddGlyphs(stage);
  mapper->SetOrientationArray("direction");
  LightFromCamera(stage);
  ExpectVisible(stage, [&] {
    auto* points = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0))->GetPoints();
    points->SetPoint(5, 1.3, 1.4, 0.0);
    points->Modified();
  });
  ExpectVisible(stage, [&] { mapper->SetScaleFactor(0.5); });
  ExpectVisible(stage, [&] {
    vtkNew<vtkCubeSource> cube;
    mapper->SetSourceConnection(cube->GetOutputPort());
  });
  ExpectVisible(stage, [&] { mapper->ScalarVisibilityOn(); });
}

TEST(PathsChanges, OfClippingPlanesAreVisibleAtOnce)
{
  Stage stage;
  AddTorus(stage, 1);
  LightFromCamera(stage);
  vtkActor* actor = stage.Renderer->GetActors()->GetLastActor();
  ExpectVisible(
    stage, [&] { actor->GetMapper()->GetClippingPlanes()->GetItem(0)->SetOrigin(0.4, 0.0, 0.0); });
  ExpectVisible(stage, [&] { actor->GetMapper()->RemoveAllClippingPlanes(); });
}
