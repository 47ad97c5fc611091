// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BakedProbes.h"

#include "vtkGIProbeBaker.h"
#include "vtkGISHProbes.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOutputWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <cstdio>

namespace penumbra
{
namespace
{
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

// The reason where they cannot be used, else "".
std::string Load(const std::string& path, vtkGISHProbes* technique)
{
  const std::string named = "the probes '" + path + "' ";
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    return named + "do not exist: bake them, or choose another file";
  }
  const Quiet quiet;
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    return "'" + path + "' holds no probes: choose a file of baked probes (.vti)";
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() || reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    return named + "are damaged: bake them again";
  }
  if (!technique->SetBake(reader->GetOutput()))
  {
    return named + "cannot be used: " + technique->GetBakeError();
  }
  return "";
}

// By another name first, so that an earlier file is there until the new one is complete; not by that of the bakes that
// the command line tool resumes.
bool Write(const std::string& path, vtkImageData* field)
{
  const Quiet quiet;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(field);
  writer->WriteToOutputStringOn();
  // VTK before 9.3.1 stumbles over appended data with newer versions of Expat.
  writer->SetDataModeToBinary();
  if (!writer->Write())
  {
    return false;
  }
  const std::string half = path + ".half";
  vtksys::ofstream file(half.c_str(), std::ios::binary);
  file << writer->GetOutputString();
  file.close();
  const bool written = file && std::rename(half.c_str(), path.c_str()) == 0;
  if (!written)
  {
    vtksys::SystemTools::RemoveFile(half);
  }
  return written;
}
}

void BakedProbes::Tell(const std::string& problem)
{
  this->Problem = problem;
  if (!problem.empty())
  {
    const char* end = problem.back() == '.' ? "\n" : ".\n";
    vtkOutputWindow::GetInstance()->DisplayErrorText(("Penumbra: " + problem + end).c_str());
  }
}

void BakedProbes::SetFile(const std::string& path)
{
  this->FileIsNew = this->FileIsNew || path != this->File;
  this->File = path;
}

void BakedProbes::Update(vtkGISHProbes* technique)
{
  if (!this->FileIsNew)
  {
    return;
  }
  this->FileIsNew = false;
  technique->SetBake(nullptr);
  this->Tell(this->File.empty() ? "" : Load(this->File, technique));
}

void BakedProbes::Bake(vtkGISHProbes* technique, vtkRenderer* renderer)
{
  vtkNew<vtkGIProbeBaker> baker;
  baker->SetProbes(this->Probes);
  baker->SetSamples(this->Samples);
  vtkNew<vtkImageData> field;
  const bool baked = baker->Bake(renderer, field);
  baker->ReleaseGraphicsResources(renderer->GetRenderWindow());
  if (!baked)
  {
    this->Tell(std::string("the probes cannot be baked: ") + baker->GetLastError());
    return;
  }
  if (!technique->SetBake(field))
  {
    this->Tell(std::string("the probes cannot be used: ") + technique->GetBakeError());
    return;
  }
  this->FileIsNew = false;
  const bool kept = this->File.empty() || Write(this->File, field);
  this->Tell(kept ? ""
                  : "the probes are baked, but '" + this->File +
        "' cannot be written: make room on the disk, or choose another file");
}
}
