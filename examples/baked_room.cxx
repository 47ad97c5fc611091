// A static room with baked indirect light, and a ball that bounces through it, lit by baked probes:
// baked_room FOLDER [FRAMES] [WIDTH]
// The walls are rectangles, whose texels are easy to place; `penumbra bake lightmap` unwraps any surface.
#include "Film.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkGILightGatherer.h>
#include <vtkGILightmap.h>
#include <vtkGIPass.h>
#include <vtkGIProbeBaker.h>
#include <vtkGISHProbes.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>

#include <array>
#include <cmath>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;

// A corner, the vectors to the two neighbouring corners (whose cross product points into the room), and a colour.
struct Wall
{
  Vector Corner, U, V;
  Color Paint;

  Vector At(double s, double t) const
  {
    Vector point;
    for (int i = 0; i < 3; ++i)
    {
      point[i] = this->Corner[i] + s * this->U[i] + t * this->V[i];
    }
    return point;
  }
  Vector Normal() const
  {
    Vector normal;
    vtkMath::Cross(this->U.data(), this->V.data(), normal.data());
    vtkMath::Normalize(normal.data());
    return normal;
  }
};
const std::vector<Wall> Walls = {
  { { -1, -1, -1 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0.75, 0.75, 0.75 } },
  { { -1, -1, 1 }, { 0, 2, 0 }, { 2, 0, 0 }, { 0.75, 0.75, 0.75 } },
  { { -1, 1, -1 }, { 2, 0, 0 }, { 0, 0, 2 }, { 0.75, 0.75, 0.75 } },
  { { -1, -1, -1 }, { 0, 2, 0 }, { 0, 0, 2 }, { 0.8, 0.15, 0.1 } },
  { { 1, -1, -1 }, { 0, 0, 2 }, { 0, 2, 0 }, { 0.15, 0.6, 0.2 } },
};
constexpr int Texels = 32;     // along each side of a wall
constexpr double Radius = 0.3; // of the ball
constexpr double Pi = 3.14159265358979323846;

// The walls for the lightmap: triangles with normals, texture coordinates in the map, in which the walls are stacked,
// and a description of the baked scene.
vtkSmartPointer<vtkPolyData> MakeSurfaces(vtkRenderer* renderer)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> triangles;
  const auto center = [](double share) { return (0.5 + share * (Texels - 1)) / Texels; };
  for (std::size_t number = 0; number < Walls.size(); ++number)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (const std::array<int, 2>& corner :
      { std::array<int, 2>{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      points->InsertNextPoint(Walls[number].At(corner[0], corner[1]).data());
      normals->InsertNextTuple(Walls[number].Normal().data());
      coordinates->InsertNextTuple2(center(corner[0]), (number + center(corner[1])) / Walls.size());
    }
    triangles->InsertNextCell({ first, first + 1, first + 2 });
    triangles->InsertNextCell({ first, first + 2, first + 3 });
  }
  vtkNew<vtkStringArray> scene;
  scene->SetName("scene");
  scene->InsertNextValue(vtkGILightmap::DescribeScene(renderer));
  auto surfaces = vtkSmartPointer<vtkPolyData>::New();
  surfaces->SetPoints(points);
  surfaces->SetPolys(triangles);
  surfaces->GetPointData()->SetNormals(normals);
  surfaces->GetPointData()->SetTCoords(coordinates);
  surfaces->GetFieldData()->AddArray(scene);
  return surfaces;
}

// Gathers the light at the centres of the texels, which run from edge to edge of each wall.
vtkSmartPointer<vtkImageData> GatherLight(vtkRenderer* renderer)
{
  vtkNew<vtkFloatArray> points;
  points->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  // Slightly inside, because other walls begin at the edges.
  const auto step = [](int texel) { return 0.002 + 0.996 * texel / (Texels - 1); };
  for (const Wall& wall : Walls)
  {
    for (int t = 0; t < Texels; ++t)
    {
      for (int s = 0; s < Texels; ++s)
      {
        points->InsertNextTuple(wall.At(step(s), step(t)).data());
        normals->InsertNextTuple(wall.Normal().data());
      }
    }
  }
  vtkNew<vtkGILightGatherer> gatherer;
  gatherer->SetSamples(512);
  vtkNew<vtkFloatArray> light;
  if (!gatherer->Gather(renderer, points, normals, light))
  {
    Film::Fail(gatherer->GetLastError());
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Texels, Texels * static_cast<int>(Walls.size()), 1);
  image->GetPointData()->SetScalars(light);
  return image;
}
}

int main(int argc, char* argv[])
{
  const Film film(argc, argv);
  vtkNew<vtkRenderer> renderer;
  for (const Wall& wall : Walls)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(wall.At(0, 0).data());
    plane->SetPoint1(wall.At(1, 0).data());
    plane->SetPoint2(wall.At(0, 1).data());
    renderer->AddActor(MakeActor(plane, wall.Paint));
  }
  AddLamp(renderer, 0.3, -0.3, 0.7)->SetIntensity(0.5);
  vtkSmartPointer<vtkRenderWindow> window = Aim(renderer, { 0, -4.2, 0 }, 32, film.Width);

  // Bake a lightmap for the walls, and probes for moving objects. The ball is added afterwards.
  vtkNew<vtkGIPass> gi;
  gi->SetPreset("fast");
  renderer->SetPass(gi);
  auto* map = vtkGILightmap::SafeDownCast(gi->GetTechnique("lightmap"));
  map->SetBake(MakeSurfaces(renderer), GatherLight(renderer));
  map->EnabledOn();
  vtkNew<vtkGIProbeBaker> baker;
  baker->SetProbes(343);
  baker->SetSamples(512);
  vtkNew<vtkImageData> field;
  if (!baker->Bake(renderer, field))
  {
    Film::Fail(baker->GetLastError());
  }
  auto* probes = vtkGISHProbes::SafeDownCast(gi->GetTechnique("sh-probes"));
  probes->SetBake(field);
  probes->EnabledOn();

  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(Radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(32);
  vtkSmartPointer<vtkActor> ball = MakeActor(sphere, { 0.9, 0.9, 0.9 });
  renderer->AddActor(ball);
  for (int frame = 0; frame < film.Frames; ++frame)
  {
    const double angle = 2 * Pi * frame / film.Frames;
    ball->SetPosition(
      -0.65 * std::cos(angle), -0.2, Radius - 1 + 0.9 * std::abs(std::sin(2 * angle)));
    window->Render();
    const std::string notes = gi->GetNotes();
    if (!notes.empty())
    {
      Film::Fail(notes); // the scene would not be lit by the bakes
    }
    film.Save(window, frame);
  }
  return EXIT_SUCCESS;
}
