// A lamp that circles in a Cornell box, whose walls light each other by DDGI: moving_light FOLDER [FRAMES] [WIDTH]
// Writes FOLDER/0000.png and so on. ffmpeg -i FOLDER/%04d.png movie.mp4 makes a film of them.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace
{
struct Color
{
  double Red, Green, Blue;
};

vtkSmartPointer<vtkActor> Box(const double (&bounds)[6], const Color& color)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(bounds);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.Red, color.Green, color.Blue);
  actor->GetProperty()->SetInterpolationToFlat();
  return actor;
}

// A room from 0 to 1 along every axis, open to the eye, with two blocks in it.
void Furnish(vtkRenderer* renderer)
{
  constexpr double thick = 0.05;
  const Color white{ 0.73, 0.73, 0.73 };
  renderer->AddActor(Box({ 0, 1, 0, 1, -thick, 0 }, white));
  renderer->AddActor(Box({ 0, 1, 0, 1, 1, 1 + thick }, white));
  renderer->AddActor(Box({ 0, 1, 1, 1 + thick, 0, 1 }, white));
  renderer->AddActor(Box({ -thick, 0, 0, 1, 0, 1 }, { 0.65, 0.05, 0.05 }));
  renderer->AddActor(Box({ 1, 1 + thick, 0, 1, 0, 1 }, { 0.12, 0.45, 0.15 }));
  vtkSmartPointer<vtkActor> tall = Box({ -0.15, 0.15, -0.15, 0.15, 0, 0.6 }, white);
  tall->SetPosition(0.33, 0.68, 0);
  tall->RotateZ(20);
  renderer->AddActor(tall);
  vtkSmartPointer<vtkActor> low = Box({ -0.15, 0.15, -0.15, 0.15, 0, 0.3 }, white);
  low->SetPosition(0.68, 0.35, 0);
  low->RotateZ(-18);
  renderer->AddActor(low);
}

bool Save(vtkRenderWindow* window, const std::string& path)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  const int frames = argc > 2 ? std::atoi(argv[2]) : 60;
  const int width = argc > 3 ? std::atoi(argv[3]) : 512;
  if (argc < 2 || frames < 1 || width < 1)
  {
    std::cerr << "usage: moving_light FOLDER [FRAMES] [WIDTH]\n";
    return EXIT_FAILURE;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
  {
    std::cerr << "cannot make the folder " << folder << ": " << failed.message() << "\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkRenderer> renderer;
  Furnish(renderer);
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180); // shines all around
  renderer->AddLight(lamp);
  renderer->GetActiveCamera()->SetPosition(0.5, -1.4, 0.5);
  renderer->GetActiveCamera()->SetFocalPoint(0.5, 0.5, 0.5);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->GetActiveCamera()->SetViewAngle(40);
  renderer->ResetCameraClippingRange();

  // All that Penumbra needs: its pass, and DDGI switched on.
  vtkNew<vtkGIPass> gi;
  gi->SetPreset("balanced");
  gi->GetTechnique("ddgi")->EnabledOn();
  renderer->SetPass(gi);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(width, width);
  window->AddRenderer(renderer);
  for (int frame = 0; frame < frames; ++frame)
  {
    const double turn = 2 * std::acos(-1.0) * frame / frames;
    lamp->SetPosition(0.5 + 0.3 * std::cos(turn), 0.5 + 0.3 * std::sin(turn), 0.8);
    window->Render(); // one update of the probes
    char name[16];
    std::snprintf(name, sizeof(name), "%04d.png", frame);
    if (!Save(window, (folder / name).string()))
    {
      std::cerr << "cannot write " << folder / name << "\n";
      return EXIT_FAILURE;
    }
    std::cout << "\rframe " << frame + 1 << " of " << frames << std::flush;
  }
  std::cout << "\n";
  return EXIT_SUCCESS;
}
