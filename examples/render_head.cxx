// An MRI head with shadows and ambient occlusion: render_head HEAD.nii.gz OUT.png [WIDTH]
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFlyingEdges3D.h>
#include <vtkGIPass.h>
#include <vtkLight.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkFlyingEdges3D> skin;
  skin->SetInputConnection(reader->GetOutputPort());
  skin->SetValue(0, 32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(skin->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> head;
  head->SetMapper(mapper);
  head->GetProperty()->SetColor(0.87, 0.68, 0.56);

  vtkNew<vtkLight> light;
  light->SetPosition(1, 1, 1);
  vtkNew<vtkRenderer> renderer;
  renderer->AddLight(light);
  renderer->AddActor(head);
  renderer->SetBackground(0.75, 0.78, 0.82);
  renderer->GetActiveCamera()->SetPosition(0.5, 1, 0.35);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.4);

  vtkNew<vtkGIPass> gi;
  gi->SetPreset("balanced");
  renderer->SetPass(gi);

  const int width = argc > 3 ? std::atoi(argv[3]) : 800;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(width, width);
  window->SetMultiSamples(8);
  window->AddRenderer(renderer);
  for (int frame = 0; frame < 16; ++frame)
  {
    window->Render();
  }
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return writer->GetErrorCode() ? EXIT_FAILURE : EXIT_SUCCESS;
}
