// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What rays are traced against: meshes with a tree each, and instances of them under a tree of
 * their own. A change costs what changed: a mesh its own tree, an instance the top level only.
 *
 * The caller names meshes and instances by numbers of its own (an address, an index). Coordinates
 * are doubles here and floats relative to SetOrigin() in the shader.
 */
#pragma once

#include "gpu/ShaderLibrary.h"
#include "rays/RayBuffer.h"
#include "rays/RayMesh.h"

#include <cstdint>
#include <map>
#include <memory>

namespace penumbra
{
class RayScene
{
public:
  using Key = std::uint64_t;

  RayScene();
  ~RayScene();

  /// Give a mesh, new or in place of the one of this name.
  void SetMesh(Key mesh, const RayGeometry& geometry);
  /// The mesh's points moved. Builds it anew where it has other primitives or is not there yet.
  void RefitMesh(Key mesh, const RayGeometry& geometry);
  void RemoveMesh(Key mesh);
  bool HasMesh(Key mesh) const { return this->Meshes.count(mesh) > 0; }

  /// Place a mesh in the world, or move what was placed under this name. Hits report `user`.
  void SetInstance(Key instance, Key mesh, const glm::dmat4& meshToWorld, std::int32_t user = 0);
  /// Place a mesh many times under one name, at places before meshToWorld. The places are kept, not
  /// copied: for others, give another vector.
  using Places = std::shared_ptr<const std::vector<RayPlace>>;
  void SetInstances(
    Key instance, Key mesh, const glm::dmat4& meshToWorld, std::int32_t user, const Places& places);
  void RemoveInstance(Key instance);
  void Clear();

  /// What the shader's coordinates are relative to: near the camera. Costs the top level.
  void SetOrigin(const glm::dvec3& origin);
  const glm::dvec3& Origin() const { return this->Center; }

  /// Bring the context's buffers up to date with all of the above. Throws std::runtime_error where
  /// the scene does not fit, naming the sizes.
  void Update();
  /// For shaders that include rays/trace.glsl.
  Arguments ShaderArguments() const;
  /// The variant of those shaders that this scene needs.
  Defines ShaderDefines() const;

  /// The name of the instance that hits report as `index`; valid until the next Update().
  Key InstanceAt(std::int32_t index) const { return this->Names[index]; }
  std::size_t DroppedPrimitives() const;
  /// Instances left out: of no surface, or not finite.
  std::size_t DroppedInstances() const { return this->Unplaced; }
  std::size_t Bytes() const;

  /// Free what the context holds, and the meshes with it: their records are there only, so their
  /// owner gives them again. Instances stay. The context must be current.
  void ReleaseGraphicsResources();

private:
  struct Placed;
  struct Instance;
  struct Placing;

  void Free(Placed& mesh);
  void Upload(Placed& mesh);
  void UpdateTop();
  std::size_t Place(const Placing& group, std::size_t begin, std::size_t end) const;

  RayBuffer Nodes;
  RayBuffer Primitives;
  RayBuffer Instances;
  std::map<Key, std::unique_ptr<Placed>> Meshes;
  std::map<Key, Instance> All;
  std::vector<Key> Names;
  glm::dvec3 Center{ 0.0 };
  std::size_t TopFirst = 0, TopCount = 0;
  std::size_t InstancesCount = 0;
  std::size_t Unplaced = 0;
  bool TopChanged = true;
};
}
