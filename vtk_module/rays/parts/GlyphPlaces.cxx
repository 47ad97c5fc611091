// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/parts/GlyphPlaces.h"

#include "base/Matrices.h"
#include "base/Parallel.h"
#include "rays/parts/ScalarColors.h"

#include "vtkBitArray.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkQuaternion.h"
#include "vtkUnsignedCharArray.h"

namespace penumbra
{
namespace
{
/// Access to the protected methods that find the arrays.
struct GlyphMapperAccess : public vtkGlyph3DMapper
{
  static vtkDataArray* Mask(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphMapperAccess::GetMaskArray))(data);
  }
  static vtkDataArray* Index(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphMapperAccess::GetSourceIndexArray))(data);
  }
  static vtkDataArray* Orientation(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphMapperAccess::GetOrientationArray))(data);
  }
  static vtkDataArray* Scale(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphMapperAccess::GetScaleArray))(data);
  }
};

glm::dmat3 Rotation(int mode, const double* o)
{
  vtkQuaterniond q; // identity
  if (mode == vtkGlyph3DMapper::QUATERNION)
  {
    q.Set(o[0], o[1], o[2], o[3]);
  }
  else if (mode == vtkGlyph3DMapper::ROTATION)
  {
    const auto about = [o](int axis) {
      const double half = 0.5 * vtkMath::RadiansFromDegrees(o[axis]);
      double turn[4] = { std::cos(half), 0.0, 0.0, 0.0 };
      turn[axis + 1] = std::sin(half);
      return vtkQuaterniond(turn);
    };
    q = about(2) * about(0) * about(1);
  }
  else if (o[1] == 0.0 && o[2] == 0.0)
  {
    if (o[0] < 0.0)
    {
      q.Set(0.0, 0.0, 1.0, 0.0);
    }
  }
  else
  {
    // A half turn about the bisector of the x axis and the direction.
    const glm::dvec3 direction = ToVec3(o);
    const glm::dvec3 middle =
      glm::normalize(direction + glm::dvec3(glm::length(direction), 0.0, 0.0));
    q.Set(0.0, middle.x, middle.y, middle.z);
  }
  double rows[3][3];
  q.ToMatrix3x3(rows);
  glm::dmat3 result;
  for (int i = 0; i < 9; ++i)
  {
    result[i % 3][i / 3] = rows[i / 3][i % 3];
  }
  return result;
}

/// Reads the glyphs of a mapper.
class GlyphReader
{
public:
  GlyphReader(vtkGlyph3DMapper* mapper, vtkDataSet* points, std::size_t shapes)
    : Mapper(mapper)
    , Points(points)
    , ShapeCount(shapes)
    , Mask(vtkBitArray::SafeDownCast(GlyphMapperAccess::Mask(mapper, points)))
    , Index(GlyphMapperAccess::Index(mapper, points))
    , Orientation(GlyphMapperAccess::Orientation(mapper, points))
    , Scale(GlyphMapperAccess::Scale(mapper, points))
  {
    const int mode = mapper->GetOrientationMode();
    const int components = mode == vtkGlyph3DMapper::QUATERNION ? 4 : 3;
    this->Valid = (!this->Mask || this->Mask->GetNumberOfComponents() == 1) &&
      (!this->Orientation || this->Orientation->GetNumberOfComponents() == components);
    for (vtkAbstractArray* array : std::initializer_list<vtkAbstractArray*>{
           this->Mask, this->Index, this->Orientation, this->Scale })
    {
      this->Valid &= !array || array->GetNumberOfTuples() >= points->GetNumberOfPoints();
    }
  }

  /// Whether the arrays can be used. VTK draws nothing if an array has the wrong number of components. Here arrays that
  /// are too short are rejected too.
  bool IsValid() const { return this->Valid; }

  /// Index of the shape at a point, -1 for none.
  int ShapeOf(vtkIdType i) const
  {
    if (this->Mask && this->Mask->GetValue(i) == 0)
    {
      return -1;
    }
    if (!this->Index || this->ShapeCount == 0)
    {
      return this->ShapeCount > 0 ? 0 : -1;
    }
    const double last = static_cast<double>(this->ShapeCount) - 1.0;
    return static_cast<int>(std::min(std::max(Norm(this->Index, i), 0.0), last));
  }

  RayPlace At(vtkIdType i) const
  {
    RayPlace place;
    double x[3];
    this->Points->GetPoint(i, x);
    place.At = ToVec3(x);
    glm::dmat3 turn(1.0);
    if (this->Orientation)
    {
      double o[4] = { 0.0, 0.0, 0.0, 0.0 };
      for (int c = 0; c < this->Orientation->GetNumberOfComponents(); ++c)
      {
        o[c] = this->Orientation->GetComponent(i, c);
      }
      turn = Rotation(this->Mapper->GetOrientationMode(), o);
    }
    if (this->Mapper->GetScaling())
    {
      const glm::dvec3 size = this->Size(i);
      for (int axis = 0; axis < 3; ++axis)
      {
        turn[axis] *= size[axis] == 0.0 ? 1e-10 : size[axis];
      }
    }
    place.Turn = glm::mat3(turn);
    return place;
  }

private:
  static double Norm(vtkDataArray* array, vtkIdType i)
  {
    double sum = 0.0;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double value = array->GetComponent(i, c);
      sum += value * value;
    }
    return std::sqrt(sum);
  }

  glm::dvec3 Size(vtkIdType i) const
  {
    glm::dvec3 size(1.0);
    const int mode = this->Mapper->GetScaleMode();
    if (this->Scale && mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
    {
      size = glm::dvec3(Norm(this->Scale, i));
    }
    else if (this->Scale && this->Scale->GetNumberOfComponents() == 3)
    {
      size = { this->Scale->GetComponent(i, 0), this->Scale->GetComponent(i, 1),
        this->Scale->GetComponent(i, 2) };
    }
    if (this->Scale && this->Mapper->GetClamping())
    {
      const double* range = this->Mapper->GetRange();
      const double width = range[1] - range[0];
      size =
        (glm::min(glm::max(size, range[0]), range[1]) - range[0]) / (width == 0.0 ? 1.0 : width);
    }
    return size * this->Mapper->GetScaleFactor();
  }

  vtkGlyph3DMapper* Mapper;
  vtkDataSet* Points;
  std::size_t ShapeCount;
  vtkBitArray* Mask;
  vtkDataArray* Index;
  vtkDataArray* Orientation;
  vtkDataArray* Scale;
  bool Valid = true;
};
}

const GlyphPlaces& PlaceGlyphs(GatherCache& cache, vtkGlyph3DMapper* mapper, vtkDataSet* points,
  std::size_t shapes, double opacity)
{
  auto& glyphs = cache.At<GlyphPlaces>(mapper, points);
  const ScalarColors& colors = MapScalarColors(cache, mapper, points, opacity);
  const vtkMTimeType time = std::max({ mapper->GetMTime(), points->GetMTime(), colors.Time });
  if (glyphs.SourceTime == time && glyphs.OfShape.size() == shapes)
  {
    return glyphs;
  }
  glyphs.SourceTime = time;
  glyphs.Colored = colors.Array != nullptr;
  glyphs.Partly = colors.Partly;
  const GlyphReader reader(mapper, points, shapes);
  const vtkIdType count = reader.IsValid() ? points->GetNumberOfPoints() : 0;

  // First find the shape of each point, then its transformation. The latter is slower and runs in parallel.
  std::vector<std::vector<vtkIdType>> shown(shapes);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int shape = reader.ShapeOf(i);
    if (shape >= 0)
    {
      shown[static_cast<std::size_t>(shape)].push_back(i);
    }
  }
  glyphs.OfShape.clear();
  for (const std::vector<vtkIdType>& ids : shown)
  {
    auto places = std::make_shared<std::vector<RayPlace>>(ids.size());
    ParallelFor(ids.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        (*places)[i] = reader.At(ids[i]);
        (*places)[i].Color = colors.At(ids[i]);
      }
    });
    glyphs.OfShape.push_back(places);
  }
  return glyphs;
}
}
