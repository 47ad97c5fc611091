// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkSphereSource.h"

#include <cctype>
#include <ostream>

namespace penumbra_test
{
std::string ParityCase::Id() const
{
  std::string id = this->Name;
  std::replace_if(
    id.begin(), id.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return id;
}

void PrintTo(const ParityCase& row, std::ostream* os)
{
  *os << row.Name;
}

ParityCases AllCases()
{
  ParityCases all;
  for (const auto& group : { SurfaceCases(), MaterialCases(), MapperCases(), LightCases(),
         ViewCases(), LayerCases(), AnnotationCases(), CustomCases() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

vtkSmartPointer<vtkPolyData> Ball(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> Torus()
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(0.6);
  torus->SetCrossSectionRadius(0.25);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(40);
  source->SetVResolution(20);
  source->GenerateTextureCoordinatesOn();
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkImageData> Checkerboard(int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  constexpr int size = 64;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      const bool dark = ((x / 8) + (y / 8)) % 2 != 0;
      const int values[4] = { dark ? 60 : 220, 80 + 2 * x, 250 - 3 * y, dark ? 255 : 140 };
      for (int c = 0; c < components; ++c)
      {
        pixel[c] = static_cast<unsigned char>(values[c]);
      }
    }
  }
  return image;
}

vtkActor* AddTorus(Stage& stage, double specular, double specularPower)
{
  vtkActor* actor = stage.Add(Torus());
  actor->GetProperty()->SetSpecular(specular);
  actor->GetProperty()->SetSpecularPower(specularPower);
  Stage::LookAround(stage.Renderer);
  return actor;
}

vtkActor* AddShinyTorus(Stage& stage)
{
  return AddTorus(stage, 0.5, 20.0);
}
}
