// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

#include "vtkActor2D.h"
#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCubeAxesActor.h"
#include "vtkImageMapper.h"
#include "vtkLookupTable.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRegularPolygonSource.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace penumbra_test
{
namespace
{
void AddText(Stage& stage)
{
  vtkNew<vtkTextActor> text;
  text->SetInput("Penumbra");
  text->SetPosition(20, 20);
  text->GetTextProperty()->SetFontSize(40);
  text->GetTextProperty()->SetColor(1.0, 1.0, 0.2);
  stage.Renderer->AddViewProp(text);
}

void AddScalarBar(Stage& stage)
{
  vtkNew<vtkLookupTable> table;
  table->SetRange(-3.0, 8.0);
  table->Build();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetTitle("height");
  bar->SetNumberOfLabels(5);
  stage.Renderer->AddViewProp(bar);
}

void AddCubeAxes(Stage& stage)
{
  vtkNew<vtkCubeAxesActor> axes;
  axes->SetBounds(-1.0, 1.0, -1.0, 1.0, -0.4, 0.4);
  axes->SetCamera(stage.Renderer->GetActiveCamera());
  axes->SetXTitle("X");
  axes->DrawXGridlinesOn();
  axes->DrawYGridlinesOn();
  stage.Renderer->AddViewProp(axes);
  Stage::LookAround(stage.Renderer);
}

void AddShape2D(Stage& stage)
{
  vtkNew<vtkRegularPolygonSource> polygon;
  polygon->SetCenter(160.0, 120.0, 0.0);
  polygon->SetRadius(40.0);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(polygon->GetOutputPort());
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.2, 0.9);
  actor->GetProperty()->SetOpacity(0.6);
  stage.Renderer->AddViewProp(actor);
}

void AddImage2D(Stage& stage)
{
  vtkNew<vtkImageMapper> mapper;
  mapper->SetInputData(Checkerboard());
  mapper->SetColorWindow(255.0);
  mapper->SetColorLevel(127.0);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(200, 100);
  stage.Renderer->AddViewProp(actor);
}

void AddAxes(Stage& stage)
{
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(1.2, 1.2, 1.2);
  stage.Renderer->AddActor(axes);
  Stage::LookAround(stage.Renderer);
}

void AddBillboard(Stage& stage)
{
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput("here");
  text->SetPosition(0.5, 0.2, 0.3);
  text->GetTextProperty()->SetFontSize(30);
  stage.Renderer->AddActor(text);
}

// The torus with another prop.
template <void (*AddOther)(Stage&)>
void WithTorus(Stage& stage)
{
  AddTorus(stage, 0.4);
  AddOther(stage);
}
}

ParityCases AnnotationCases()
{
  return {
    { "text", WithTorus<AddText> },
    { "scalar bar", WithTorus<AddScalarBar> },
    { "cube axes", WithTorus<AddCubeAxes> },
    { "2-D shape", WithTorus<AddShape2D> },
    { "2-D image", WithTorus<AddImage2D> },
    { "axes", WithTorus<AddAxes> },
    { "billboard text", WithTorus<AddBillboard> },
    { "every annotation",
      [](Stage& s) {
        AddTorus(s, 0.4)->GetProperty()->SetOpacity(0.8);
        s.Add(Ball());
        AddText(s);
        AddScalarBar(s);
        AddShape2D(s);
        AddCubeAxes(s);
      } },
  };
}
}
