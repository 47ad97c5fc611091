// Shared by the C++ examples that draw films: helpers to build scenes, and frames as PNG files in a folder.
#pragma once

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

struct Color
{
  double Red, Green, Blue;
};

inline vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithm* source, const Color& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.Red, color.Green, color.Blue);
  return actor;
}

// Add an omnidirectional light at a position in the scene.
inline vtkSmartPointer<vtkLight> AddLamp(vtkRenderer* renderer, double x, double y, double z)
{
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180);
  lamp->SetPosition(x, y, z);
  renderer->AddLight(lamp);
  return lamp;
}

// Create a square window for the renderer, seen from a point along the positive y axis, with z upwards.
inline vtkSmartPointer<vtkRenderWindow> Aim(
  vtkRenderer* renderer, const double (&from)[3], double angle, int width)
{
  renderer->GetActiveCamera()->SetPosition(from);
  renderer->GetActiveCamera()->SetFocalPoint(from[0], from[1] + 1, from[2]);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->GetActiveCamera()->SetViewAngle(angle);
  renderer->ResetCameraClippingRange();
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetSize(width, width);
  window->AddRenderer(renderer);
  return window;
}

// The command line FOLDER [FRAMES] [WIDTH], and the frames in that folder. Errors print one sentence and end the
// program. ffmpeg -i FOLDER/%04d.png movie.mp4 makes a film of the frames.
struct Film
{
  std::filesystem::path Folder;
  int Frames = 60;
  int Width = 512; // and height, in pixels

  Film(int argc, char* argv[])
  {
    this->Frames = argc > 2 ? std::atoi(argv[2]) : this->Frames;
    this->Width = argc > 3 ? std::atoi(argv[3]) : this->Width;
    if (argc < 2 || argc > 4 || this->Frames < 1 || this->Width < 1)
    {
      Fail("usage: " + std::filesystem::path(argv[0]).filename().string() +
        " FOLDER [FRAMES] [WIDTH]");
    }
    this->Folder = argv[1];
    std::error_code failed;
    std::filesystem::create_directories(this->Folder, failed);
    if (failed)
    {
      Fail("cannot make the folder " + this->Folder.string() + ": " + failed.message());
    }
  }

  void Save(vtkRenderWindow* window, int frame) const
  {
    char name[16];
    std::snprintf(name, sizeof(name), "%04d.png", frame);
    const std::string path = (this->Folder / name).string();
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(window);
    picture->ReadFrontBufferOff();
    picture->ShouldRerenderOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(picture->GetOutputPort());
    writer->SetFileName(path.c_str());
    writer->Write();
    if (writer->GetErrorCode() != 0)
    {
      Fail("cannot write " + path);
    }
    std::cout << "\rframe " << frame + 1 << " of " << this->Frames
              << (frame + 1 == this->Frames ? "\n" : "") << std::flush;
  }

  [[noreturn]] static void Fail(const std::string& sentence)
  {
    std::cerr << sentence << "\n";
    std::exit(EXIT_FAILURE);
  }
};
