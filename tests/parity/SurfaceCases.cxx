// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

namespace penumbra_test
{
namespace
{
vtkActor* AddBall(Stage& stage)
{
  vtkActor* actor = stage.Add(Ball());
  Stage::LookAround(stage.Renderer);
  return actor;
}

// Half of a sphere, which shows its inside.
vtkActor* AddBowl(Stage& stage)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(32);
  source->SetPhiResolution(16);
  source->SetStartPhi(80.0);
  vtkActor* actor = stage.Add(source);
  stage.Renderer->GetActiveCamera()->SetPosition(0.2, -0.7, 1.0);
  stage.Renderer->ResetCamera();
  return actor;
}

vtkActor* AddWithoutNormals(Stage& stage)
{
  vtkSmartPointer<vtkPolyData> torus = Torus();
  torus->GetPointData()->SetNormals(nullptr);
  vtkActor* actor = stage.Add(torus);
  Stage::LookAround(stage.Renderer);
  return actor;
}

vtkSmartPointer<vtkPolyData> Helix(bool vertices)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  constexpr int count = 60;
  if (!vertices)
  {
    cells->InsertNextCell(count);
  }
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType id = points->InsertNextPoint(std::cos(0.3 * i), 0.04 * i, std::sin(0.3 * i));
    vertices ? static_cast<void>(cells->InsertNextCell(1, &id)) : cells->InsertCellPoint(id);
  }
  data->SetPoints(points);
  vertices ? data->SetVerts(cells) : data->SetLines(cells);
  return data;
}

vtkProperty* AddHelix(Stage& stage, bool vertices)
{
  vtkActor* actor = stage.Add(Helix(vertices));
  Stage::LookAround(stage.Renderer);
  return actor->GetProperty();
}

void AddFaces(Stage& stage)
{
  // A concave polygon, quads and a triangle in one array of polygons.
  vtkNew<vtkPoints> points;
  for (const auto& p : { std::array<double, 2>{ 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, 0.7 }, { 0, 2 },
         { 3, 0 }, { 3, 2 }, { 4, 1 } })
  {
    points->InsertNextPoint(p[0], p[1], 0.2 * p[0] * p[1]);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3, 4 });
  polygons->InsertNextCell({ 1, 5, 6, 2 });
  polygons->InsertNextCell({ 5, 7, 6 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  stage.Add(data);
  Stage::LookAround(stage.Renderer);
}
}

ParityCases SurfaceCases()
{
  return {
    { "phong", [](Stage& s) { AddTorus(s)->GetProperty()->SetInterpolationToPhong(); } },
    { "gouraud", [](Stage& s) { AddTorus(s)->GetProperty()->SetInterpolationToGouraud(); } },
    { "flat", [](Stage& s) { AddTorus(s)->GetProperty()->SetInterpolationToFlat(); } },
    { "specular",
      [](Stage& s) {
        vtkProperty* property = AddTorus(s)->GetProperty();
        property->SetSpecular(0.6);
        property->SetSpecularPower(30.0);
      } },
    { "specular coloured",
      [](Stage& s) {
        vtkProperty* property = AddTorus(s)->GetProperty();
        property->SetSpecular(0.9);
        property->SetSpecularColor(0.2, 1.0, 0.4);
        property->SetSpecularPower(3.0);
        property->SetDiffuse(0.5);
      } },
    { "specular two powers",
      [](Stage& s) {
        AddTorus(s)->GetProperty()->SetSpecular(0.5);
        vtkActor* other = AddBall(s);
        other->GetProperty()->SetSpecular(1.0);
        other->GetProperty()->SetSpecularPower(100.0);
      } },
    { "ambient",
      [](Stage& s) {
        vtkProperty* property = AddTorus(s)->GetProperty();
        property->SetAmbient(0.4);
        property->SetAmbientColor(0.1, 0.2, 0.9);
        property->SetDiffuse(0.6);
      } },
    { "LightingOff", [](Stage& s) { AddTorus(s)->GetProperty()->LightingOff(); } },
    { "LightingOff beside lit",
      [](Stage& s) {
        AddTorus(s)->GetProperty()->LightingOff();
        AddBall(s)->GetProperty()->SetSpecular(0.5);
      } },
    { "wireframe", [](Stage& s) { AddTorus(s)->GetProperty()->SetRepresentationToWireframe(); } },
    { "wireframe flat",
      [](Stage& s) {
        vtkProperty* property = AddTorus(s)->GetProperty();
        property->SetRepresentationToWireframe();
        property->SetInterpolationToFlat();
      } },
    { "wireframe as tubes",
      [](Stage& s) {
        vtkProperty* property = AddBall(s)->GetProperty();
        property->SetRepresentationToWireframe();
        property->RenderLinesAsTubesOn();
        property->SetLineWidth(3.0);
      } },
    { "points of a surface",
      [](Stage& s) {
        vtkProperty* property = AddTorus(s)->GetProperty();
        property->SetRepresentationToPoints();
        property->SetPointSize(4.0);
      } },
    { "points as spheres",
      [](Stage& s) {
        vtkProperty* property = AddTorus(s)->GetProperty();
        property->SetRepresentationToPoints();
        property->SetPointSize(12.0);
        property->RenderPointsAsSpheresOn();
      } },
    { "edges",
      [](Stage& s) {
        vtkProperty* property = AddBall(s)->GetProperty();
        property->EdgeVisibilityOn();
        property->SetEdgeColor(0.1, 0.1, 0.6);
      } },
    { "edges wide",
      [](Stage& s) {
        vtkProperty* property = AddBall(s)->GetProperty();
        property->EdgeVisibilityOn();
        property->SetLineWidth(3.0);
      } },
    { "edges as tubes",
      [](Stage& s) {
        vtkProperty* property = AddBall(s)->GetProperty();
        property->EdgeVisibilityOn();
        property->SetLineWidth(4.0);
        property->RenderLinesAsTubesOn();
        property->SetEdgeColor(0.9, 0.9, 0.2);
      } },
    { "vertices visible",
      [](Stage& s) {
        vtkProperty* property = AddBall(s)->GetProperty();
        property->VertexVisibilityOn();
        property->SetVertexColor(0.1, 0.9, 0.3);
        property->SetPointSize(5.0);
      } },
    { "lines", [](Stage& s) { AddHelix(s, false); } },
    { "lines wide", [](Stage& s) { AddHelix(s, false)->SetLineWidth(5.0); } },
    { "lines as tubes",
      [](Stage& s) {
        vtkProperty* property = AddHelix(s, false);
        property->SetLineWidth(8.0);
        property->RenderLinesAsTubesOn();
        property->SetSpecular(0.3);
      } },
    { "vertices", [](Stage& s) { AddHelix(s, true)->SetPointSize(6.0); } },
    { "vertices as spheres",
      [](Stage& s) {
        vtkProperty* property = AddHelix(s, true);
        property->SetPointSize(14.0);
        property->RenderPointsAsSpheresOn();
      } },
    { "two-sided open surface", [](Stage& s) { AddBowl(s)->GetProperty()->SetSpecular(0.4); } },
    { "backface property",
      [](Stage& s) {
        vtkActor* actor = AddBowl(s);
        vtkNew<vtkProperty> inside;
        inside->SetColor(0.2, 0.9, 0.3);
        inside->SetSpecular(0.7);
        inside->SetSpecularPower(15.0);
        inside->SetSpecularColor(1.0, 0.8, 0.8);
        inside->SetAmbient(0.2);
        actor->SetBackfaceProperty(inside);
      } },
    { "backface culling", [](Stage& s) { AddBowl(s)->GetProperty()->BackfaceCullingOn(); } },
    { "frontface culling", [](Stage& s) { AddBowl(s)->GetProperty()->FrontfaceCullingOn(); } },
    { "no normals", [](Stage& s) { AddWithoutNormals(s)->GetProperty()->SetSpecular(0.4); } },
    { "flat, backface property",
      [](Stage& s) {
        vtkActor* actor = AddBowl(s);
        actor->GetProperty()->SetInterpolationToFlat();
        vtkNew<vtkProperty> inside;
        inside->SetColor(0.9, 0.2, 0.8);
        actor->SetBackfaceProperty(inside);
      } },
    { "no normals, backface property",
      [](Stage& s) {
        vtkActor* actor = AddBowl(s);
        auto* mapper = static_cast<vtkPolyDataMapper*>(actor->GetMapper());
        mapper->Update();
        vtkNew<vtkPolyData> data;
        data->ShallowCopy(mapper->GetInput());
        data->GetPointData()->SetNormals(nullptr);
        mapper->SetInputData(data);
        vtkNew<vtkProperty> inside;
        inside->SetColor(0.9, 0.2, 0.8);
        actor->SetBackfaceProperty(inside);
      } },
    { "cell normals",
      [](Stage& s) {
        vtkNew<vtkPolyDataNormals> normals;
        normals->SetInputData(Ball(12));
        normals->ComputePointNormalsOff();
        normals->ComputeCellNormalsOn();
        s.Add(normals)->GetProperty()->SetSpecular(0.3);
        Stage::LookAround(s.Renderer);
      } },
    { "strips",
      [](Stage& s) {
        vtkNew<vtkTriangleFilter> triangles;
        triangles->SetInputData(Torus());
        vtkNew<vtkStripper> stripper;
        stripper->SetInputConnection(triangles->GetOutputPort());
        s.Add(stripper);
        Stage::LookAround(s.Renderer);
      } },
    { "quads",
      [](Stage& s) {
        vtkNew<vtkCubeSource> cube;
        s.Add(cube)->GetProperty()->SetSpecular(0.3);
        Stage::LookAround(s.Renderer);
      } },
    { "polygons", AddFaces },
    { "inconsistent winding",
      [](Stage& s) {
        // Every second triangle is reversed.
        vtkSmartPointer<vtkPolyData> ball = Ball();
        vtkNew<vtkCellArray> triangles;
        vtkNew<vtkIdList> ids;
        for (vtkIdType i = 0; i < ball->GetNumberOfCells(); ++i)
        {
          ball->GetCellPoints(i, ids);
          triangles->InsertNextCell(
            { ids->GetId(0), ids->GetId(i % 2 ? 2 : 1), ids->GetId(i % 2 ? 1 : 2) });
        }
        ball->SetPolys(triangles);
        s.Add(ball)->GetProperty()->SetSpecular(0.4);
        Stage::LookAround(s.Renderer);
      } },
  };
}
}
