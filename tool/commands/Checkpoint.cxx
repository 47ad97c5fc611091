// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Checkpoint.h"

#include "bake/BakeImage.h"
#include "common/Failure.h"
#include "common/VtkMessages.h"
#include "common/WholeFile.h"
#include "scene/readers/Completeness.h"

#include <OpenImageIO/hash.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkGIPass.h>
#include <vtkGIPathTracing.h>
#include <vtkImageData.h>
#include <vtkNew.h>
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
constexpr double Interval = 30; // seconds
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
  const auto reject = [this] {
    Fail(
      "'{}' is not a checkpoint: give --checkpoint a file that it wrote, or a new one", this->Path);
  };
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(this->Path.c_str()))
  {
    reject();
  }
  RequireCompleteXml(this->Path);
  reader->SetFileName(this->Path.c_str());
  reader->Update();
  ThrowVtkErrors(fmt::format("the checkpoint '{}' cannot be read", this->Path));
  vtkImageData* image = reader->GetOutput();
  const std::string identity = GetText(image->GetFieldData(), IdentityArray);
  if (identity.empty() || !this->Tracer->SetProgress(this->Renderer, image))
  {
    reject();
  }
  if (identity != this->Identity)
  {
    Fail("the checkpoint '{}' is of another picture: it holds {}, and this is {}", this->Path,
      identity, this->Identity);
  }
  return static_cast<int>(image->GetFieldData()->GetArray("samples")->GetComponent(0, 0));
}

void Checkpoint::SaveIfDue()
{
  if (SecondsSince(this->Saved) >= Interval)
  {
    this->Save();
  }
}

void Checkpoint::Save()
{
  vtkNew<vtkImageData> image;
  if (!this->Tracer->GetProgress(this->Pass, this->Renderer, image))
  {
    return;
  }
  SetText(image->GetFieldData(), IdentityArray, this->Identity);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  if (!WriteWhole(writer, this->Path))
  {
    Fail("the checkpoint '{}' cannot be written", this->Path);
  }
  this->Saved = Clock::now();
}
}
