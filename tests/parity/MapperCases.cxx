// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"
#include "CompositeMapper.h"

#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLODProp3D.h"
#include "vtkMolecule.h"
#include "vtkMoleculeMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlane.h"
#include "vtkPointGaussianMapper.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSphereSource.h"
#include "vtkThreshold.h"

namespace penumbra_test
{
namespace
{
// Points on a spiral, each with a value, a radius and a direction.
vtkSmartPointer<vtkPolyData> Spiral(int count)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkFloatArray> radii;
  vtkNew<vtkFloatArray> directions;
  values->SetName("value");
  radii->SetName("radius");
  directions->SetName("direction");
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 0.7 * i;
    const vtkIdType id = points->InsertNextPoint(std::cos(angle), 0.1 * i, std::sin(angle));
    vertices->InsertNextCell(1, &id);
    values->InsertNextValue(i / static_cast<double>(count));
    radii->InsertNextValue(0.1 + 0.02 * (i % 5));
    directions->InsertNextTuple3(std::cos(angle), 0.5, std::sin(angle));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->SetScalars(values);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->AddArray(directions);
  return data;
}

void AddGlyphs(Stage& stage, bool scalars)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(16);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(Spiral(20));
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetScaleFactor(0.5);
  mapper->SetOrientationArray("direction");
  mapper->SetScalarVisibility(scalars);
  stage.Add(mapper)->GetProperty()->SetSpecular(0.4);
  Stage::LookAround(stage.Renderer);
}

vtkSmartPointer<CompositeMapper> AddBlocks(Stage& stage)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.8 * i, 0.2 * i, 0.0);
    sphere->SetThetaResolution(20);
    sphere->SetPhiResolution(20);
    sphere->Update();
    blocks->SetBlock(i, sphere->GetOutput());
  }
  auto mapper = vtkSmartPointer<CompositeMapper>::New();
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  stage.Add(mapper)->GetProperty()->SetSpecular(0.3);
  Stage::LookAround(stage.Renderer);
  return mapper;
}

void AddBlocksOneByOne(Stage& stage)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.8 * i, 0.2 * i, 0.0);
    sphere->Update();
    blocks->SetBlock(i, sphere->GetOutput());
  }
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  stage.Add(mapper)->GetProperty()->SetSpecular(0.3);
  Stage::LookAround(stage.Renderer);
}

void AddImpostors(Stage& stage, bool scalars)
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(Spiral(20));
  mapper->SetScaleArray("radius");
  mapper->SetScalarVisibility(scalars);
  stage.Add(mapper)->GetProperty()->SetSpecular(0.4);
  Stage::LookAround(stage.Renderer);
}

// The mapper reads floats and colours, and three numbers per stick: length, radius, and one that it ignores.
void AddSticks(Stage& stage)
{
  vtkSmartPointer<vtkPolyData> spiral = Spiral(16);
  vtkNew<vtkFloatArray> scale;
  scale->SetName("size");
  scale->SetNumberOfComponents(3);
  for (int i = 0; i < 16; ++i)
  {
    scale->InsertNextTuple3(0.6, 0.08, 0.0);
  }
  spiral->GetPointData()->AddArray(scale);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(spiral);
  mapper->SetOrientationArray("direction");
  mapper->SetScaleArray("size");
  stage.Add(mapper)->GetProperty()->SetSpecular(0.4);
  Stage::LookAround(stage.Renderer);
}

void AddMolecule(Stage& stage)
{
  vtkNew<vtkMolecule> molecule;
  vtkAtom carbon = molecule->AppendAtom(6, 0.0, 0.0, 0.0);
  const double hydrogens[4][3] = { { 0.6, 0.6, 0.6 }, { -0.6, -0.6, 0.6 }, { -0.6, 0.6, -0.6 },
    { 0.6, -0.6, -0.6 } };
  for (const auto& p : hydrogens)
  {
    molecule->AppendBond(carbon, molecule->AppendAtom(1, p[0], p[1], p[2]), 1);
  }
  vtkNew<vtkMoleculeMapper> mapper;
  mapper->SetInputData(molecule);
  mapper->UseBallAndStickSettings();
  stage.Add(mapper);
  Stage::LookAround(stage.Renderer);
}

vtkActor* AddClipped(Stage& stage, int planes)
{
  vtkActor* actor = stage.Add(Torus());
  for (int i = 0; i < planes; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.1, 0.1 * i, 0.0);
    plane->SetNormal(i == 0 ? 1.0 : 0.3, 0.2, i == 0 ? 0.4 : -0.9);
    actor->GetMapper()->AddClippingPlane(plane);
  }
  Stage::LookAround(stage.Renderer);
  return actor;
}

void AddUnstructuredGrid(Stage& stage)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-6, 6, -6, 6, -6, 6);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputConnection(wavelet->GetOutputPort());
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "RTData");
  threshold->SetUpperThreshold(170.0);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(threshold->GetOutputPort());
  mapper->SetScalarRange(100.0, 260.0);
  stage.Add(mapper);
  Stage::LookAround(stage.Renderer);
}

void AddAssembly(Stage& stage)
{
  vtkNew<vtkAssembly> inner;
  vtkNew<vtkAssembly> outer;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Torus());
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkActor> part;
    part->SetMapper(mapper);
    part->SetPosition(0.7 * i, 0.0, 0.4 * i);
    part->GetProperty()->SetColor(0.3 * i, 0.8, 1.0 - 0.3 * i);
    (i == 0 ? outer : inner)->AddPart(part);
  }
  outer->AddPart(inner);
  outer->RotateX(30.0);
  inner->RotateZ(40.0);
  stage.Renderer->AddActor(outer);
  Stage::LookAround(stage.Renderer);
}

void AddFollower(Stage& stage)
{
  stage.Add(Ball());
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkFollower> follower;
  follower->SetMapper(mapper);
  follower->SetPosition(0.6, 0.5, 0.3);
  follower->SetCamera(stage.Renderer->GetActiveCamera());
  stage.Renderer->AddActor(follower);
  Stage::LookAround(stage.Renderer);
}

void AddLevelsOfDetail(Stage& stage)
{
  vtkNew<vtkLODProp3D> levels;
  for (const int resolution : { 32, 8 })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(Ball(resolution));
    vtkNew<vtkProperty> property;
    property->SetColor(0.4, 0.9, 0.6);
    levels->AddLOD(mapper, property, 0.0);
  }
  levels->AutomaticLODSelectionOff();
  levels->SetSelectedLODID(1000);
  stage.Renderer->AddViewProp(levels);
  Stage::LookAround(stage.Renderer);
}

void AddSplats(Stage& stage)
{
  stage.Add(Ball());
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(Spiral(30));
  mapper->SetScaleFactor(0.1);
  // Opaque discs: the default splats are soft and translucent.
  mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                             "  if (dot(offsetVCVSOutput, offsetVCVSOutput) > 1.0) { discard; }\n");
  mapper->EmissiveOff();
  stage.Add(mapper)->ForceOpaqueOn();
  Stage::LookAround(stage.Renderer);
}
}

ParityCases MapperCases()
{
  return {
    { "glyphs", [](Stage& s) { AddGlyphs(s, false); } },
    { "glyphs coloured", [](Stage& s) { AddGlyphs(s, true); } },
    { "composite", [](Stage& s) { AddBlocks(s); } },
    { "composite, block colours",
      [](Stage& s) {
        auto mapper = AddBlocks(s);
        mapper->SetBlockColor(1, 0.9, 0.1, 0.2);
        mapper->SetBlockColor(2, 0.1, 0.2, 0.9);
      } },
    { "composite, hidden block", [](Stage& s) { AddBlocks(s)->SetBlockVisibility(2, false); } },
    { "composite, a mapper for each block", AddBlocksOneByOne },
    { "sphere impostors", [](Stage& s) { AddImpostors(s, false); } },
    { "sphere impostors coloured", [](Stage& s) { AddImpostors(s, true); } },
    { "sphere impostors, parallel projection",
      [](Stage& s) {
        AddImpostors(s, true);
        s.Renderer->GetActiveCamera()->ParallelProjectionOn();
        s.Renderer->ResetCamera();
      } },
    { "stick impostors", AddSticks },
    { "molecule", AddMolecule },
    { "clipping plane", [](Stage& s) { AddClipped(s, 1); } },
    { "clipping planes, backface property",
      [](Stage& s) {
        vtkNew<vtkProperty> inside;
        inside->SetColor(0.8, 0.2, 0.2);
        AddClipped(s, 2)->SetBackfaceProperty(inside);
      } },
    { "data set mapper", AddUnstructuredGrid },
    { "assembly", AddAssembly },
    { "follower", AddFollower },
    { "levels of detail", AddLevelsOfDetail, false },
    { "splats", AddSplats },
  };
}
}
