// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "techniques/sh_probes/ProbeField.h"

#include "bake/BakeImage.h"

#include "vtkGIProbeBaker.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace penumbra
{
namespace
{
constexpr const char* Format = "penumbra probes 1";
constexpr const char* FormatOfSeveral = "penumbra probes 2"; // grids
constexpr int GridNumbers = 9;                               // first place, spacing, counts
constexpr int MostProbes = vtkGIProbeBaker::MostProbes;
const BakeArrays Sealed = { { BakeFormat, BakedSceneText }, { "samples", "light scale", "grids" },
  { "light", "distance", "offset", "sight", "backs" } };

// Largest magnitude. Half floats store values relative to it, so that no unit of light overflows them.
double LargestOf(const std::vector<float>& values)
{
  double most = 0.0;
  for (const float value : values)
  {
    most = std::max(most, static_cast<double>(std::abs(value)));
  }
  return most > 0.0 ? most : 1.0;
}

void AddNumbers(vtkImageData* image, const char* name, const std::vector<float>& values,
  int components, double scale, bool compact)
{
  const auto count = static_cast<vtkIdType>(values.size());
  if (!compact)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(count / components);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    image->GetPointData()->AddArray(array);
    return;
  }
  vtkNew<vtkUnsignedShortArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count / components);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, glm::packHalf1x16(static_cast<float>(values[i] / scale)));
  }
  image->GetPointData()->AddArray(array);
}

template <typename Array>
Array* Find(vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  auto* array = Array::SafeDownCast(data->GetAbstractArray(name));
  return array && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == tuples
    ? array
    : nullptr;
}

[[noreturn]] void ThrowMissing(const char* name)
{
  throw std::invalid_argument(std::string("it lacks a valid array '") + name + "'");
}

void ReadNumbers(
  vtkImageData* image, const char* name, int components, double scale, std::vector<float>& values)
{
  const vtkIdType tuples = image->GetNumberOfPoints();
  values.resize(static_cast<std::size_t>(tuples) * components);
  vtkPointData* data = image->GetPointData();
  if (auto* floats = Find<vtkFloatArray>(data, name, components, tuples))
  {
    std::copy_n(floats->GetPointer(0), values.size(), values.begin());
  }
  else if (auto* halves = Find<vtkUnsignedShortArray>(data, name, components, tuples))
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = static_cast<float>(
        scale * glm::unpackHalf1x16(halves->GetValue(static_cast<vtkIdType>(i))));
    }
  }
  else
  {
    ThrowMissing(name);
  }
  for (const float value : values)
  {
    if (!std::isfinite(value))
    {
      throw std::invalid_argument(
        std::string("its array '") + name + "' has values that are not finite");
    }
  }
}

void RequireValid(const ProbeGrid& grid)
{
  const double points = static_cast<double>(grid.Counts.x) * grid.Counts.y * grid.Counts.z;
  if (glm::any(glm::lessThan(grid.Counts, glm::ivec3(2))) || points > MostProbes)
  {
    throw std::invalid_argument("its grid must have from 2 probes along each axis to " +
      std::to_string(MostProbes) + " in all");
  }
  const bool wide = grid.Spacing.x > 0.0 && grid.Spacing.y > 0.0 && grid.Spacing.z > 0.0;
  if (!wide || !std::isfinite(glm::length(grid.Spacing) + glm::length(grid.First)))
  {
    throw std::invalid_argument("its spacing must be positive and finite");
  }
}

ProbeGrid ReadGrid(vtkImageData* image)
{
  ProbeGrid grid;
  image->GetDimensions(&grid.Counts[0]);
  image->GetOrigin(&grid.First[0]);
  image->GetSpacing(&grid.Spacing[0]);
  RequireValid(grid);
  return grid;
}

void AddGrids(vtkFieldData* data, const ProbeGrids& grids)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("grids");
  array->SetNumberOfComponents(GridNumbers);
  for (int i = 0; i < grids.Count(); ++i)
  {
    const ProbeGrid& grid = grids.Get(i);
    const glm::dvec3 counts(grid.Counts);
    double numbers[GridNumbers];
    std::copy_n(&grid.First[0], 3, numbers);
    std::copy_n(&grid.Spacing[0], 3, numbers + 3);
    std::copy_n(&counts[0], 3, numbers + 6);
    array->InsertNextTuple(numbers);
  }
  data->AddArray(array);
}

ProbeGrids ReadGrids(vtkImageData* image)
{
  auto* array = vtkDoubleArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("grids"));
  const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
  if (!array || array->GetNumberOfComponents() != GridNumbers || count < 1 ||
    count > ProbeGrids::Most)
  {
    ThrowMissing("grids");
  }
  std::vector<ProbeGrid> grids;
  double points = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* numbers = array->GetPointer(GridNumbers * i);
    ProbeGrid grid;
    std::copy_n(numbers, 3, &grid.First[0]);
    std::copy_n(numbers + 3, 3, &grid.Spacing[0]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double probes = numbers[6 + axis];
      grid.Counts[axis] = probes >= 0.0 && probes <= MostProbes ? static_cast<int>(probes) : 0;
    }
    RequireValid(grid);
    points += grid.Size();
    grids.push_back(grid);
  }
  if (points > MostProbes)
  {
    throw std::invalid_argument(
      "its grids have more than " + std::to_string(MostProbes) + " probes in all");
  }
  if (points != static_cast<double>(image->GetNumberOfPoints()))
  {
    throw std::invalid_argument("its grids have other numbers of probes than it");
  }
  return ProbeGrids(std::move(grids));
}
}

ProbeField::ProbeField(const ProbeGrids& grids)
  : Grids(grids)
  , Offsets(static_cast<std::size_t>(grids.Size()), glm::vec3(0.0f))
  , Light(Offsets.size() * Harmonics, 0.0f)
  , Distance(Offsets.size() * Distances, 0.0f)
  , Sight(Offsets.size(), 0)
  , Backs(Offsets.size(), 0.0f)
{
}

glm::dvec3 ProbeField::Position(int probe) const
{
  const int number = this->Grids.Of(probe);
  const ProbeGrid& grid = this->Grids.Get(number);
  const glm::dvec3 cell(grid.Cell(probe - this->Grids.Begin(number)));
  return grid.First + grid.Spacing * (cell + glm::dvec3(this->Offsets[probe]));
}

std::vector<glm::dvec3> ProbeField::Positions(int first, int last) const
{
  std::vector<glm::dvec3> points;
  for (int probe = first; probe < last; ++probe)
  {
    points.push_back(this->Position(probe));
  }
  return points;
}

double ProbeField::Reach(int grid) const
{
  return 1.5 * glm::length(this->Grids.Get(grid).Spacing);
}

std::array<glm::ivec3, 13> ProbeNeighbours()
{
  std::array<glm::ivec3, 13> neighbours;
  for (int bit = 0; bit < 13; ++bit)
  {
    const int number = bit + 14;
    neighbours[bit] = glm::ivec3(number % 3, number / 3 % 3, number / 9) - 1;
  }
  return neighbours;
}

void ProbeField::ToImage(vtkImageData* image, bool compact) const
{
  image->Initialize();
  const bool several = this->Grids.Count() > 1;
  const ProbeGrid& grid = this->Grids.Get(0);
  const glm::ivec3 counts = several ? glm::ivec3(this->Grids.Size(), 1, 1) : grid.Counts;
  image->SetDimensions(counts.x, counts.y, counts.z);
  image->SetOrigin(grid.First.x, grid.First.y, grid.First.z);
  image->SetSpacing(grid.Spacing.x, grid.Spacing.y, grid.Spacing.z);
  const double scale = LargestOf(this->Light);
  AddNumbers(image, "light", this->Light, Harmonics, scale, compact);
  AddNumbers(image, "distance", this->Distance, Distances, 1.0, compact);
  const auto count = static_cast<vtkIdType>(this->Offsets.size());
  vtkNew<vtkFloatArray> offsets;
  offsets->SetName("offset");
  offsets->SetNumberOfComponents(3);
  offsets->SetNumberOfTuples(count);
  vtkNew<vtkShortArray> sight;
  sight->SetName("sight");
  sight->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> backs;
  backs->SetName("backs");
  backs->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    offsets->SetTuple3(i, this->Offsets[i].x, this->Offsets[i].y, this->Offsets[i].z);
    sight->SetValue(i, static_cast<short>(this->Sight[i]));
    backs->SetValue(i, static_cast<unsigned char>(std::lround(255.0f * this->Backs[i])));
  }
  image->GetPointData()->AddArray(offsets);
  image->GetPointData()->AddArray(sight);
  image->GetPointData()->AddArray(backs);
  vtkFieldData* fields = image->GetFieldData();
  SetText(fields, BakeFormat, several ? FormatOfSeveral : Format);
  if (several)
  {
    AddGrids(fields, this->Grids);
  }
  SetText(fields, BakedSceneText, this->Scene);
  vtkNew<vtkIntArray> samples;
  samples->SetName("samples");
  samples->InsertNextValue(this->Samples);
  fields->AddArray(samples);
  vtkNew<vtkDoubleArray> scales;
  scales->SetName("light scale");
  scales->InsertNextValue(scale);
  fields->AddArray(scales);
  SealBake(image, Sealed);
}

ProbeField ProbeField::FromImage(vtkImageData* image)
{
  const std::string format = image ? GetText(image->GetFieldData(), BakeFormat) : "";
  if (format != Format && format != FormatOfSeveral)
  {
    throw std::invalid_argument(format.empty()
        ? std::string("it is no field of probes: it lacks the text 'format'")
        : "it is of the format '" + format + "', and this version reads '" + Format + "' and '" +
          FormatOfSeveral + "'");
  }
  ProbeField field(format == Format ? ProbeGrids(ReadGrid(image)) : ReadGrids(image));
  vtkFieldData* fields = image->GetFieldData();
  auto* scale = Find<vtkDoubleArray>(fields, "light scale", 1, 1);
  auto* samples = Find<vtkIntArray>(fields, "samples", 1, 1);
  if (!scale || !samples)
  {
    ThrowMissing(scale ? "samples" : "light scale");
  }
  field.Samples = samples->GetValue(0);
  if (field.Samples < 0)
  {
    throw std::invalid_argument("its array 'samples' must not be negative");
  }
  field.Scene = GetText(fields, BakedSceneText);
  ReadNumbers(image, "light", Harmonics, scale->GetValue(0), field.Light);
  ReadNumbers(image, "distance", Distances, 1.0, field.Distance);
  std::vector<float> offsets;
  ReadNumbers(image, "offset", 3, 1.0, offsets);
  const auto count = static_cast<vtkIdType>(field.Offsets.size());
  auto* sight = Find<vtkShortArray>(image->GetPointData(), "sight", 1, count);
  auto* backs = Find<vtkUnsignedCharArray>(image->GetPointData(), "backs", 1, count);
  if (!sight || !backs)
  {
    ThrowMissing(sight ? "backs" : "sight");
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto probe = static_cast<std::size_t>(i);
    field.Offsets[probe] = glm::clamp(
      glm::vec3(offsets[3 * probe], offsets[3 * probe + 1], offsets[3 * probe + 2]), -0.5f, 0.5f);
    field.Sight[probe] = sight->GetValue(i);
    field.Backs[probe] = static_cast<float>(backs->GetValue(i)) / 255.0f;
  }
  RequireSealed(image, Sealed);
  return field;
}
}
