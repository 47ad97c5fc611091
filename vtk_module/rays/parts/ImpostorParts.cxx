// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers that draw a sphere or a stick at each point as an impostor. Rays get exact primitives.
#include "rays/parts/PolyDataParts.h"
#include "rays/parts/SurfaceMaterial.h"

#include "base/Matrices.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cstring>

namespace penumbra
{
namespace
{
// Access to the names of the arrays, which are protected.
struct SphereArrays : public vtkOpenGLSphereMapper
{
  static const char* Scale(vtkMapper* mapper)
  {
    return static_cast<vtkOpenGLSphereMapper*>(mapper)->*(&SphereArrays::ScaleArray);
  }
};
struct StickArrays : public vtkOpenGLStickMapper
{
  static const char* Scale(vtkMapper* mapper)
  {
    return static_cast<vtkOpenGLStickMapper*>(mapper)->*(&StickArrays::ScaleArray);
  }
  static const char* Orientation(vtkMapper* mapper)
  {
    return static_cast<vtkOpenGLStickMapper*>(mapper)->*(&StickArrays::OrientationArray);
  }
};

vtkDataArray* Named(vtkPolyData* data, const char* name, int components)
{
  vtkDataArray* array = name ? data->GetPointData()->GetArray(name) : nullptr;
  const bool usable = array && array->GetNumberOfComponents() >= components &&
    array->GetNumberOfTuples() >= data->GetNumberOfPoints();
  return usable ? array : nullptr;
}

/// The impostors of a mapper: which points are drawn, and where. VTK transforms the points
/// with the actor but does not scale radii or lengths, and it clips an impostor as a whole
/// by its point.
class Impostors
{
public:
  Impostors(const GatherContext& context, vtkMapper* mapper, vtkPolyData* data)
    : Data(data)
    , ToWorld(context.ToWorld)
    , Clip(ClippingPlanes(mapper))
  {
    // A rigid transformation is left to the instance, so that moving the actor is cheap.
    const glm::dmat3 turn(context.ToWorld);
    const glm::dmat3 unit = glm::transpose(turn) * turn - glm::dmat3(1.0);
    for (int i = 0; i < 9; ++i)
    {
      this->Rigid = this->Rigid && std::abs(unit[i / 3][i % 3]) < 1e-6;
    }
  }

  bool IsRigid() const { return this->Rigid; }
  bool IsClipped() const { return !this->Clip.empty(); }
  const glm::dmat4& Placement() const { return this->ToWorld; }
  vtkPolyData* Input() const { return this->Data; }

  bool Shows(vtkIdType i) const
  {
    const glm::dvec4 at = this->ToWorld * glm::dvec4(this->Point(i), 1.0);
    return std::none_of(this->Clip.begin(), this->Clip.end(),
      [&at](const glm::dvec4& plane) { return glm::dot(plane, at) < 0.0; });
  }
  glm::dvec3 Point(vtkIdType i) const
  {
    double p[3];
    this->Data->GetPoint(i, p);
    return ToVec3(p);
  }
  /// A point in mesh coordinates.
  glm::dvec3 Place(const glm::dvec3& point) const
  {
    return this->Rigid ? point : glm::dvec3(this->ToWorld * glm::dvec4(point, 1.0));
  }
  glm::dvec3 Turn(const glm::dvec3& direction) const
  {
    const glm::dvec3 transformed =
      this->Rigid ? direction : glm::transpose(glm::inverse(glm::dmat3(this->ToWorld))) * direction;
    const double length = glm::length(transformed);
    return length > 0.0 ? transformed / length : glm::dvec3(0.0);
  }

private:
  vtkPolyData* Data;
  glm::dmat4 ToWorld;
  std::vector<glm::dvec4> Clip;
  bool Rigid = true;
};

/// Middle of the points, near which floats keep their precision.
glm::dvec3 CenterOf(const std::vector<glm::dvec3>& points)
{
  RayGeometry geometry;
  geometry.SetPoints(points);
  return geometry.Origin;
}

RayGeometry SphereGeometry(const Impostors& impostors, vtkDataArray* scale, float radius)
{
  std::vector<glm::dvec3> centers;
  RayGeometry geometry;
  for (vtkIdType i = 0; i < impostors.Input()->GetNumberOfPoints(); ++i)
  {
    // A clipped sphere keeps its index but has no size.
    const int components = scale ? scale->GetNumberOfComponents() : 1;
    const double size = scale ? scale->GetComponent(i / components, i % components) : radius;
    centers.push_back(impostors.Place(impostors.Point(i)));
    geometry.Spheres.push_back(
      { glm::vec3(0.0f), impostors.Shows(i) ? static_cast<float>(size) : 0.0f });
  }
  geometry.Origin = CenterOf(centers);
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    geometry.Spheres[i].Center = glm::vec3(centers[i] - geometry.Origin);
  }
  return geometry;
}

RayGeometry StickGeometry(
  const Impostors& impostors, vtkDataArray* scale, vtkDataArray* orientation)
{
  std::vector<glm::dvec3> centers;
  for (vtkIdType i = 0; i < impostors.Input()->GetNumberOfPoints(); ++i)
  {
    centers.push_back(impostors.Place(impostors.Point(i)));
  }
  RayGeometry geometry;
  geometry.Origin = CenterOf(centers);
  for (vtkIdType i = 0; i < impostors.Input()->GetNumberOfPoints(); ++i)
  {
    const glm::dvec3 along(orientation->GetComponent(i, 0), orientation->GetComponent(i, 1),
      orientation->GetComponent(i, 2));
    const double half = 0.5 * std::abs(scale->GetComponent(i, 0)) * glm::length(along);
    const glm::dvec3 arm = half * impostors.Turn(along);
    const glm::dvec3 center = centers[static_cast<std::size_t>(i)] - geometry.Origin;
    const double radius = impostors.Shows(i) ? scale->GetComponent(i, 1) : 0.0;
    geometry.Cylinders.push_back(
      { glm::vec3(center - arm), glm::vec3(center + arm), static_cast<float>(radius), true });
  }
  return geometry;
}

RayAttributes ImpostorAttributes(vtkIdType count, const ScalarColors& colors)
{
  RayAttributes attributes;
  attributes.Primitives.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    attributes.Primitives[static_cast<std::size_t>(i)] = { { 0, 0, 0 }, colors.At(i) };
  }
  return attributes;
}

/// Hash of a transformation, so that dependent data is rebuilt when it changes.
std::uint64_t PlaceKey(const glm::dmat4& place)
{
  std::uint64_t key = 0xcbf29ce484222325ull; // Fowler, Noll, Vo
  for (int i = 0; i < 16; ++i)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &place[i / 4][i % 4], sizeof(bits));
    key = (key ^ bits) * 0x100000001b3ull;
    key ^= key >> 29;
  }
  return key;
}

RayPart ImpostorPart(const GatherContext& context, vtkMapper* mapper, const Impostors& impostors)
{
  vtkPolyData* data = impostors.Input();
  const ScalarColors& colors = MapScalarColors(context.Cache, mapper, data);
  const bool transformsPoints = !impostors.IsRigid() || impostors.IsClipped();
  RayPart part;
  part.ToWorld = impostors.IsRigid() ? context.ToWorld : glm::dmat4(1.0);
  part.MeshKey = GatherKey(data, mapper) ^
    (transformsPoints ? PlaceKey(impostors.Placement()) : std::uint64_t(0));
  vtkMTimeType planes = 0;
  if (vtkPlaneCollection* collection = mapper->GetClippingPlanes())
  {
    for (int i = 0; i < collection->GetNumberOfItems(); ++i)
    {
      planes = std::max(planes, collection->GetItem(i)->GetMTime());
    }
    planes = std::max(planes, collection->GetMTime());
  }
  part.CellTime = std::max({ data->GetMTime(), mapper->GetMTime(), planes });
  part.AttributeKey = GatherKey(data, mapper);
  part.AttributeTime = std::max(data->GetMTime(), colors.Time);
  const vtkIdType count = data->GetNumberOfPoints();
  part.MakeAttributes = [count, colors] { return ImpostorAttributes(count, colors); };

  vtkProperty* property = context.Actor->GetProperty();
  part.Surface = MakeRaySurface(property);
  if (colors.Array)
  {
    part.Surface.Where.z |= GI_SURFACE_CELL_COLORS | (colors.Partly ? GI_SURFACE_PARTLY : 0);
  }
  else
  {
    // VTK gives the points the property's colour in bytes, rounded down, and thus applies the opacity a
    // second time.
    const glm::dvec3 color = glm::floor(ToVec3(property->GetColor()) * 255.0) / 255.0;
    Recolor(part.Surface, property, glm::vec3(color));
    Fade(part.Surface, static_cast<float>(std::floor(property->GetOpacity() * 255.0) / 255.0));
  }
  return part;
}
}

bool GatherSpheres(vtkMapper* mapper, const GatherContext& context)
{
  UpdateInput(mapper);
  auto* source = static_cast<vtkOpenGLSphereMapper*>(mapper);
  if (vtkPolyData* data = source->GetInput())
  {
    const Impostors impostors(context, mapper, data);
    RayPart part = ImpostorPart(context, mapper, impostors);
    const char* name = SphereArrays::Scale(mapper);
    vtkDataArray* scale = Named(data, name, 1);
    const float radius = source->GetRadius();
    part.MakeGeometry = [=] { return SphereGeometry(impostors, scale, radius); };
    context.Parts.push_back(std::move(part));
  }
  return true;
}

bool GatherSticks(vtkMapper* mapper, const GatherContext& context)
{
  UpdateInput(mapper);
  vtkPolyData* data = static_cast<vtkOpenGLStickMapper*>(mapper)->GetInput();
  vtkDataArray* scale = data ? Named(data, StickArrays::Scale(mapper), 2) : nullptr;
  vtkDataArray* orientation = data ? Named(data, StickArrays::Orientation(mapper), 3) : nullptr;
  if (scale && orientation)
  {
    const Impostors impostors(context, mapper, data);
    RayPart part = ImpostorPart(context, mapper, impostors);
    part.MakeGeometry = [=] { return StickGeometry(impostors, scale, orientation); };
    context.Parts.push_back(std::move(part));
  }
  return true;
}
}
