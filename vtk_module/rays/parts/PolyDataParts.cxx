// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/parts/PolyDataParts.h"

#include "base/Parallel.h"
#include "rays/parts/SurfaceMaterial.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>

namespace penumbra
{
namespace
{
/// Calls add(a, b, c, cell, hidden) for each triangle. cell: index in cell data; hidden: a bit
/// for each edge that is inside its cell.
template <typename Add>
void ForEachTriangle(vtkPolyData* data, const Add& add)
{
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  const vtkIdType points = data->GetNumberOfPoints();
  const auto inside = [points](vtkIdType id) { return id >= 0 && id < points; };
  for (const bool strips : { false, true })
  {
    vtkCellArray* cells = strips ? data->GetStrips() : data->GetPolys();
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(size, ids);
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        // Every other triangle of a strip has the opposite winding.
        const vtkIdType a = strips ? ids[i - 1] : ids[0];
        const vtkIdType b = strips && i % 2 == 0 ? ids[i + 1] : ids[i];
        const vtkIdType c = strips && i % 2 == 0 ? ids[i] : ids[i + 1];
        const std::uint32_t hidden = strips ? 0u : (i > 1 ? 1u : 0u) | (i + 2 < size ? 4u : 0u);
        if (inside(a) && inside(b) && inside(c))
        {
          add(a, b, c, cell, hidden);
        }
      }
      ++cell;
    }
  }
}

// Zero and NaN count as no normal.
std::uint32_t PackNormal(glm::vec3 n)
{
  const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  if (!(sum > 0.0f) || std::isinf(sum))
  {
    return GI_RAY_NO_NORMAL;
  }
  glm::vec2 p = glm::vec2(n) / sum;
  if (n.z < 0.0f)
  {
    const glm::vec2 side(p.x >= 0.0f ? 1.0f : -1.0f, p.y >= 0.0f ? 1.0f : -1.0f);
    p = (1.0f - glm::abs(glm::vec2(p.y, p.x))) * side;
  }
  const std::uint32_t packed = glm::packUnorm2x16(p * 0.5f + 0.5f);
  // All corners of the octahedral map are the same direction.
  return packed == GI_RAY_NO_NORMAL ? 0xffffffffu : packed;
}

/// Key of the transformation of texture coordinates. Its name changed after VTK 9.3, and the old one is deprecated.
template <typename Prop>
auto TextureTransformKey(int) -> decltype(Prop::GENERAL_TEXTURE_TRANSFORM())
{
  return Prop::GENERAL_TEXTURE_TRANSFORM();
}
template <typename Prop>
auto TextureTransformKey(long) -> decltype(Prop::GeneralTextureTransform())
{
  return Prop::GeneralTextureTransform();
}

/// Transformation of texture coordinates by an actor's keys; the identity if there is no such key.
glm::dmat4 TextureTransform(vtkActor* actor)
{
  glm::dmat4 transform(1.0);
  vtkInformation* keys = actor->GetPropertyKeys();
  const auto key = TextureTransformKey<vtkProp>(0);
  if (keys && keys->Has(key))
  {
    const double* values = keys->Get(key);
    for (int i = 0; i < 16; ++i)
    {
      transform[i % 4][i / 4] = values[i];
    }
  }
  return transform;
}

RayAttributes MakeAttributes(
  vtkPolyData* data, const ScalarColors& colors, const glm::dmat4& textureTransform)
{
  RayAttributes attributes;
  vtkDataArray* flags = data->GetPointData()->GetAttribute(vtkDataSetAttributes::EDGEFLAG);
  const auto flagged = [flags](
                         vtkIdType id) { return !flags || flags->GetComponent(id, 0) != 0.0; };
  ForEachTriangle(
    data, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell, std::uint32_t hidden) {
      hidden |= (flagged(a) ? 0u : 1u) | (flagged(b) ? 0u : 2u) | (flagged(c) ? 0u : 4u);
      shared::RayAttribute entry;
      entry.Points[0] = static_cast<std::uint32_t>(a) | hidden << GI_RAY_EDGE_SHIFT;
      entry.Points[1] = static_cast<std::uint32_t>(b);
      entry.Points[2] = static_cast<std::uint32_t>(c);
      entry.Color =
        colors.Association == 0 ? 0xffffffffu : colors.At(colors.Association == 1 ? cell : 0);
      attributes.Primitives.push_back(entry);
    });
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  vtkDataArray* coordinates = colors.Places.Get();
  coordinates = coordinates ? coordinates : data->GetPointData()->GetTCoords();
  const vtkIdType count = data->GetNumberOfPoints();
  attributes.Points.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    shared::RayPoint& point = attributes.Points[static_cast<std::size_t>(i)];
    double n[3] = { 0.0, 0.0, 1.0 };
    if (normals)
    {
      normals->GetTuple(i, n);
    }
    point.Normal = PackNormal(glm::vec3(n[0], n[1], n[2]));
    point.Color = colors.Association == 0 ? colors.At(i) : 0xffffffffu;
    if (coordinates && i < coordinates->GetNumberOfTuples())
    {
      const bool line = coordinates->GetNumberOfComponents() < 2;
      const glm::dvec4 transformed = textureTransform *
        glm::dvec4(
          coordinates->GetComponent(i, 0), line ? 0.0 : coordinates->GetComponent(i, 1), 0.0, 1.0);
      point.TextureU = static_cast<float>(transformed.x / transformed.w);
      point.TextureV = line ? 0.0f : static_cast<float>(transformed.y / transformed.w);
    }
  }
  // Only points of surfaces count: filters give unused points a normal of zero.
  constexpr std::uint32_t index = (1u << GI_RAY_EDGE_SHIFT) - 1u;
  for (const shared::RayAttribute& entry : attributes.Primitives)
  {
    for (const std::uint32_t corner : entry.Points)
    {
      attributes.LacksNormals |= attributes.Points[corner & index].Normal == GI_RAY_NO_NORMAL;
    }
  }
  return attributes;
}
}

RayGeometry PolyDataGeometry(vtkPolyData* data)
{
  RayGeometry geometry;
  std::vector<glm::dvec3> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkDataArray* coordinates = data->GetPoints() ? data->GetPoints()->GetData() : nullptr;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    coordinates->GetTuple(static_cast<vtkIdType>(i), &points[i][0]);
  }
  geometry.SetPoints(points);
  ForEachTriangle(data, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType, std::uint32_t) {
    geometry.Triangles.emplace_back(a, b, c);
  });
  return geometry;
}

RayPart PolyDataPart(
  const GatherContext& context, vtkMapper* mapper, vtkPolyData* data, const ScalarColors& colors)
{
  RayPart part;
  part.Prop = context.Actor;
  part.ToWorld = context.ToWorld;
  part.MeshKey = GatherKey(data);
  part.CellTime = std::max(data->GetPolys()->GetMTime(), data->GetStrips()->GetMTime());
  part.PointTime = data->GetPoints() ? data->GetPoints()->GetMTime() : 0;
  part.MakeGeometry = [data] { return PolyDataGeometry(data); };
  part.AttributeKey = GatherKey(data, mapper);
  part.AttributeTime = std::max({ data->GetMTime(), colors.Time, part.CellTime });
  const glm::dmat4 textureTransform = TextureTransform(context.Actor);
  if (textureTransform != glm::dmat4(1.0))
  {
    part.AttributeKey ^= GatherKey(nullptr, context.Actor);
    part.AttributeTime = std::max(part.AttributeTime, context.Actor->GetPropertyKeys()->GetMTime());
  }
  part.MakeAttributes = [data, colors, textureTransform] {
    return MakeAttributes(data, colors, textureTransform);
  };
  part.Clip = ClippingPlanes(mapper);

  vtkProperty* property = context.Actor->GetProperty();
  if (colors.Places || data->GetPointData()->GetTCoords())
  {
    part.Pictures = PropertyPictures(context.Actor);
    part.Pictures[ColorPicture] = colors.Table;
  }
  int extra = 0;
  const bool flat = property->GetInterpolation() == VTK_FLAT;
  extra |= !flat && data->GetPointData()->GetNormals() ? GI_SURFACE_SMOOTH : 0;
  extra |= data->GetPointData()->GetTangents() ? GI_SURFACE_TANGENTS : 0;
  if (colors.Array && !colors.Table)
  {
    extra |= colors.Association == 0 ? GI_SURFACE_POINT_COLORS : GI_SURFACE_CELL_COLORS;
    extra |= colors.Partly ? GI_SURFACE_PARTLY : 0;
  }
  part.Surface = MakeRaySurface(property);
  part.Surface.Where.z |= extra;
  if (vtkProperty* back = context.Actor->GetBackfaceProperty())
  {
    part.HasBack = true;
    part.Back = MakeRaySurface(back);
    part.Back.Where.z |= extra;
  }
  return part;
}
}
