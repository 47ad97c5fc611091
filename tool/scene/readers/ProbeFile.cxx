// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/ProbeFile.h"

#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "common/WholeFile.h"
#include "scene/readers/Completeness.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <filesystem>
#include <fstream>

namespace penumbra::tool
{
namespace
{
namespace fs = std::filesystem;
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
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(field);
  // Debian 12 stumbles over appended data: VTK before 9.3.1 with newer versions of Expat.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  if (!WriteWhole(writer, path))
  {
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
  return field;
}
}
