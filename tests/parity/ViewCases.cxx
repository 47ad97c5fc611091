// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

#include "vtkConeSource.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneSource.h"
#include "vtkSkybox.h"
#include "vtkTransform.h"

namespace penumbra_test
{
namespace
{
void AddTo(vtkRenderer* renderer, vtkPolyData* data, double red, double green)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, 0.7);
  actor->GetProperty()->SetSpecular(0.4);
  renderer->AddActor(actor);
}

vtkRenderer* AddSecond(Stage& stage)
{
  AddShinyTorus(stage);
  vtkRenderer* second = stage.AddRenderer();
  AddTo(second, Ball(), 0.2, 0.8);
  Stage::LookAround(second);
  return second;
}

vtkRenderer* AddLayer(Stage& stage)
{
  vtkRenderer* second = AddSecond(stage);
  stage.Window->SetNumberOfLayers(2);
  second->SetLayer(1);
  return second;
}

// Three viewports with gaps between, one of them empty.
void AddThreeViewports(Stage& stage)
{
  vtkRenderer* second = AddSecond(stage);
  vtkRenderer* empty = stage.AddRenderer();
  stage.Renderer->SetViewport(0.05, 0.1, 0.4, 0.93);
  second->SetViewport(0.45, 0.5, 0.95, 0.97);
  empty->SetViewport(0.5, 0.05, 0.9, 0.4);
}

void SetSize(Stage& stage, int width, int height)
{
  stage.Window->SetSize(width, height);
  AddShinyTorus(stage);
}

// The same torus, larger and far from the origin.
void AddFar(Stage& stage, double size, double offset)
{
  vtkActor* actor = stage.Add(Torus());
  actor->SetScale(size);
  actor->SetPosition(offset, -2.0 * offset, 0.5 * offset);
  actor->GetProperty()->SetSpecular(0.4);
  Stage::LookAround(stage.Renderer);
}

// Large coordinates in the data instead of the actor's matrix.
void AddFarData(Stage& stage, double size, double offset)
{
  vtkSmartPointer<vtkPolyData> torus = Torus();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < torus->GetNumberOfPoints(); ++i)
  {
    double p[3];
    torus->GetPoint(i, p);
    points->InsertNextPoint(
      size * p[0] + offset, size * p[1] - 2.0 * offset, size * p[2] + 0.5 * offset);
  }
  torus->SetPoints(points);
  vtkActor* actor = stage.Add(torus);
  actor->GetProperty()->SetSpecular(0.4);
  Stage::LookAround(stage.Renderer);
}

void AddCoincident(Stage& stage)
{
  vtkSmartPointer<vtkPolyData> ball = Ball(12);
  stage.Add(ball);
  vtkActor* wires = stage.Add(ball);
  wires->GetProperty()->SetRepresentationToWireframe();
  wires->GetProperty()->SetColor(0.0, 0.0, 0.3);
  wires->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  wires->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -2.0);
  Stage::LookAround(stage.Renderer);
}

vtkSmartPointer<vtkTexture> BackgroundTexture()
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(Checkerboard());
  return texture;
}

void AddSkybox(Stage& stage)
{
  AddShinyTorus(stage);
  auto texture = BackgroundTexture();
  texture->InterpolateOn();
  texture->MipmapOn();
  vtkNew<vtkSkybox> skybox;
  skybox->SetTexture(texture);
  skybox->SetProjectionToSphere();
  stage.Renderer->AddActor(skybox);
}

void SetStereo(Stage& stage, int type)
{
  AddShinyTorus(stage);
  stage.Window->SetStereoType(type);
  stage.Window->StereoRenderOn();
}

// One tile of a larger picture, as in VTK's tiled screenshots.
void SetTile(Stage& stage)
{
  AddShinyTorus(stage);
  stage.Window->SetTileScale(2, 2);
  stage.Window->SetTileViewport(0.5, 0.0, 1.0, 0.5);
}
}

ParityCases ViewCases()
{
  return {
    { "side by side",
      [](Stage& s) {
        vtkRenderer* second = AddSecond(s);
        s.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
        second->SetViewport(0.5, 0.0, 1.0, 1.0);
      } },
    { "viewports with gaps", AddThreeViewports },
    { "viewport inside the window",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Renderer->SetViewport(0.3, 0.2, 0.8, 0.9);
      } },
    { "layer above", [](Stage& s) { AddLayer(s); } },
    { "layer above, keeping depth",
      [](Stage& s) {
        vtkRenderer* second = AddLayer(s);
        second->SetActiveCamera(s.Renderer->GetActiveCamera());
        second->PreserveDepthBufferOn();
      } },
    { "layer above, keeping colour",
      [](Stage& s) {
        vtkRenderer* second = AddLayer(s);
        second->PreserveColorBufferOn();
        second->SetViewport(0.4, 0.4, 1.0, 1.0);
      } },
    { "renderer that erases nothing",
      [](Stage& s) {
        vtkRenderer* second = AddSecond(s);
        second->EraseOff();
      } },
    { "parallel projection",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Renderer->GetActiveCamera()->ParallelProjectionOn();
        s.Renderer->ResetCamera();
      } },
    { "wide angle",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Renderer->GetActiveCamera()->SetViewAngle(110.0);
        s.Renderer->ResetCamera();
      } },
    { "window centre moved",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Renderer->GetActiveCamera()->SetWindowCenter(0.3, -0.2);
      } },
    { "camera rolled, user transform",
      [](Stage& s) {
        AddShinyTorus(s);
        vtkNew<vtkTransform> shear;
        shear->Scale(1.0, 0.7, 1.0);
        s.Renderer->GetActiveCamera()->SetUserViewTransform(shear);
        s.Renderer->GetActiveCamera()->Roll(35.0);
      } },
    { "wide window", [](Stage& s) { SetSize(s, 400, 100); } },
    { "tall window", [](Stage& s) { SetSize(s, 90, 300); } },
    { "odd window", [](Stage& s) { SetSize(s, 333, 217); } },
    { "tiny window", [](Stage& s) { SetSize(s, 17, 13); } },
    { "tile of a larger picture", SetTile },
    { "gradient background",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Renderer->SetBackground2(0.9, 0.9, 0.6);
        s.Renderer->GradientBackgroundOn();
      } },
    { "textured background",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Renderer->SetBackgroundTexture(BackgroundTexture());
        s.Renderer->TexturedBackgroundOn();
      } },
    { "transparent background",
      [](Stage& s) {
        AddShinyTorus(s);
        s.Window->SetAlphaBitPlanes(1);
        s.Renderer->SetBackgroundAlpha(0.0);
      } },
    { "skybox", AddSkybox },
    { "anaglyph stereo", [](Stage& s) { SetStereo(s, VTK_STEREO_ANAGLYPH); } },
    { "left eye", [](Stage& s) { SetStereo(s, VTK_STEREO_LEFT); } },
    { "side-by-side stereo", [](Stage& s) { SetStereo(s, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL); } },
    { "4000 units", [](Stage& s) { AddFar(s, 4000.0, 0.0); } },
    { "4000 units, in the data", [](Stage& s) { AddFarData(s, 4000.0, 2000.0); } },
    { "a million units away", [](Stage& s) { AddFar(s, 100.0, 1e6); } },
    { "a million units away, in the data", [](Stage& s) { AddFarData(s, 100.0, 1e6); } },
    { "a thousandth of a unit", [](Stage& s) { AddFar(s, 0.001, 0.0); } },
    { "matrix, negative scale",
      [](Stage& s) {
        vtkActor* actor = AddShinyTorus(s);
        vtkNew<vtkMatrix4x4> shear;
        shear->SetElement(0, 1, 0.4);
        shear->SetElement(2, 2, 0.5);
        actor->SetUserMatrix(shear);
        actor->SetScale(-1.0, 1.3, 0.8);
        Stage::LookAround(s.Renderer);
      } },
    { "hidden actor",
      [](Stage& s) {
        AddShinyTorus(s)->VisibilityOff();
        s.Add(Ball());
      } },
    { "coincident topology", AddCoincident },
    { "many actors",
      [](Stage& s) {
        for (int i = 0; i < 60; ++i)
        {
          vtkActor* actor = s.Add(Ball(10));
          actor->SetPosition(i % 8, (i * 7) % 11, (i * 5) % 6);
          actor->GetProperty()->SetColor(0.1 * (i % 10), 0.5, 1.0 - 0.1 * (i % 10));
          actor->GetProperty()->SetSpecular(0.1 * (i % 7));
        }
        Stage::LookAround(s.Renderer);
      } },
  };
}
}
