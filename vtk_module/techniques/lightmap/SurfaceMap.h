// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Baked light in a texture on surfaces, drawn over the pixels that show these surfaces.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

class vtkFieldData;
class vtkImageData;

namespace penumbra
{
class FrameContext;

class SurfaceMap
{
public:
  SurfaceMap() = default;
  /// Read an image as LightmapImage.h describes it. Throws std::invalid_argument with a reason.
  explicit SurfaceMap(vtkImageData* bake);

  bool IsEmpty() const { return this->Corners.empty(); }
  /// Whether the bake includes direct light.
  bool HasDirectLight() const { return this->DirectLight; }

  /// Draw the light, multiplied by intensity, see IndirectLight::Draw. solid: all props are opaque and complete, so
  /// none of the surfaces can lie in front of what the picture shows.
  void Draw(FrameContext& context, double intensity, bool solid);

  void Release();
  /// Take over another map's GPU resources, and free them at the next Draw(), when their context is current.
  void TakeResources(SurfaceMap& other);

private:
  struct Point
  {
    glm::vec3 Position; ///< relative to Origin
    glm::vec3 Normal;
    glm::vec2 TexturePoint;
  };
  struct GpuResources
  {
    Buffer Points;
    Buffer Corners;
    VertexArrayHandle Layout;
    /// Layers: irradiance and its moments, then those of direct light.
    std::unique_ptr<Texture> Light;
  };
  void ReadSurfaces(vtkFieldData* fields);
  void ReadLight(vtkImageData* bake);
  void Upload();

  glm::dvec3 Origin{ 0.0 };
  std::vector<Point> Points;
  std::vector<std::uint32_t> Corners; ///< three per triangle
  int Width = 0;
  int Height = 0;
  int Layers = 0;
  bool Directional = false;
  bool DirectLight = false;
  std::vector<float> Values; ///< rgba, layer by layer
  std::unique_ptr<GpuResources> Gpu;
  std::vector<std::unique_ptr<GpuResources>> Retired;
};
}
