// A circling lamp in a Cornell box, whose walls light each other by DDGI: moving_light FOLDER [FRAMES] [WIDTH]
#include "Film.h"

#include <vtkCubeSource.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>

#include <cmath>

namespace
{
vtkSmartPointer<vtkActor> Box(const double (&bounds)[6], const Color& color)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(bounds);
  vtkSmartPointer<vtkActor> actor = MakeActor(cube, color);
  actor->GetProperty()->SetInterpolationToFlat();
  return actor;
}

// A room from 0 to 1 along every axis, open towards the camera, with two blocks in it.
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
}

int main(int argc, char* argv[])
{
  const Film film(argc, argv);
  vtkNew<vtkRenderer> renderer;
  Furnish(renderer);
  vtkSmartPointer<vtkLight> lamp = AddLamp(renderer, 0.8, 0.5, 0.8);
  vtkSmartPointer<vtkRenderWindow> window = Aim(renderer, { 0.5, -1.4, 0.5 }, 40, film.Width);

  // This is all that Penumbra needs: its pass, with DDGI switched on.
  vtkNew<vtkGIPass> gi;
  gi->SetPreset("balanced");
  gi->GetTechnique("ddgi")->EnabledOn();
  renderer->SetPass(gi);

  for (int frame = 0; frame < film.Frames; ++frame)
  {
    const double angle = 2 * std::acos(-1.0) * frame / film.Frames;
    lamp->SetPosition(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle), 0.8);
    window->Render(); // one update of the probes
    film.Save(window, frame);
  }
  return EXIT_SUCCESS;
}
