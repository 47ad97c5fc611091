// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/Deformations.h"

#include "vtkActor.h"
#include "vtkDataArrayRange.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <set>

namespace penumbra
{
namespace
{
// Surface of an actor whose mapper draws its points by index.
vtkPolyData* SurfaceOf(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper || std::string(mapper->GetClassName()) != "vtkOpenGLPolyDataMapper")
  {
    return nullptr;
  }
  auto* surface = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return surface && surface->GetNumberOfPoints() > 0 ? surface : nullptr;
}

std::vector<double> Copy(vtkDataArray* points)
{
  const auto range = vtk::DataArrayValueRange<3>(points);
  return std::vector<double>(range.begin(), range.end());
}

std::vector<float> Difference(
  const std::vector<double>& previous, const std::vector<double>& current)
{
  std::vector<float> displacements(current.size());
  std::transform(previous.begin(), previous.end(), current.begin(), displacements.begin(),
    [](double a, double b) { return static_cast<float>(a - b); });
  return displacements;
}
}

// Uploads the displacements to the previous positions. Returns false if these are not known.
bool Deformations::UploadDisplacements(Shape& shape, vtkDataArray* points, vtkIdType cells)
{
  const bool sameArray = shape.Points == points;
  const bool sameTopology = shape.Points && shape.Cells == cells &&
    shape.Points->GetNumberOfTuples() == points->GetNumberOfTuples();
  // The previous positions are in the previous array, unless that was changed since, or in a copy.
  const bool previousIntact = sameTopology && !sameArray && shape.Points->GetMTime() <= shape.Time;
  shape.InPlace |= sameArray;
  if (!previousIntact && !(sameTopology && sameArray && !shape.PreviousPoints.empty()))
  {
    return false;
  }
  const std::vector<float> displacements =
    Difference(previousIntact ? Copy(shape.Points) : shape.PreviousPoints, Copy(points));
  shape.Displacements.Upload(
    GL_TEXTURE_BUFFER, displacements.data(), displacements.size() * sizeof(float));
  if (!shape.Texture)
  {
    GLuint name = 0;
    glGenTextures(1, &name);
    shape.Texture = Handle<gl::DeleteTexture>(name);
  }
  glBindTexture(GL_TEXTURE_BUFFER, shape.Texture.Get());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGB32F, shape.Displacements.Get());
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  return true;
}

bool Deformations::Update(const std::vector<vtkProp*>& props)
{
  std::set<vtkActor*> present;
  bool any = false;
  for (vtkProp* prop : props)
  {
    vtkPolyData* surface = SurfaceOf(prop);
    if (!surface)
    {
      continue;
    }
    auto* actor = static_cast<vtkActor*>(prop);
    present.insert(actor);
    Shape& shape = this->Shapes[actor];
    vtkDataArray* points = surface->GetPoints()->GetData();
    const vtkMTimeType time = std::max(surface->GetPoints()->GetMTime(), points->GetMTime());
    const bool changed = shape.Points != points || shape.Time != time;
    shape.Moved = changed && UploadDisplacements(shape, points, surface->GetNumberOfCells());
    any |= shape.Moved;
    if (changed)
    {
      shape.Points = points;
      shape.Time = time;
      shape.Cells = surface->GetNumberOfCells();
      shape.PreviousPoints = shape.InPlace ? Copy(points) : std::vector<double>();
    }
  }
  for (auto it = this->Shapes.begin(); it != this->Shapes.end();)
  {
    it = present.count(it->first) > 0 ? std::next(it) : this->Shapes.erase(it);
  }
  return any;
}

bool Deformations::HasDisplacements(vtkActor* actor) const
{
  const auto found = this->Shapes.find(actor);
  return found != this->Shapes.end() && found->second.Moved;
}

GLuint Deformations::TextureOf(vtkActor* actor) const
{
  return this->HasDisplacements(actor) ? this->Shapes.at(actor).Texture.Get() : 0;
}
}
