// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/parts/ScalarColors.h"

#include "rays/parts/GatherCache.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPolyDataMapper.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

namespace penumbra
{
namespace
{
/// A mapper that gives access to the protected results of mapping scalars.
class ScalarMapper : public vtkPolyDataMapper
{
public:
  static ScalarMapper* New() { return new ScalarMapper; }
  vtkImageData* Table() { return this->ColorTextureMap; }
  vtkFloatArray* Places() { return this->ColorCoordinates; }

protected:
  ScalarMapper() = default;
};

bool IsPartly(vtkUnsignedCharArray* colors)
{
  const int components = colors->GetNumberOfComponents();
  if (components != 2 && components != 4)
  {
    return false;
  }
  const unsigned char* values = colors->GetPointer(0);
  for (vtkIdType i = components - 1; i < colors->GetNumberOfValues(); i += components)
  {
    if (values[i] < 255)
    {
      return true;
    }
  }
  return false;
}

vtkMTimeType SourceTime(vtkMapper* mapper, vtkDataSet* data)
{
  vtkMTimeType time = std::max(mapper->GetMTime(), data->GetMTime());
  int association = 0;
  auto* scalars =
    vtkDataArray::SafeDownCast(vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), association));
  if (scalars && scalars->GetLookupTable())
  {
    time = std::max(time, scalars->GetLookupTable()->GetMTime());
  }
  return time;
}
}

bool ScalarColors::Has(vtkIdType i) const
{
  return this->Array && i >= 0 && i < this->Array->GetNumberOfTuples();
}

std::uint32_t ScalarColors::At(vtkIdType i) const
{
  unsigned char rgba[4] = { 255, 255, 255, 255 };
  if (this->Has(i))
  {
    const int components = this->Array->GetNumberOfComponents();
    const unsigned char* color = this->Array->GetPointer(i * components);
    if (components < 3)
    {
      // Luminance, and alpha if there are two components.
      rgba[0] = rgba[1] = rgba[2] = color[0];
      rgba[3] = components == 2 ? color[1] : 255;
    }
    else
    {
      std::copy(color, color + std::min(4, components), rgba);
    }
  }
  return rgba[0] | rgba[1] << 8 | rgba[2] << 16 | static_cast<std::uint32_t>(rgba[3]) << 24;
}

const ScalarColors& MapScalarColors(
  GatherCache& cache, vtkMapper* mapper, vtkDataSet* data, double alpha)
{
  auto& colors = cache.At<ScalarColors>(mapper, data);
  const vtkMTimeType time = SourceTime(mapper, data);
  if (colors.SourceTime == time && colors.Alpha == alpha)
  {
    return colors;
  }
  colors.Alpha = alpha;
  vtkNew<ScalarMapper> scalarMapper;
  scalarMapper->vtkMapper::ShallowCopy(mapper);
  colors.Array = scalarMapper->MapScalars(data, alpha, colors.Association);
  colors.Partly = colors.Array && IsPartly(colors.Array);
  colors.Table = nullptr;
  colors.Places = nullptr;
  if (scalarMapper->Table() && scalarMapper->Places())
  {
    colors.Table = vtkSmartPointer<vtkTexture>::New();
    colors.Table->SetInputData(scalarMapper->Table());
    colors.Table->RepeatOff();
    colors.Places = scalarMapper->Places();
  }
  vtkTimeStamp timeStamp;
  timeStamp.Modified();
  colors.Time = timeStamp;
  // Mapping may set the range of a lookup table, which counts as a change of the mapper.
  colors.SourceTime = SourceTime(mapper, data);
  return colors;
}
}
