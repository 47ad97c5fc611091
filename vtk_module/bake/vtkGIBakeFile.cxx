// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIBakeFile.h"

#include "bake/BakeImage.h"

#include "vtkGIPass.h"
#include "vtkGITechnique.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

vtkStandardNewMacro(vtkGIBakeFile);

using namespace penumbra;

namespace
{
namespace fs = std::filesystem;

// No messages of VTK meanwhile: what went wrong is told in one sentence.
class Quiet
{
public:
  Quiet() { vtkObject::GlobalWarningDisplayOff(); }
  ~Quiet() { vtkObject::SetGlobalWarningDisplay(this->Before); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  int Before = vtkObject::GetGlobalWarningDisplay();
};

bool IsOpenExr(std::istream& file)
{
  std::array<char, 4> magic{};
  file.read(magic.data(), magic.size());
  return std::string_view(magic.data(), magic.size()) == "\x76\x2f\x31\x01";
}

bool IsFor(vtkGITechnique* technique, const std::string& format)
{
  const char* own = technique->GetBakeFormat();
  return own && format.rfind(own, 0) == 0;
}

// VTK 9.2 crashes on arrays of field data whose type it does not know.
bool HasKnownTypes(const char* path)
{
  vtkNew<vtkXMLDataParser> parser;
  parser->SetFileName(path);
  vtkXMLDataElement* root = parser->Parse() ? parser->GetRootElement() : nullptr;
  vtkXMLDataElement* image = root ? root->FindNestedElementWithName("ImageData") : nullptr;
  vtkXMLDataElement* fields = image ? image->FindNestedElementWithName("FieldData") : nullptr;
  for (int i = 0; fields && i < fields->GetNumberOfNestedElements(); ++i)
  {
    int type = 0;
    if (!fields->GetNestedElement(i)->GetWordTypeAttribute("type", type))
    {
      return false;
    }
  }
  return root != nullptr;
}

enum class Found
{
  Nothing,
  Damage,
  Image
};

Found ReadImage(const char* path, vtkImageData* image)
{
  const Quiet quiet;
  try
  {
    vtkNew<vtkXMLImageDataReader> reader;
    if (!reader->CanReadFile(path))
    {
      return Found::Nothing;
    }
    if (!HasKnownTypes(path))
    {
      return Found::Damage;
    }
    reader->SetFileName(path);
    reader->Update();
    image->ShallowCopy(reader->GetOutput());
    return reader->GetErrorCode() == 0 && image->GetNumberOfPoints() > 0 ? Found::Image
                                                                         : Found::Damage;
  }
  catch (const std::exception&) // a damaged header asks for too much memory
  {
    return Found::Damage;
  }
}
}

bool vtkGIBakeFile::Refuse(const std::string& reason)
{
  this->LastError = reason;
  return false;
}

bool vtkGIBakeFile::Read(const char* path, vtkImageData* bake)
{
  this->LastError.clear();
  if (!path || !bake)
  {
    return this->Refuse("a bake is read from a file into an image: neither may be missing");
  }
  const std::string file = std::string("'") + path + "'";
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    return this->Refuse("the bake " + file + " does not exist: make one with penumbra bake");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    return this->Refuse("the bake " + file + " cannot be opened: check that you may read it");
  }
  if (IsOpenExr(stream))
  {
    return this->Refuse(file +
      " is an OpenEXR file, the old form of lightmaps: convert it with penumbra bake convert " +
      path + " -o NEW.vti");
  }
  const Found found = ReadImage(path, bake);
  if (found == Found::Nothing)
  {
    return this->Refuse(file +
      " holds no baked light, or is badly damaged: give a file written by penumbra bake lightmap "
      "or penumbra bake "
      "probes");
  }
  return found == Found::Image || this->Refuse("the bake " + file + " is damaged: bake it again");
}

bool vtkGIBakeFile::Give(const char* path, vtkImageData* bake, vtkGITechnique* technique)
{
  return technique->SetBake(bake) ||
    this->Refuse(
      std::string("the bake '") + path + "' cannot be used: " + technique->GetBakeError());
}

bool vtkGIBakeFile::Load(const char* path, vtkGITechnique* technique)
{
  vtkNew<vtkImageData> bake;
  return technique && this->Read(path, bake) && this->Give(path, bake, technique);
}

vtkGITechnique* vtkGIBakeFile::Load(const char* path, vtkGIPass* pass)
{
  vtkNew<vtkImageData> bake;
  if (!pass || !this->Read(path, bake))
  {
    return nullptr;
  }
  const std::string format = GetText(bake->GetFieldData(), BakeFormat);
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    vtkGITechnique* technique = pass->GetTechnique(i);
    if (IsFor(technique, format))
    {
      const bool given = this->Give(path, bake, technique);
      technique->SetEnabled(given || technique->GetEnabled());
      return given ? technique : nullptr;
    }
  }
  this->Refuse(std::string("'") + path +
    "' is a VTK image that holds no baked light: give a file written by penumbra bake lightmap or "
    "penumbra bake probes");
  return nullptr;
}

bool vtkGIBakeFile::Write(const char* path, vtkImageData* bake)
{
  this->LastError.clear();
  if (!path || !bake)
  {
    return this->Refuse("a bake is written from an image to a file: neither may be missing");
  }
  const Quiet quiet;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(bake);
  // To memory: the writer does not tell of every disk that is full.
  writer->WriteToOutputStringOn();
  // VTK before 9.3.1 stumbles over appended data with newer versions of Expat.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  const std::string half = std::string(path) + ".half";
  std::error_code error;
  bool written = writer->Write() != 0;
  if (written)
  {
    std::ofstream file(half, std::ios::binary);
    file << writer->GetOutputString();
    file.close();
    written = bool(file);
  }
  if (written)
  {
    fs::rename(half, path, error);
  }
  if (!written || error)
  {
    fs::remove(half, error);
    return this->Refuse(std::string("'") + path +
      "' cannot be written: make room on the disk, or choose another file");
  }
  return true;
}

const char* vtkGIBakeFile::GetLastError()
{
  return this->LastError.c_str();
}
