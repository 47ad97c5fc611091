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
// Suppresses VTK's messages while it lives. Problems are reported in one sentence instead.
class MessageSilencer
{
public:
  MessageSilencer() { vtkObject::GlobalWarningDisplayOff(); }
  ~MessageSilencer() { vtkObject::SetGlobalWarningDisplay(this->PreviousSetting); }
  MessageSilencer(const MessageSilencer&) = delete;
  MessageSilencer& operator=(const MessageSilencer&) = delete;

private:
  int PreviousSetting = vtkObject::GetGlobalWarningDisplay();
};

// Load probes from a file into the technique. Returns the reason if that failed, else "".
std::string Load(const std::string& path, vtkGISHProbes* technique)
{
  const std::string subject = "the probes '" + path + "' ";
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    return subject + "do not exist: bake them, or choose another file";
  }
  const MessageSilencer silencer;
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    return "'" + path + "' holds no probes: choose a file of baked probes (.vti)";
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() || reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    return subject + "are damaged: bake them again";
  }
  if (!technique->SetBake(reader->GetOutput()))
  {
    return subject + "cannot be used: " + technique->GetBakeError();
  }
  return "";
}

// Write a field to a temporary file first, so that an earlier file is kept until the new one is complete. The command
// line tool resumes bakes from files with another suffix.
bool Write(const std::string& path, vtkImageData* field)
{
  const MessageSilencer silencer;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(field);
  writer->WriteToOutputStringOn();
  // VTK before 9.3.1 cannot read appended data with newer versions of Expat.
  writer->SetDataModeToBinary();
  if (!writer->Write())
  {
    return false;
  }
  const std::string temporary = path + ".half";
  vtksys::ofstream file(temporary.c_str(), std::ios::binary);
  file << writer->GetOutputString();
  file.close();
  const bool written = file && std::rename(temporary.c_str(), path.c_str()) == 0;
  if (!written)
  {
    vtksys::SystemTools::RemoveFile(temporary);
  }
  return written;
}
}

void BakedProbes::Report(const std::string& problem)
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
  this->FileChanged = this->FileChanged || path != this->File;
  this->File = path;
}

void BakedProbes::Update(vtkGISHProbes* technique)
{
  if (!this->FileChanged)
  {
    return;
  }
  this->FileChanged = false;
  technique->SetBake(nullptr);
  this->Report(this->File.empty() ? "" : Load(this->File, technique));
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
    this->Report(std::string("the probes cannot be baked: ") + baker->GetLastError());
    return;
  }
  if (!technique->SetBake(field))
  {
    this->Report(std::string("the probes cannot be used: ") + technique->GetBakeError());
    return;
  }
  this->FileChanged = false;
  const bool saved = this->File.empty() || Write(this->File, field);
  this->Report(saved ? ""
                     : "the probes are baked, but '" + this->File +
        "' cannot be written: make room on the disk, or choose another file");
}
}
