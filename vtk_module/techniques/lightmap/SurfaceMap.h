// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light in a picture that is laid over surfaces, drawn onto the pixels that show them.
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
  /// Of an image as LightmapImage.h describes it. Throws std::invalid_argument with a reason.
  explicit SurfaceMap(vtkImageData* bake);

  bool IsEmpty() const { return this->Corners.empty(); }
  /// Whether it holds what arrives straight from lamps.
  bool HasLamps() const { return this->Lamps; }

  /// Draw as IndirectLight::Draw does, with the light multiplied by intensity. solid: nothing is seen through any of
  /// its surfaces, so that none of them can be before what the picture shows.
  void Draw(FrameContext& context, double intensity, bool solid);

  void Release();
  /// Free another map's graphics resources at the next Draw(), when their context is current.
  void TakeOld(SurfaceMap& other);

private:
  struct Point
  {
    glm::vec3 Position; ///< relative to Origin
    glm::vec3 Normal;
    glm::vec2 Place; ///< in the picture
  };
  struct Uploaded
  {
    Buffer Points;
    Buffer Corners;
    VertexArrayHandle Layout;
    std::unique_ptr<Texture>
      Light; ///< layers: irradiance, its moments; of the lamps' light the same
  };
  void TakeSurfaces(vtkFieldData* fields);
  void TakePicture(vtkImageData* bake);
  void Upload();

  glm::dvec3 Origin{ 0.0 };
  std::vector<Point> Points;
  std::vector<std::uint32_t> Corners; ///< three a triangle
  int Width = 0;
  int Height = 0;
  int Layers = 0;
  bool Directional = false;
  bool Lamps = false;
  std::vector<float> Values; ///< rgba, layer by layer
  std::unique_ptr<Uploaded> OnCard;
  std::vector<std::unique_ptr<Uploaded>> Old;
};
}
