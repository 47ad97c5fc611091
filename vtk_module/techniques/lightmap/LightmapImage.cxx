// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/lightmap/LightmapImage.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <stdexcept>

namespace penumbra::lightmap_image
{
namespace
{
const BakeArrays Sealed = { { BakeFormat, BakedSceneText, Settings, Made },
  { Points, Normals, Places, Triangles, Tiles },
  { Layers[0].Name, Layers[1].Name, Layers[2].Name, Layers[3].Name, First } };

void AddCopy(vtkFieldData* to, const char* name, vtkDataArray* from)
{
  if (from)
  {
    auto copy = vtk::TakeSmartPointer(from->NewInstance());
    copy->DeepCopy(from);
    copy->SetName(name);
    to->AddArray(copy);
  }
}

void AddTriangles(vtkFieldData* to, vtkCellArray* cells)
{
  vtkNew<vtkIntArray> triangles;
  triangles->SetName(Triangles);
  triangles->SetNumberOfComponents(3);
  triangles->Allocate(3 * cells->GetNumberOfCells());
  auto each = vtk::TakeSmartPointer(cells->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    each->GetCurrentCell(size, ids);
    if (size != 3)
    {
      throw std::invalid_argument("its surfaces are not triangles of its points");
    }
    triangles->InsertNextTuple3(
      static_cast<double>(ids[0]), static_cast<double>(ids[1]), static_cast<double>(ids[2]));
  }
  to->AddArray(triangles);
}

/// Splits the light's components into layers.
void AddLight(vtkImageData* light, vtkPointData* to)
{
  vtkDataArray* scalars = light->GetPointData()->GetScalars();
  const int components = scalars ? scalars->GetNumberOfComponents() : 0;
  const bool directional = components == 12 || components == 24;
  if (components != 3 && components != 6 && !directional)
  {
    throw std::invalid_argument(
      "its light is not a picture with 3 or 12 components, or twice as many");
  }
  int first = 0;
  for (const Layer& layer : Layers)
  {
    if (first == components || (layer.Components == 9 && !directional))
    {
      continue;
    }
    vtkNew<vtkFloatArray> part;
    part->SetName(layer.Name);
    part->SetNumberOfComponents(layer.Components);
    part->SetNumberOfTuples(scalars->GetNumberOfTuples());
    for (int c = 0; c < layer.Components; ++c)
    {
      part->CopyComponent(c, scalars, first + c);
    }
    first += layer.Components;
    to->AddArray(part);
  }
  to->SetActiveScalars(Layers[0].Name);
}
}

void Join(vtkPolyData* surfaces, vtkImageData* light, vtkImageData* bake)
{
  if (!surfaces || !light)
  {
    throw std::invalid_argument("it needs both surfaces and light");
  }
  bake->Initialize();
  bake->SetDimensions(light->GetDimensions());
  AddLight(light, bake->GetPointData());
  vtkFieldData* fields = bake->GetFieldData();
  AddCopy(fields, Points, surfaces->GetPoints() ? surfaces->GetPoints()->GetData() : nullptr);
  AddCopy(fields, Normals, surfaces->GetPointData()->GetNormals());
  AddCopy(fields, Places, surfaces->GetPointData()->GetTCoords());
  AddTriangles(fields, surfaces->GetPolys());
  SetText(fields, BakedSceneText, GetText(surfaces->GetFieldData(), BakedSceneText));
  Seal(bake);
}

void Seal(vtkImageData* bake)
{
  SetText(bake->GetFieldData(), BakeFormat, Format);
  SealBake(bake, Sealed);
}

void RequireWhole(vtkImageData* bake)
{
  const std::string format = GetText(bake->GetFieldData(), BakeFormat);
  if (format != Format)
  {
    throw std::invalid_argument(format.empty()
        ? "it is no lightmap: it lacks the text 'format'"
        : "it is of the format '" + format + "', and this version reads '" + Format + "'");
  }
  RequireSealed(bake, Sealed);
}
}
