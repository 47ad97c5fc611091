// A room that stays as it is, its indirect light baked, and a ball that bounces through it in the light of baked probes:
// baked_room FOLDER [FRAMES] [WIDTH]. The walls are rectangles, whose texels are easy to place; `penumbra bake lightmap`
// unwraps any surface.
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

// A corner, what leads to the two next to it (so that their cross product points into the room), and a colour.
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
  Vector Facing() const
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
constexpr int Texels = 32;     // along a wall
constexpr double Radius = 0.3; // of the ball
constexpr double Pi = 3.14159265358979323846;

// The walls as the map knows them: triangles, their normals, their places in the map, where walls stand above one
// another, and what the light was baked for.
vtkSmartPointer<vtkPolyData> MakeSurfaces(vtkRenderer* renderer)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> triangles;
  const auto middle = [](double share) { return (0.5 + share * (Texels - 1)) / Texels; };
  for (std::size_t number = 0; number < Walls.size(); ++number)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (const std::array<int, 2>& corner :
      { std::array<int, 2>{ 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      points->InsertNextPoint(Walls[number].At(corner[0], corner[1]).data());
      normals->InsertNextTuple(Walls[number].Facing().data());
      places->InsertNextTuple2(middle(corner[0]), (number + middle(corner[1])) / Walls.size());
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
  surfaces->GetPointData()->SetTCoords(places);
  surfaces->GetFieldData()->AddArray(scene);
  return surfaces;
}

// What arrives at the texels' middles, which run from edge to edge of each wall.
vtkSmartPointer<vtkImageData> GatherLight(vtkRenderer* renderer)
{
  vtkNew<vtkFloatArray> points;
  points->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  const auto step = [](int texel) { return 0.002 + 0.996 * texel / (Texels - 1); }; // off the edges
  for (const Wall& wall : Walls)
  {
    for (int t = 0; t < Texels; ++t)
    {
      for (int s = 0; s < Texels; ++s)
      {
        points->InsertNextTuple(wall.At(step(s), step(t)).data());
        normals->InsertNextTuple(wall.Facing().data());
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

  // The walls' light in a map; around them, for what moves, in probes. The ball comes afterwards.
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
    const double turn = 2 * Pi * frame / film.Frames;
    ball->SetPosition(
      -0.65 * std::cos(turn), -0.2, Radius - 1 + 0.9 * std::abs(std::sin(2 * turn)));
    window->Render();
    const std::string notes = gi->GetNotes();
    if (!notes.empty())
    {
      Film::Fail(notes); // the light would not be that of the bakes
    }
    film.Save(window, frame);
  }
  return EXIT_SUCCESS;
}
