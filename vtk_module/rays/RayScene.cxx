// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayScene.h"

#include "base/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace penumbra
{
struct RayScene::MeshEntry
{
  explicit MeshEntry(const RayGeometry& geometry)
    : Mesh(geometry)
  {
  }
  RayMesh Mesh;
  std::size_t FirstNode = 0, NodeCount = 0;     ///< in the context
  std::size_t FirstRecord = 0, RecordCount = 0; ///< in the context
  bool Changed = true;

  std::int32_t Root() const
  {
    return RayTree::Moved(this->Mesh.Tree().Root, static_cast<std::int32_t>(this->FirstNode),
      static_cast<std::int32_t>(this->FirstRecord));
  }
};

struct RayScene::Instance
{
  Key Mesh = 0;
  glm::dmat4 MeshToWorld{ 1.0 };
  std::int32_t User = 0;
  RayScene::Places At; ///< null for a single instance at MeshToWorld

  std::size_t Count() const { return this->At ? this->At->size() : 1; }
};

/// Range of an entry's instances in the arrays from which the top level is built.
struct RayScene::InstanceRange
{
  const Instance* Entry;
  const MeshEntry* Mesh;
  std::size_t First;
  RayBounds* Bounds;
  shared::RayInstance* Records;
};

RayScene::RayScene()
  : Nodes("tree nodes", GI_RAY_NODE_TEXELS)
  , Primitives("primitives", GI_RAY_PRIMITIVE_TEXELS)
  , Instances("instances", GI_RAY_INSTANCE_TEXELS)
{
}

RayScene::~RayScene() = default;

void RayScene::SetMesh(Key mesh, const RayGeometry& geometry)
{
  auto placed = std::make_unique<MeshEntry>(geometry);
  std::unique_ptr<MeshEntry>& slot = this->Meshes[mesh];
  if (slot)
  {
    this->Free(*slot);
  }
  slot = std::move(placed);
  this->TopChanged = true;
}

void RayScene::RefitMesh(Key mesh, const RayGeometry& geometry)
{
  const auto found = this->Meshes.find(mesh);
  if (found == this->Meshes.end() || !found->second->Mesh.Refit(geometry))
  {
    this->SetMesh(mesh, geometry);
    return;
  }
  found->second->Changed = true;
  this->TopChanged = true;
}

void RayScene::RemoveMesh(Key mesh)
{
  const auto found = this->Meshes.find(mesh);
  if (found != this->Meshes.end())
  {
    this->Free(*found->second);
    this->Meshes.erase(found);
    this->TopChanged = true;
  }
}

void RayScene::SetInstance(Key instance, Key mesh, const glm::dmat4& meshToWorld, std::int32_t user)
{
  this->SetInstances(instance, mesh, meshToWorld, user, nullptr);
}

void RayScene::SetInstances(
  Key instance, Key mesh, const glm::dmat4& meshToWorld, std::int32_t user, const Places& places)
{
  this->InstancesByKey[instance] = { mesh, meshToWorld, user, places };
  this->TopChanged = true;
}

void RayScene::RemoveInstance(Key instance)
{
  this->TopChanged |= this->InstancesByKey.erase(instance) > 0;
}

void RayScene::Clear()
{
  for (auto& mesh : this->Meshes)
  {
    this->Free(*mesh.second);
  }
  this->Meshes.clear();
  this->InstancesByKey.clear();
  this->TopChanged = true;
}

void RayScene::SetOrigin(const glm::dvec3& origin)
{
  this->TopChanged |= origin != this->Center;
  this->Center = origin;
}

void RayScene::Free(MeshEntry& mesh)
{
  this->Nodes.Free(mesh.FirstNode, mesh.NodeCount);
  this->Primitives.Free(mesh.FirstRecord, mesh.RecordCount);
  mesh.NodeCount = mesh.RecordCount = 0;
}

void RayScene::Upload(MeshEntry& mesh)
{
  const RayTree& tree = mesh.Mesh.Tree();
  if (tree.Nodes.size() != mesh.NodeCount || tree.Order.size() != mesh.RecordCount)
  {
    this->Free(mesh);
    mesh.FirstNode = tree.Nodes.empty() ? 0 : this->Nodes.Allocate(tree.Nodes.size());
    mesh.NodeCount = tree.Nodes.size();
    mesh.FirstRecord = tree.Order.empty() ? 0 : this->Primitives.Allocate(tree.Order.size());
    mesh.RecordCount = tree.Order.size();
  }
  // Offset references in blocks, so that no second copy of the whole mesh is needed.
  constexpr std::size_t part = 65536;
  std::vector<shared::RayNode> moved;
  const auto nodes = static_cast<std::int32_t>(mesh.FirstNode);
  const auto records = static_cast<std::int32_t>(mesh.FirstRecord);
  for (std::size_t begin = 0; begin < tree.Nodes.size(); begin += part)
  {
    const std::size_t end = std::min(begin + part, tree.Nodes.size());
    moved.assign(tree.Nodes.begin() + begin, tree.Nodes.begin() + end);
    for (shared::RayNode& node : moved)
    {
      node.Child0 = RayTree::Moved(node.Child0, nodes, records);
      node.Child1 = RayTree::Moved(node.Child1, nodes, records);
    }
    this->Nodes.Write(mesh.FirstNode + begin, moved.data(), moved.size());
  }
  this->Primitives.Write(mesh.FirstRecord, mesh.Mesh.Records().data(), mesh.Mesh.Records().size());
  mesh.Mesh.ReleaseRecords();
  mesh.Changed = false;
}

void RayScene::Update()
{
  for (auto& mesh : this->Meshes)
  {
    if (mesh.second->Changed)
    {
      this->Upload(*mesh.second);
    }
  }
  if (this->TopChanged)
  {
    this->UpdateTop();
    this->TopChanged = false;
  }
}

namespace
{
/// Bounds of a transformed box, rounded outwards.
RayBounds TransformedBounds(const RayBounds& box, const glm::dmat4& meshToScene)
{
  glm::dvec3 lower(HUGE_VAL);
  glm::dvec3 upper(-HUGE_VAL);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at(corner & 1 ? box.Upper.x : box.Lower.x,
      corner & 2 ? box.Upper.y : box.Lower.y, corner & 4 ? box.Upper.z : box.Lower.z);
    const glm::dvec3 there(meshToScene * glm::dvec4(at, 1.0));
    lower = glm::min(lower, there);
    upper = glm::max(upper, there);
  }
  RayBounds bounds{ glm::vec3(lower), glm::vec3(upper) };
  // The shader's float arithmetic across the box may differ by some units in the last place.
  const bool finite = bounds.LargestCoordinate() < RayCoordinateLimit;
  return finite ? bounds.Grown(std::ldexp(bounds.LargestCoordinate(), -21)) : RayBounds();
}

// Computes the transformation of rays from the scene to a mesh. Returns false if it has no inverse in floats.
bool Invert(const glm::dmat4& meshToScene, shared::RayInstance& record)
{
  const glm::dmat4 rows = glm::transpose(glm::inverse(meshToScene));
  bool finite = true;
  for (int row = 0; row < 3; ++row)
  {
    record.SceneToMesh[row] = glm::vec4(rows[row]);
    for (int column = 0; column < 4; ++column)
    {
      finite = finite && std::isfinite(record.SceneToMesh[row][column]);
    }
  }
  return finite;
}

// VTK draws a mesh that is scaled to zero along one axis as a flat object, but its matrix has no inverse. Give the mesh
// a thickness of a millionth of its width. A mesh that is scaled to zero along two or three axes has no surface.
glm::dmat4 WithThickness(const glm::dmat4& meshToScene, const RayBounds& box)
{
  const glm::dvec3 size(box.Upper - box.Lower);
  const double least = 1e-6 * std::max({ size.x, size.y, size.z });
  glm::dmat3 m(meshToScene);
  for (int axis = 0; axis < 3; ++axis)
  {
    m[axis] *= std::max(size[axis], least);
  }
  // For a matrix of rank two: the direction across the remaining plane, times the vanished axis.
  const glm::dmat3 cofactors(
    glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const auto norm = [](const glm::dmat3& a) {
    return std::sqrt(glm::dot(a[0], a[0]) + glm::dot(a[1], a[1]) + glm::dot(a[2], a[2]));
  };
  m += cofactors * ((glm::determinant(m) < 0.0 ? -1e-6 : 1e-6) * norm(m) / norm(cofactors));
  glm::dmat4 result(meshToScene);
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = glm::dvec4(m[axis] / std::max(size[axis], least), 0.0);
  }
  return result;
}
}

std::size_t RayScene::Place(const InstanceRange& group, std::size_t begin, std::size_t end) const
{
  const RayMesh& shape = group.Mesh->Mesh;
  const RayBounds margin = shape.Tree().Bounds.Grown(RayTree::Margin(shape.Tree().Bounds));
  std::size_t unplaced = 0;
  for (std::size_t i = begin; i < end; ++i)
  {
    const std::size_t index = group.First + i;
    glm::dmat4 meshToScene = group.Entry->MeshToWorld;
    shared::RayInstance& record = group.Records[index];
    record.Color = 0xffffffffu;
    if (group.Entry->At)
    {
      const RayPlace& place = (*group.Entry->At)[i];
      glm::dmat4 there{ glm::dmat3(place.Turn) };
      there[3] = glm::dvec4(place.At, 1.0);
      meshToScene = meshToScene * there;
      record.Color = place.Color;
    }
    meshToScene[3] = meshToScene * glm::dvec4(shape.Origin(), 1.0);
    meshToScene[3] -= glm::dvec4(this->Center, 0.0);
    bool usable = Invert(meshToScene, record);
    if (!usable)
    {
      meshToScene = WithThickness(meshToScene, shape.Tree().Bounds);
      usable = Invert(meshToScene, record);
    }
    group.Bounds[index] = TransformedBounds(margin, meshToScene);
    if (!usable || group.Bounds[index].IsEmpty())
    {
      group.Bounds[index] = RayBounds();
      ++unplaced;
    }
    record.Root = group.Mesh->Root();
    record.Instance = static_cast<std::int32_t>(index);
    record.User = group.Entry->User;
  }
  return unplaced;
}

void RayScene::UpdateTop()
{
  std::size_t count = 0;
  for (const auto& item : this->InstancesByKey)
  {
    count += item.second.Count();
  }
  std::vector<RayBounds> bounds(count);
  std::vector<shared::RayInstance> records(count);
  this->Names.clear();
  std::atomic<std::size_t> unplaced{ 0 };
  for (const auto& item : this->InstancesByKey)
  {
    const std::size_t first = this->Names.size();
    this->Names.resize(first + item.second.Count(), item.first);
    const auto mesh = this->Meshes.find(item.second.Mesh);
    if (mesh != this->Meshes.end() && mesh->second->Mesh.Tree().Root != GI_RAY_DONE)
    {
      const InstanceRange group = { &item.second, mesh->second.get(), first, bounds.data(),
        records.data() };
      ParallelFor(item.second.Count(),
        [&](std::size_t begin, std::size_t end) { unplaced += this->Place(group, begin, end); });
    }
  }
  this->DroppedInstanceCount = unplaced;

  RayTree top;
  top.Build(bounds, 1, GI_RAY_TOP_DEPTH);
  this->TopDepth = top.Depth;
  this->ReadsTextures = !IsSoftwareContext();
  if (top.Nodes.size() > this->TopCount)
  {
    this->Nodes.Free(this->TopFirst, this->TopCount);
    this->TopCount = 0;
    this->TopFirst = this->Nodes.Allocate(top.Nodes.size());
    this->TopCount = top.Nodes.size();
  }
  const auto first = static_cast<std::int32_t>(this->TopFirst);
  for (shared::RayNode& node : top.Nodes)
  {
    node.Child0 = RayTree::Moved(node.Child0, first, 0);
    node.Child1 = RayTree::Moved(node.Child1, first, 0);
  }
  this->Nodes.Write(this->TopFirst, top.Nodes.data(), top.Nodes.size());

  std::vector<shared::RayInstance> ordered(1);
  ordered[0].Root = top.Root == GI_RAY_DONE ? GI_RAY_DONE : RayTree::Moved(top.Root, first, 0);
  for (const std::uint32_t item : top.Order)
  {
    ordered.push_back(records[item]);
  }
  if (ordered.size() > this->InstancesCount)
  {
    this->Instances.Free(0, this->InstancesCount);
    this->InstancesCount = 0;
    this->Instances.Allocate(ordered.size()); // the only block, so it starts at 0
    this->InstancesCount = ordered.size();
  }
  this->Instances.Write(0, ordered.data(), ordered.size());
}

Arguments RayScene::ShaderArguments() const
{
  Arguments arguments;
  for (const auto& [buffer, name] :
    { std::pair{ &this->Nodes, "rayNodes" }, std::pair{ &this->Primitives, "rayPrimitives" },
      std::pair{ &this->Instances, "rayInstances" } })
  {
    buffer->AddImage(arguments, name);
    buffer->AddSampler(arguments, name);
  }
  return arguments;
}

Defines RayScene::ShaderDefines() const
{
  Defines defines;
  if (this->ReadsTextures)
  {
    defines["GI_RAY_TEXTURES"] = "1";
  }
  int depth = 0;
  for (const auto& mesh : this->Meshes)
  {
    depth = std::max(depth, mesh.second->Mesh.Tree().Depth);
    if (mesh.second->Mesh.HasSpheres())
    {
      defines["GI_RAY_SPHERES"] = "1";
    }
    if (mesh.second->Mesh.HasCylinders())
    {
      defines["GI_RAY_CYLINDERS"] = "1";
    }
  }
  if (this->TopDepth + depth + GI_RAY_MARKS <= GI_RAY_SHORT_STACK)
  {
    defines["GI_RAY_SHALLOW"] = "1";
  }
  return defines;
}

std::size_t RayScene::DroppedPrimitives() const
{
  std::size_t dropped = 0;
  for (const auto& mesh : this->Meshes)
  {
    dropped += mesh.second->Mesh.Dropped();
  }
  return dropped;
}

std::size_t RayScene::Bytes() const
{
  return this->Nodes.Used() * this->Nodes.RecordBytes() +
    this->Primitives.Used() * this->Primitives.RecordBytes() +
    this->Instances.Used() * this->Instances.RecordBytes();
}

void RayScene::ReleaseGraphicsResources()
{
  this->Nodes.Release();
  this->Primitives.Release();
  this->Instances.Release();
  this->TopFirst = this->TopCount = this->InstancesCount = 0;
  this->Meshes.clear();
  this->TopChanged = true;
}
}
