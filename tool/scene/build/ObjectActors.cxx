// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/ObjectActors.h"

#include "common/Failure.h"
#include "common/Reporter.h"
#include "scene/build/ColorMaps.h"
#include "scene/build/Materials.h"
#include "scene/build/Molecules.h"
#include "scene/build/Shapes.h"
#include "scene/readers/CleanGeometry.h"
#include "scene/readers/Formats.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMolecule.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace penumbra::tool
{
namespace
{
LoadedData LoadObject(const Object& object, Reporter& reporter)
{
  if (!object.Path.empty())
  {
    return Load(object.Path, reporter);
  }
  LoadedData loaded;
  loaded.View = { { 0, -1, 0 }, { 0, 0, 1 }, 25, 25 };
  loaded.Data =
    object.Shape ? MakePrimitive(*object.Shape) : MakeMesh(*object.Geometry, Describe(object));
  return loaded;
}

void Place(const Object& object, vtkActor* actor)
{
  if (object.Place)
  {
    const Placement& place = *object.Place;
    actor->RotateX(place.Rotate[0]);
    actor->RotateY(place.Rotate[1]);
    actor->RotateZ(place.Rotate[2]);
    actor->SetPosition(place.Translate[0], place.Translate[1], place.Translate[2]);
    actor->SetScale(place.Scale[0], place.Scale[1], place.Scale[2]);
  }
}

/// The object's radius of balls or tubes, or by default a share of the diagonal.
double DefaultRadius(vtkPolyData* geometry, const Object& object, double share)
{
  const double diagonal = geometry->GetLength();
  return object.Radius > 0 ? object.Radius : share * (diagonal > 0 ? diagonal : 1);
}

bool HasOnlyLines(vtkPolyData* geometry)
{
  return geometry->GetNumberOfLines() > 0 &&
    geometry->GetNumberOfPolys() + geometry->GetNumberOfStrips() == 0;
}

/// Lines as tubes, which are lit and cast shadows.
vtkSmartPointer<vtkPolyData> AsTubes(vtkPolyData* lines, const Object& object)
{
  constexpr double share = 0.0015;
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(DefaultRadius(lines, object, share));
  tubes->SetNumberOfSides(12);
  tubes->CappingOn();
  tubes->Update();
  return tubes->GetOutput()->GetNumberOfCells() > 0 ? tubes->GetOutput() : lines;
}

bool IsWireframeOrPoints(const Object& object)
{
  return object.Appearance && object.Appearance->Representation != VTK_SURFACE;
}

vtkSmartPointer<vtkPolyData> AsBalls(vtkPolyData* points, const Object& object, double& radius)
{
  // Balls that touch if the points fill the box evenly.
  const double count = std::max<double>(1, points->GetNumberOfPoints());
  radius = DefaultRadius(points, object, 0.25 / std::cbrt(count));
  vtkNew<vtkFloatArray> radii;
  radii->SetName("ball radius");
  radii->SetNumberOfTuples(points->GetNumberOfPoints());
  radii->Fill(radius);
  auto balls = vtkSmartPointer<vtkPolyData>::New();
  balls->ShallowCopy(points);
  balls->GetPointData()->AddArray(radii);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  balls->SetVerts(vertices);
  return balls;
}

class ActorBuilder
{
public:
  ActorBuilder(const Object& object, bool underEnvironment, std::size_t& paletteIndex,
    std::vector<Vec3>& points, Reporter& reporter)
    : Described(object)
    , UnderEnvironment(underEnvironment)
    , PaletteIndex(paletteIndex)
    , Points(points)
    , Notes(reporter)
  {
  }

  ObjectActors Result;

  void AddParts(std::vector<Part> parts, const std::optional<ColorBy>& color)
  {
    if (color)
    {
      this->Result.Coloring = MakeColoring(parts, *color, Describe(this->Described));
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const Material material = this->MaterialOf(i);
      double ballRadius = 0;
      vtkSmartPointer<vtkPolyData> geometry = parts[i].Geometry;
      if (this->Described.PointsAsBalls)
      {
        geometry = AsBalls(geometry, this->Described, ballRadius);
        this->Result.Balls += geometry->GetNumberOfPoints();
      }
      else if (HasOnlyLines(geometry) && !IsWireframeOrPoints(this->Described))
      {
        geometry = AsTubes(geometry, this->Described);
      }
      geometry = this->Prepare(material, geometry);
      vtkSmartPointer<vtkPolyDataMapper> mapper = ballRadius > 0
        ? vtkSmartPointer<vtkPolyDataMapper>(MakeBallMapper(geometry, "ball radius"))
        : vtkSmartPointer<vtkPolyDataMapper>::New();
      mapper->SetInputData(geometry);
      if (color)
      {
        ColorMapper(mapper, geometry, *color, this->Result.Coloring);
      }
      else
      {
        UseOwnColors(mapper, geometry);
      }
      this->Add(mapper, material, geometry, ballRadius);
    }
  }

  void AddMolecule(vtkMolecule* molecule)
  {
    vtkSmartPointer<vtkPolyData> atoms = MakeAtoms(molecule);
    Material material = this->MaterialOf(0);
    const double largest = atoms->GetPointData()->GetArray("radius")->GetRange()[1];
    if (this->Described.Molecule != MoleculeStyle::Balls)
    {
      auto actor = MakeStickModel(molecule, this->Described.Molecule);
      ApplyMaterial(material, actor);
      this->Finish(actor, atoms, largest);
    }
    else
    {
      auto mapper = MakeBallMapper(atoms, "radius");
      if (this->Described.Color)
      {
        this->Result.Coloring =
          MakeColoring({ { atoms, "" } }, *this->Described.Color, Describe(this->Described));
        ColorMapper(mapper, atoms, *this->Described.Color, this->Result.Coloring);
      }
      this->Add(mapper, material, atoms, largest);
    }
    this->Result.Balls += atoms->GetNumberOfPoints();
  }

  /// Actors with materials keep them, unless the object has one.
  void AddImported(const std::vector<vtkSmartPointer<vtkActor>>& actors, DroppedPoints& dropped)
  {
    for (vtkActor* actor : actors)
    {
      auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
      mapper ? mapper->Update() : void();
      vtkPolyData* given = mapper ? mapper->GetInput() : nullptr;
      if (!given || given->GetNumberOfCells() == 0)
      {
        continue;
      }
      vtkSmartPointer<vtkPolyData> geometry = DropNonFinite(given, dropped);
      if (geometry->GetNumberOfCells() > 0 && this->Described.Appearance)
      {
        geometry = this->Prepare(*this->Described.Appearance, geometry);
        ApplyMaterial(*this->Described.Appearance, actor);
      }
      if (geometry != given)
      {
        mapper->SetInputData(geometry);
      }
      if (geometry->GetNumberOfCells() == 0)
      {
        continue;
      }
      this->Result.Triangles += CountTriangles(geometry);
      this->Finish(actor, geometry, 0);
    }
  }

private:
  Material MaterialOf(std::size_t part)
  {
    Material material = this->Described.Appearance
      ? *this->Described.Appearance
      : DefaultMaterial(this->PaletteIndex++, this->UnderEnvironment);
    const auto& opacities = this->Described.Opacities;
    if (!opacities.empty())
    {
      material.Opacity = opacities[std::min(part, opacities.size() - 1)];
    }
    return material;
  }

  vtkSmartPointer<vtkPolyData> Prepare(const Material& material, vtkPolyData* geometry)
  {
    if (HasTextures(material) && !geometry->GetPointData()->GetTCoords() &&
      !std::exchange(this->NotedTextures, true))
    {
      this->Notes.Note(
        fmt::format("{} has no texture coordinates: the textures of its material are not shown",
          Describe(this->Described)));
    }
    return PrepareGeometry(material, geometry);
  }

  /// Uses scalars as colours if they are bytes with three or four components.
  static void UseOwnColors(vtkMapper* mapper, vtkPolyData* geometry)
  {
    vtkDataArray* scalars = geometry->GetPointData()->GetScalars();
    const bool colors = scalars && scalars->GetDataType() == VTK_UNSIGNED_CHAR &&
      scalars->GetNumberOfComponents() >= 3;
    mapper->SetScalarVisibility(colors);
    mapper->SetScalarModeToUsePointData();
  }

  void Add(vtkMapper* mapper, const Material& material, vtkPolyData* geometry, double margin)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    ApplyMaterial(material, actor);
    this->Result.Triangles += CountTriangles(geometry);
    this->Finish(actor, geometry, margin);
  }

  void Finish(vtkActor* actor, vtkPolyData* geometry, double margin)
  {
    Place(this->Described, actor);
    AddFramedPoints(geometry, actor->GetMatrix(), margin, this->Points);
    this->Result.Actors.emplace_back(actor);
  }

  const Object& Described;
  bool UnderEnvironment;
  std::size_t& PaletteIndex;
  std::vector<Vec3>& Points;
  Reporter& Notes;
  bool NotedTextures = false;
};

/// The object's colouring; by default, terrain is coloured by elevation.
std::optional<ColorBy> ColoringOf(const Object& object, const LoadedData& loaded)
{
  const bool terrain = loaded.Kind == Content::Heights || object.Heights;
  if (!terrain || object.Color || object.Appearance)
  {
    return object.Color;
  }
  ColorBy elevation;
  vtkDataArray* heights = loaded.Data->GetAttributes(vtkDataObject::POINT)
    ? loaded.Data->GetAttributes(vtkDataObject::POINT)->GetScalars()
    : nullptr;
  elevation.Array = heights && heights->GetName() ? heights->GetName() : "elevation";
  elevation.Map = "terrain";
  return elevation;
}
}

ObjectActors MakeActors(const Object& object, bool underEnvironment, std::size_t& paletteIndex,
  std::vector<Vec3>& points, const TriangleBudget& budget, Reporter& reporter)
{
  const LoadedData loaded = LoadObject(object, reporter);
  ActorBuilder builder(object, underEnvironment, paletteIndex, points, reporter);
  if (auto* molecule = vtkMolecule::SafeDownCast(loaded.Data))
  {
    if (molecule->GetNumberOfAtoms() == 0)
    {
      Fail("{} holds no atoms: there is nothing to draw", Describe(object));
    }
    builder.AddMolecule(molecule);
  }
  else if (loaded.Kind == Content::Actors)
  {
    DroppedPoints dropped;
    builder.AddImported(loaded.Actors, dropped);
    dropped.Report(Describe(object), reporter);
    if (builder.Result.Actors.empty())
    {
      Fail("{} holds no triangles that could be drawn", Describe(object));
    }
  }
  else
  {
    builder.AddParts(MakeParts(loaded, object, budget, reporter), ColoringOf(object, loaded));
  }
  builder.Result.View = loaded.View;
  if (!object.Color || !object.Color->ScalarBar)
  {
    builder.Result.Coloring = nullptr;
  }
  return builder.Result;
}
}
