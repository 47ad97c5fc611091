// Draws a sphere with the installed module. Succeeds if the picture shows it.
#include <vtkActor.h>
#include <vtkGIPass.h>
#include <vtkGIShadowMaps.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkGIPass> gi;
  gi->SetPreset("balanced");
  vtkGIShadowMaps::SafeDownCast(gi->GetTechnique("shadow-maps"))->SetResolution(512);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetPass(gi);
  vtkNew<vtkHeadlessRenderWindow> window;
  window->SetSize(64, 64);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(32, 32, 32, 32, 0, pixel, 0);
  return pixel->GetNumberOfValues() >= 3 && pixel->GetValue(0) > 50 ? 0 : 1;
}
