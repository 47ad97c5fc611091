// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProbeFile.h"

#include "Completeness.h"
#include "Failure.h"
#include "VtkMessages.h"

#include <OpenImageIO/hash.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace penumbra::tool
{
namespace
{
namespace fs = std::filesystem;
constexpr const char* DigestArray = "digest";

/// Of the grid and all that the field holds.
std::string Digest(vtkImageData* field)
{
  OIIO::SHA1 print;
  print.append(field->GetDimensions(), 3 * sizeof(int));
  print.append(field->GetOrigin(), 3 * sizeof(double));
  print.append(field->GetSpacing(), 3 * sizeof(double));
  const auto add = [&print](vtkFieldData* data) {
    std::set<std::string> names; // in an order that files keep
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* name = data->GetAbstractArray(i)->GetName();
      names.insert(name ? name : "");
    }
    names.erase(DigestArray);
    for (const std::string& name : names)
    {
      print.append(name.data(), name.size());
      vtkAbstractArray* array = data->GetAbstractArray(name.c_str());
      if (auto* numbers = vtkDataArray::SafeDownCast(array))
      {
        print.append(numbers->GetVoidPointer(0),
          static_cast<std::size_t>(numbers->GetNumberOfValues()) * numbers->GetDataTypeSize());
      }
      else if (auto* texts = vtkStringArray::SafeDownCast(array))
      {
        for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
        {
          const std::string text = texts->GetValue(i);
          print.append(text.data(), text.size());
        }
      }
    }
  };
  add(field->GetPointData());
  add(field->GetFieldData());
  return print.digest();
}
}

std::string ProbeText(vtkImageData* field, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(field->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : std::string();
}

void SetProbeText(vtkImageData* field, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  field->GetFieldData()->AddArray(array);
}

void WriteProbes(const std::string& path, vtkImageData* field)
{
  vtkNew<vtkImageData> signedField;
  signedField->ShallowCopy(field);
  SetProbeText(signedField, DigestArray, Digest(field));
  const std::string half = path + ".half";
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(half.c_str());
  writer->SetInputData(signedField);
  // Debian 12 stumbles over appended data: VTK before 9.3.1 with newer versions of Expat.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  const bool written = writer->Write() != 0;
  std::error_code error;
  if (written)
  {
    fs::rename(half, path, error);
  }
  const bool complained = !TakeVtkMessages().Errors.empty();
  if (!written || complained || error)
  {
    std::error_code ignored;
    fs::remove(half, ignored);
    Fail("'{}' cannot be written: make room on the disk, or choose another file with -o", path);
  }
}

bool IsProbes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string head(512, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return head.find("type=\"ImageData\"") != std::string::npos;
}

vtkSmartPointer<vtkImageData> ReadProbes(const std::string& path)
{
  if (!std::ifstream(path) || fs::is_directory(path))
  {
    Fail("the probes '{}' cannot be opened: check the name and that you may read it", path);
  }
  if (!IsProbes(path))
  {
    Fail("'{}' holds no probes: give a file that penumbra bake probes wrote", path);
  }
  RequireCompleteXml(path);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ThrowVtkErrors(fmt::format("the probes '{}' are damaged", path));
  vtkSmartPointer<vtkImageData> field = reader->GetOutput();
  const std::string format = ProbeText(field, "format");
  if (format.rfind("penumbra probes", 0) != 0)
  {
    Fail("'{}' is a VTK image without probes: give a file that penumbra bake probes wrote", path);
  }
  // Other programs write fields without one.
  const std::string digest = ProbeText(field, DigestArray);
  if (!digest.empty() && digest != Digest(field))
  {
    Fail("the probes '{}' are damaged: their digest is another; bake them again", path);
  }
  return field;
}
}
