// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayProps.h"

#include "base/Luminance.h"
#include "base/Matrices.h"

#include "vtkRenderer.h"

#include <algorithm>
#include <cstring>

namespace penumbra
{
void RayProps::Update(vtkRenderer* renderer, const std::vector<RayPart>& others)
{
  std::vector<vtkProp*> left;
  std::vector<RayPart> parts = GatherRayParts(renderer, left, this->Cache);
  this->LeftOutCount = left.size();
  this->TracedProps.clear();
  for (const RayPart& part : parts)
  {
    this->TracedProps.insert(part.Prop);
  }
  for (vtkProp* prop : left)
  {
    this->TracedProps.erase(prop);
  }
  parts.insert(parts.end(), others.begin(), others.end());
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  glm::dvec3 center = this->Scene.Origin();
  if (bounds[0] <= bounds[1])
  {
    center = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]) };
  }
  this->Scene.SetOrigin(center);
  this->UpdateMeshes(parts);
  this->UpdateAttributes(parts);

  std::vector<shared::RaySurface> surfaces;
  std::vector<std::int32_t> indices;
  std::vector<glm::vec3> meanColors;
  this->Partly = false;
  this->Edges = false;
  for (const RayPart& part : parts)
  {
    const Block& block = this->Blocks[part.AttributeKey];
    indices.push_back(static_cast<std::int32_t>(surfaces.size()));
    surfaces.push_back(part.Surface);
    if (part.HasBack)
    {
      surfaces.back().Where.w = indices.back() + 1;
      surfaces.push_back(part.Back);
    }
    const auto first = static_cast<std::size_t>(indices.back());
    meanColors.push_back(this->UpdatePictures(part, &surfaces[first], surfaces.size() - first));
    for (std::size_t i = first; i < surfaces.size(); ++i)
    {
      surfaces[i].Where.x = static_cast<int>(block.FirstPrimitive);
      surfaces[i].Where.y = static_cast<int>(block.FirstPoint);
      surfaces[i].Where.z |= part.Clip.empty() ? 0 : GI_SURFACE_PARTLY;
      this->Partly |= (surfaces[i].Where.z & GI_SURFACE_PARTLY) != 0;
      this->Edges |= surfaces[i].Edge.a > 0.0f;
    }
  }
  this->Pictures.Sweep();
  this->Sky.Update(renderer);
  this->UpdateClipping(parts, surfaces, indices);
  this->UpdatePlaces(parts, indices);
  this->Emitters.Update(parts, surfaces, indices, meanColors, this->Scene.Origin());
  if (surfaces.empty())
  {
    surfaces.emplace_back(); // an empty buffer cannot be bound
  }
  const bool same = surfaces.size() == this->Surfaces.size() &&
    std::memcmp(surfaces.data(), this->Surfaces.data(), surfaces.size() * sizeof(surfaces[0])) == 0;
  if (!same)
  {
    this->Surfaces = surfaces;
    this->SurfaceStorage.Upload(
      GL_SHADER_STORAGE_BUFFER, surfaces.data(), surfaces.size() * sizeof(surfaces[0]));
  }
  this->Scene.Update();
}

void RayProps::UpdateMeshes(const std::vector<RayPart>& parts)
{
  for (auto& shape : this->Shapes)
  {
    shape.second.Used = false;
  }
  for (const RayPart& part : parts)
  {
    const auto found = this->Shapes.find(part.MeshKey);
    const bool known = found != this->Shapes.end();
    Shape& shape = known ? found->second : this->Shapes[part.MeshKey];
    const bool moved =
      known && shape.CellTime == part.CellTime && shape.PointTime != part.PointTime;
    if (!known || shape.CellTime != part.CellTime || moved)
    {
      const RayGeometry geometry = part.MakeGeometry();
      moved ? this->Scene.RefitMesh(part.MeshKey, geometry)
            : this->Scene.SetMesh(part.MeshKey, geometry);
      shape.Size = geometry.Size();
      shape.CellTime = part.CellTime;
      shape.PointTime = part.PointTime;
    }
    shape.Used = true;
  }
  this->Primitives = 0;
  for (auto it = this->Shapes.begin(); it != this->Shapes.end();)
  {
    this->Primitives += it->second.Used ? it->second.Size : 0;
    if (it->second.Used)
    {
      ++it;
      continue;
    }
    this->Scene.RemoveMesh(it->first);
    it = this->Shapes.erase(it);
  }
}

void RayProps::UpdateAttributes(const std::vector<RayPart>& parts)
{
  this->LackNormals = 0;
  for (auto& block : this->Blocks)
  {
    block.second.Used = false;
  }
  for (const RayPart& part : parts)
  {
    Block& block = this->Blocks[part.AttributeKey];
    if (block.Time != part.AttributeTime)
    {
      const RayAttributes attributes = part.MakeAttributes();
      if (block.PrimitiveCount != attributes.Primitives.size() ||
        block.PointCount != attributes.Points.size())
      {
        this->Attributes.Free(block.FirstPrimitive, block.PrimitiveCount);
        this->Points.Free(block.FirstPoint, block.PointCount);
        block = Block();
        // Allocate() may throw. Counts stay zero until their block exists.
        const std::size_t primitives = attributes.Primitives.size();
        const std::size_t points = attributes.Points.size();
        block.FirstPrimitive = primitives ? this->Attributes.Allocate(primitives) : 0;
        block.PrimitiveCount = primitives;
        block.FirstPoint = points ? this->Points.Allocate(points) : 0;
        block.PointCount = points;
      }
      this->Attributes.Write(
        block.FirstPrimitive, attributes.Primitives.data(), block.PrimitiveCount);
      this->Points.Write(block.FirstPoint, attributes.Points.data(), block.PointCount);
      block.Time = part.AttributeTime;
      block.LacksNormals = attributes.LacksNormals;
    }
    block.Used = true;
    this->LackNormals += block.LacksNormals && (part.Surface.Where.z & GI_SURFACE_SMOOTH) != 0;
  }
  for (auto it = this->Blocks.begin(); it != this->Blocks.end();)
  {
    if (it->second.Used)
    {
      ++it;
      continue;
    }
    this->Attributes.Free(it->second.FirstPrimitive, it->second.PrimitiveCount);
    this->Points.Free(it->second.FirstPoint, it->second.PointCount);
    it = this->Blocks.erase(it);
  }
}

glm::vec3 RayProps::UpdatePictures(
  const RayPart& part, shared::RaySurface* surfaces, std::size_t count)
{
  std::array<RayPictures::Picture, PictureSlots> pictures;
  for (std::size_t slot = 0; slot < pictures.size(); ++slot)
  {
    if (part.Pictures[slot])
    {
      pictures[slot] = this->Pictures.Use(part.Pictures[slot]);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    shared::RaySurface& surface = surfaces[i];
    surface.Pictures = glm::ivec4(pictures[BasePicture].First, pictures[MaterialPicture].First,
      (surface.Where.z & GI_SURFACE_TANGENTS) ? pictures[NormalPicture].First : -1,
      pictures[EmissionPicture].First);
    surface.More.x = glm::intBitsToFloat(pictures[ColorPicture].First);
    surface.Where.z |=
      pictures[BasePicture].Partly || pictures[ColorPicture].Partly ? GI_SURFACE_PARTLY : 0;
  }
  const bool phong = (surfaces->Where.z & GI_SURFACE_MODEL) == GI_SURFACE_PHONG;
  return phong ? pictures[BasePicture].Mean : pictures[EmissionPicture].Mean;
}

void RayProps::UpdateClipping(const std::vector<RayPart>& parts,
  std::vector<shared::RaySurface>& surfaces, const std::vector<std::int32_t>& indices)
{
  std::vector<glm::vec4> planes;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const glm::ivec4 clip(
      static_cast<int>(planes.size()), static_cast<int>(parts[i].Clip.size()), 0, 0);
    for (const glm::dvec4& plane : parts[i].Clip)
    {
      const double distance = glm::dot(glm::dvec3(plane), this->Scene.Origin()) + plane.w;
      planes.emplace_back(glm::vec3(plane), static_cast<float>(distance));
    }
    surfaces[indices[i]].Clip = clip;
    if (parts[i].HasBack)
    {
      surfaces[indices[i] + 1].Clip = clip;
    }
  }
  if (planes != this->Planes)
  {
    if (planes.size() != this->Planes.size())
    {
      this->Points.Free(this->FirstPlane, this->Planes.size());
      this->Planes.clear();
      this->FirstPlane = planes.empty() ? 0 : this->Points.Allocate(planes.size());
    }
    this->Planes = planes;
    this->Points.Write(this->FirstPlane, planes.data(), planes.size());
  }
  for (shared::RaySurface& surface : surfaces)
  {
    surface.Clip.x += static_cast<int>(this->FirstPlane);
  }
}

void RayProps::UpdatePlaces(
  const std::vector<RayPart>& parts, const std::vector<std::int32_t>& surfaces)
{
  for (std::size_t i = parts.size(); i < this->Places.size(); ++i)
  {
    this->Scene.RemoveInstance(i);
  }
  this->Places.resize(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    Place& place = this->Places[i];
    const bool same = place.Mesh == parts[i].MeshKey && place.ToWorld == parts[i].ToWorld &&
      place.Surface == surfaces[i] && place.Many == parts[i].Places;
    if (!same)
    {
      place = { parts[i].MeshKey, parts[i].ToWorld, surfaces[i], parts[i].Places };
      this->Scene.SetInstances(i, place.Mesh, place.ToWorld, place.Surface, place.Many);
    }
  }
}

Arguments RayProps::ShaderArguments() const
{
  Arguments arguments = this->Scene.ShaderArguments();
  this->Attributes.AddSampler(arguments, "rayAttributes");
  this->Points.AddSampler(arguments, "rayPoints");
  if (!this->Pictures.IsEmpty())
  {
    this->Pictures.AddTo(arguments);
  }
  if (this->Sky.Shines())
  {
    this->Sky.AddTo(arguments);
  }
  this->Emitters.AddTo(arguments);
  return arguments.Block("RaySurfaceBlock", this->SurfaceStorage)
    .Add(this->Rules.ShaderArguments());
}

Arguments RayProps::SkyCells(int rays)
{
  Arguments arguments;
  if (this->Sky.Shines())
  {
    this->Sky.AddCells(arguments, rays);
  }
  return arguments;
}

Defines RayProps::ShaderDefines() const
{
  Defines defines = this->Scene.ShaderDefines();
  if (this->Edges)
  {
    defines["GI_RAY_EDGES"] = "1";
  }
  if (this->Partly)
  {
    defines["GI_RAY_PARTLY"] = "1";
  }
  if (!this->Pictures.IsEmpty())
  {
    defines["GI_RAY_PICTURES"] = "1";
  }
  if (this->Sky.Shines())
  {
    defines["GI_RAY_SKY"] = "1";
  }
  if (!this->Planes.empty())
  {
    defines["GI_RAY_CLIPPED"] = "1";
  }
  return defines;
}

void RayProps::ReleaseGraphicsResources()
{
  this->Scene.ReleaseGraphicsResources();
  this->Scene.Clear();
  this->Attributes.Release();
  this->Points.Release();
  this->Pictures.Release();
  this->Sky.Release();
  this->SurfaceStorage = Buffer();
  this->Emitters.ReleaseGraphicsResources();
  this->Shapes.clear();
  this->Blocks.clear();
  this->Places.clear();
  this->Surfaces.clear();
  this->Planes.clear();
}
}
