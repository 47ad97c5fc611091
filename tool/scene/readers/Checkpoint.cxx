// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/readers/Checkpoint.h"

#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "common/WholeFile.h"
#include "scene/readers/Completeness.h"

#include <OpenImageIO/hash.h>

#include <vtkFieldData.h>
#include <vtkGIPass.h>
#include <vtkGIPathTracing.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace penumbra::tool
{
namespace
{
namespace fs = std::filesystem;
constexpr const char* IdentityArray = "picture";
constexpr std::chrono::seconds Interval(30);
}

std::string Fingerprint(const std::string& text, const std::vector<std::string>& files)
{
  OIIO::SHA1 print(text.data(), text.size());
  std::vector<char> piece(1 << 20);
  for (const std::string& path : files)
  {
    print.append(path.data(), path.size());
    std::ifstream file(path, std::ios::binary);
    while (file)
    {
      file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
      print.append(piece.data(), static_cast<std::size_t>(file.gcount()));
    }
  }
  return print.digest().substr(0, 16);
}

Checkpoint::Checkpoint(
  std::string path, std::string identity, vtkGIPass* pass, vtkRenderer* renderer)
  : Path(std::move(path))
  , Identity(std::move(identity))
  , Pass(pass)
  , Renderer(renderer)
  , Tracer(vtkGIPathTracing::SafeDownCast(pass->GetTechnique("path-tracing")))
{
}

int Checkpoint::Resume()
{
  const fs::path folder = fs::absolute(this->Path).parent_path();
  if (access(folder.c_str(), W_OK) != 0 || fs::is_directory(this->Path))
  {
    Fail("the checkpoint '{}' cannot be written: choose a file in a folder you may write to",
      this->Path);
  }
  std::error_code error;
  if (!fs::exists(this->Path, error))
  {
    return 0;
  }
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(this->Path.c_str()))
  {
    this->Refuse();
  }
  RequireCompleteXml(this->Path);
  reader->SetFileName(this->Path.c_str());
  reader->Update();
  ThrowVtkErrors(fmt::format("the checkpoint '{}' cannot be read", this->Path));
  vtkImageData* image = reader->GetOutput();
  auto* identity =
    vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(IdentityArray));
  if (!identity || identity->GetNumberOfValues() != 1 ||
    !this->Tracer->SetProgress(this->Renderer, image))
  {
    this->Refuse();
  }
  if (identity->GetValue(0) != this->Identity)
  {
    Fail("the checkpoint '{}' is of another picture: it holds {}, and this is {}", this->Path,
      std::string(identity->GetValue(0)), this->Identity);
  }
  return static_cast<int>(image->GetFieldData()->GetArray("samples")->GetComponent(0, 0));
}

void Checkpoint::Refuse() const
{
  Fail(
    "'{}' is not a checkpoint: give --checkpoint a file that it wrote, or one that does not exist "
    "yet",
    this->Path);
}

void Checkpoint::Save(bool inAnyCase)
{
  const auto now = std::chrono::steady_clock::now();
  if (!inAnyCase && now - this->Saved < Interval)
  {
    return;
  }
  vtkNew<vtkImageData> image;
  if (!this->Tracer->GetProgress(this->Pass, this->Renderer, image))
  {
    return;
  }
  vtkNew<vtkStringArray> identity;
  identity->SetName(IdentityArray);
  identity->InsertNextValue(this->Identity);
  image->GetFieldData()->AddArray(identity);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  if (!WriteWhole(writer, this->Path))
  {
    Fail("cannot write the checkpoint '{}'", this->Path);
  }
  this->Saved = now;
}
}
