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
// The surface of an actor whose mapper draws its points by their numbers.
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

std::vector<float> Difference(const std::vector<double>& then, const std::vector<double>& now)
{
  std::vector<float> way(now.size());
  std::transform(then.begin(), then.end(), now.begin(), way.begin(),
    [](double a, double b) { return static_cast<float>(a - b); });
  return way;
}
}

// Whether it is known how the points came to where they are. The way back goes to the GPU.
bool Deformations::Follow(Shape& shape, vtkDataArray* points, vtkIdType cells)
{
  const bool same = shape.Points == points;
  const bool alike = shape.Points && shape.Cells == cells &&
    shape.Points->GetNumberOfTuples() == points->GetNumberOfTuples();
  // An array that was changed since holds its old points no more, unless they were kept.
  const bool intact = alike && !same && shape.Points->GetMTime() <= shape.Time;
  shape.InPlace |= same;
  if (!intact && !(alike && same && !shape.Kept.empty()))
  {
    return false;
  }
  const std::vector<float> way = Difference(intact ? Copy(shape.Points) : shape.Kept, Copy(points));
  shape.Displacements.Upload(GL_TEXTURE_BUFFER, way.data(), way.size() * sizeof(float));
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
    shape.Moved = changed && Follow(shape, points, surface->GetNumberOfCells());
    any |= shape.Moved;
    if (changed)
    {
      shape.Points = points;
      shape.Time = time;
      shape.Cells = surface->GetNumberOfCells();
      shape.Kept = shape.InPlace ? Copy(points) : std::vector<double>();
    }
  }
  for (auto it = this->Shapes.begin(); it != this->Shapes.end();)
  {
    it = present.count(it->first) > 0 ? std::next(it) : this->Shapes.erase(it);
  }
  return any;
}

bool Deformations::Knows(vtkActor* actor) const
{
  const auto found = this->Shapes.find(actor);
  return found != this->Shapes.end() && found->second.Moved;
}

GLuint Deformations::TextureOf(vtkActor* actor) const
{
  return this->Knows(actor) ? this->Shapes.at(actor).Texture.Get() : 0;
}

GLuint Deformations::AnyTexture() const
{
  for (const auto& shape : this->Shapes)
  {
    if (shape.second.Texture)
    {
      return shape.second.Texture.Get();
    }
  }
  return 0;
}
}
