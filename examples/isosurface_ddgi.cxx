// An isosurface whose shape and colours change in every frame, in a room; both light each other by DDGI:
// isosurface_ddgi FOLDER [FRAMES] [WIDTH]
#include "Film.h"

#include <vtkColorTransferFunction.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Samples = 48;  // of the field, along each axis
constexpr double Half = 0.9; // half of the field's extent; the room's is 1

// Computes the potential of three circling charges, whose isosurface is shown, and the first charge's share of it,
// which colours the surface.
void Compute(vtkImageData* field, double time)
{
  auto* potential = vtkFloatArray::SafeDownCast(field->GetPointData()->GetArray("potential"));
  auto* share = vtkFloatArray::SafeDownCast(field->GetPointData()->GetArray("share"));
  double charges[3][3];
  for (int i = 0; i < 3; ++i)
  {
    const double angle = 2 * Pi * (time + i / 3.0);
    charges[i][0] = 0.45 * std::cos(angle);
    charges[i][1] = 0.45 * std::sin(angle);
    charges[i][2] = 0.35 * std::sin(2 * angle + i);
  }
  for (vtkIdType id = 0; id < field->GetNumberOfPoints(); ++id)
  {
    double point[3];
    field->GetPoint(id, point);
    double parts[3];
    for (int i = 0; i < 3; ++i)
    {
      parts[i] = 0.1 /
        std::max(0.05,
          std::hypot(point[0] - charges[i][0], point[1] - charges[i][1], point[2] - charges[i][2]));
    }
    const double sum = parts[0] + parts[1] + parts[2];
    potential->SetValue(id, static_cast<float>(sum));
    share->SetValue(id, static_cast<float>(parts[0] / sum));
  }
  potential->Modified();
  share->Modified();
  field->Modified();
}

vtkSmartPointer<vtkImageData> MakeField()
{
  auto field = vtkSmartPointer<vtkImageData>::New();
  field->SetDimensions(Samples, Samples, Samples);
  field->SetOrigin(-Half, -Half, -Half);
  constexpr double step = 2 * Half / (Samples - 1);
  field->SetSpacing(step, step, step);
  for (const char* name : { "potential", "share" })
  {
    vtkNew<vtkFloatArray> values;
    values->SetName(name);
    values->SetNumberOfValues(field->GetNumberOfPoints());
    field->GetPointData()->AddArray(values);
  }
  field->GetPointData()->SetActiveScalars("potential");
  return field;
}

// A room from -1 to 1 along every axis, open towards the camera.
void AddWalls(vtkRenderer* renderer)
{
  const Color white{ 0.75, 0.75, 0.75 };
  const auto wall = [renderer](const double(&origin)[3], const double(&point1)[3],
                      const double(&point2)[3], const Color& color) {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(origin[0], origin[1], origin[2]);
    plane->SetPoint1(point1[0], point1[1], point1[2]);
    plane->SetPoint2(point2[0], point2[1], point2[2]);
    renderer->AddActor(MakeActor(plane, color));
  };
  wall({ -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 }, white);
  wall({ -1, -1, 1 }, { -1, 1, 1 }, { 1, -1, 1 }, white);
  wall({ -1, 1, -1 }, { 1, 1, -1 }, { -1, 1, 1 }, white);
  wall({ -1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }, { 0.70, 0.42, 0.12 });
  wall({ 1, -1, -1 }, { 1, -1, 1 }, { 1, 1, -1 }, { 0.15, 0.40, 0.55 });
}
}

int main(int argc, char* argv[])
{
  const Film film(argc, argv);
  vtkNew<vtkRenderer> renderer;
  AddWalls(renderer);
  vtkSmartPointer<vtkImageData> field = MakeField();
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData(field);
  surface->SetValue(0, 0.55);
  surface->ComputeScalarsOff();
  surface->InterpolateAttributesOn();
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.15, 0.10, 0.25, 0.85);
  colors->AddRGBPoint(0.35, 0.85, 0.85, 0.80);
  colors->AddRGBPoint(0.60, 0.90, 0.20, 0.05);
  vtkSmartPointer<vtkActor> actor = MakeActor(surface, { 1, 1, 1 });
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("share");
  mapper->SetLookupTable(colors);
  renderer->AddActor(actor);
  AddLamp(renderer, 0.55, -0.75, 0.8)->SetIntensity(0.7);
  Compute(field, 0);
  vtkSmartPointer<vtkRenderWindow> window = Aim(renderer, { 0, -4, 0 }, 38, film.Width);

  // All that Penumbra needs: its pass, and DDGI switched on.
  vtkNew<vtkGIPass> gi;
  gi->SetPreset("balanced");
  gi->GetTechnique("ddgi")->EnabledOn();
  renderer->SetPass(gi);

  for (int frame = 0; frame < film.Frames; ++frame)
  {
    Compute(field, static_cast<double>(frame) / film.Frames);
    window->Render(); // updates the shape, the colours, and the probes once
    film.Save(window, frame);
  }
  return EXIT_SUCCESS;
}
