// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The acceleration structure for rays: meshes with a tree each, and instances of them in a top-level tree.
 * A changed mesh rebuilds its own tree and the top level, a changed instance only the top level.
 *
 * The caller identifies meshes and instances by its own numbers (an address, an index). Coordinates
 * are doubles here, and floats relative to SetOrigin() in the shader.
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

  /// Add a mesh, or replace the one with this key.
  void SetMesh(Key mesh, const RayGeometry& geometry);
  /// Update a mesh whose points moved. Rebuilds it if it has other primitives or does not exist yet.
  void RefitMesh(Key mesh, const RayGeometry& geometry);
  void RemoveMesh(Key mesh);

  /// Add an instance of a mesh, or replace the one with this key. Hits report `user`.
  void SetInstance(Key instance, Key mesh, const glm::dmat4& meshToWorld, std::int32_t user = 0);
  /// Add many instances of a mesh under one key. Their places apply before meshToWorld. The vector of places is
  /// shared, not copied, and must not be modified.
  using Places = std::shared_ptr<const std::vector<RayPlace>>;
  void SetInstances(
    Key instance, Key mesh, const glm::dmat4& meshToWorld, std::int32_t user, const Places& places);
  void RemoveInstance(Key instance);
  void Clear();

  /// Set the origin of the shader's coordinates, near the camera. A change rebuilds the top level.
  void SetOrigin(const glm::dvec3& origin);
  const glm::dvec3& Origin() const { return this->Center; }

  /// Bring the context's buffers up to date with all changes. Throws std::runtime_error, naming the sizes, if
  /// the scene does not fit.
  void Update();
  /// Arguments of shaders that include rays/trace.glsl.
  Arguments ShaderArguments() const;
  /// Variant of those shaders for this scene.
  Defines ShaderDefines() const;

  /// Key of the instance that hits report as `index`; valid until the next Update().
  Key InstanceAt(std::int32_t index) const { return this->Names[index]; }
  std::size_t DroppedPrimitives() const;
  /// Number of instances that are left out, as they have no surface or are not finite.
  std::size_t DroppedInstances() const { return this->DroppedInstanceCount; }
  std::size_t Bytes() const;

  /// Free the context's objects and the meshes, whose records exist only there: their
  /// owner must set them again. Instances stay. The context must be current.
  void ReleaseGraphicsResources();

private:
  struct MeshEntry;
  struct Instance;
  struct InstanceRange;

  void Free(MeshEntry& mesh);
  void Upload(MeshEntry& mesh);
  void UpdateTop();
  std::size_t Place(const InstanceRange& group, std::size_t begin, std::size_t end) const;

  RayBuffer Nodes;
  RayBuffer Primitives;
  RayBuffer Instances;
  std::map<Key, std::unique_ptr<MeshEntry>> Meshes;
  std::map<Key, Instance> InstancesByKey;
  std::vector<Key> Names;
  glm::dvec3 Center{ 0.0 };
  std::size_t TopFirst = 0, TopCount = 0;
  std::size_t InstancesCount = 0;
  int TopDepth = 0;
  bool ReadsTextures = false; ///< rather than images, see shared/ray_scene.h
  std::size_t DroppedInstanceCount = 0;
  bool TopChanged = true;
};
}
