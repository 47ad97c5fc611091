// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bake/BakeImage.h"

#include "base/Hasher.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <stdexcept>

namespace penumbra
{
namespace
{
constexpr const char* ChecksumArray = "checksum";

std::string Checksum(vtkImageData* image, const BakeArrays& arrays)
{
  Hasher hash;
  std::array<int, 3> counts{};
  image->GetDimensions(counts.data());
  hash.AddValue(counts);
  hash.AddValue(glm::make_vec3(image->GetOrigin()));
  hash.AddValue(glm::make_vec3(image->GetSpacing()));
  for (const char* name : arrays.Texts)
  {
    const std::string text = GetText(image->GetFieldData(), name);
    hash.Add(std::vector<char>(text.begin(), text.end()));
  }
  const auto addNumbers = [&hash](vtkFieldData* data, const std::vector<const char*>& names) {
    for (const char* name : names)
    {
      if (auto* array = vtkDataArray::SafeDownCast(data->GetAbstractArray(name)))
      {
        hash.Add(array->GetVoidPointer(0),
          static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
      }
    }
  };
  addNumbers(image->GetFieldData(), arrays.Fields);
  addNumbers(image->GetPointData(), arrays.Points);
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016" PRIx64, hash.Get());
  return digits.data();
}
}

void SetText(vtkFieldData* data, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  data->AddArray(array);
}

std::string GetText(vtkFieldData* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  const bool one = array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == 1;
  return one ? std::string(array->GetValue(0)) : std::string();
}

void SealBake(vtkImageData* image, const BakeArrays& arrays)
{
  SetText(image->GetFieldData(), ChecksumArray, Checksum(image, arrays));
}

void RequireSealed(vtkImageData* image, const BakeArrays& arrays)
{
  // Earlier versions wrote none.
  const std::string checksum = GetText(image->GetFieldData(), ChecksumArray);
  if (!checksum.empty() && checksum != Checksum(image, arrays))
  {
    throw std::invalid_argument(
      "its checksum does not fit what it holds: it was altered, or is damaged");
  }
}
}
