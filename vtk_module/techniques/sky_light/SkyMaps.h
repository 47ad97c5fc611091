// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shadow maps of one view's sky: which directions they show, and which of them are drawn next.
 */
#pragma once

#include "shadows/ShadowCasters.h"
#include "techniques/sky_light/SkyDirections.h"

#include <vector>

namespace penumbra
{
class Arguments;
class FrameContext;
class SceneCapture;
struct History;
struct View;

class SkyMaps
{
public:
  /// Parameters of vtkGISkyLight.
  struct Settings
  {
    int Maps = 256;
    int MapSize = 256;
    int FirstMaps = 32;
    int MapsPerFrame = 8;
    int NewMaps = 32; ///< number of maps replaced in a still frame

    bool operator==(const Settings& other) const
    {
      return this->Maps == other.Maps && this->MapSize == other.MapSize;
    }
  };

  /// Draw this frame's maps into the atlas.
  void Draw(FrameContext& context, SceneCapture& scene, const History& atlas,
    const SkyDirections& sky, bool skyChanged, const Settings& settings);

  /// Number of maps that are drawn; all of them are valid.
  int Count() const { return static_cast<int>(this->Maps.size()); }
  bool IsComplete() const { return this->Count() >= this->Current.Maps; }
  /// Number of maps drawn in the last frame.
  int Drawn() const { return this->DrawnMaps; }
  /// Number of directions whose maps have been drawn since the scene changed.
  int Directions() const { return static_cast<int>(this->NextDirection); }

  /// Data of `count` maps from number `first` on, counted around: four vectors per map, see sky_light/lookup.glsl. Positions
  /// are relative to Center(). Without maps all vectors are zero.
  std::vector<glm::vec4> Data(int first, int count) const;
  const glm::dvec3& Center() const { return this->Middle; }

  /// Width of a texel of the maps in world units; 0 without maps.
  double Texel() const { return this->Maps.empty() ? 0.0 : this->Maps.front().View.Texel; }

  /// Width of the square atlas for a number of maps.
  static int AtlasWidth(const Settings& settings);

private:
  struct Map
  {
    ShadowView View;
    AtlasTile Tile;
    SkyDirections::Sample Direction;
    glm::dvec3 Weight{ 0.0 }; ///< radiance divided by the density
  };

  void Restart(const SceneCapture& scene, const Settings& settings);
  void DrawNext(
    FrameContext& context, SceneCapture& scene, const History& atlas, const SkyDirections& sky);
  void Weigh(const SkyDirections& sky);

  Settings Current;
  std::vector<double> Casters; ///< signature of the casters in the maps
  CasterBounds Bounds;
  glm::dvec3 Middle{ 0.0 };
  std::vector<Map> Maps;
  unsigned int NextDirection = 0; ///< in the sequence
  /// Whether the maps are those of the first directions for the current sky, so that they do not depend on earlier frames.
  bool AreFirst = true;
  int Outdated =
    0; ///< number of maps to replace, because the sky has turned away from their directions
  int DrawnMaps = 0;
};
}
