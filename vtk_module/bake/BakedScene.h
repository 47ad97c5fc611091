// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a bake of light depends on, so that light of another scene is never shown: the props as rays see them,
 * the lamps, the environment. Kept as text with the bake, and compared with the scene that is drawn.
 */
#pragma once

#include "rays/parts/GatherCache.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace penumbra
{
/// What scenes are read with: hashes of content, kept as long as nothing is modified.
struct BakedSceneCache
{
  GatherCache Parts;
  struct Hash
  {
    std::array<std::uint64_t, 2> Times{};
    std::uint64_t Value = 0;
  };
  std::map<std::pair<int, std::uint64_t>, Hash> Hashes;
};

class BakedScene
{
public:
  using Namer = std::function<std::string(vtkProp*)>;

  /// Of a renderer as it is: its visible props that rays see, lamps that are on and do not follow the camera, its
  /// environment. name: how sentences call a prop, "" for "object 3".
  static BakedScene Of(vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name = {});

  /// One line a thing; what is written with the bake.
  std::string ToText() const;
  /// Throws std::invalid_argument with a sentence where the text is none of ToText()'s.
  static BakedScene FromText(const std::string& text);

  /// What is different now, as in "light 1 moved"; "" where the bake still fits. Props that the bake does not
  /// know are no difference, lamps are.
  std::string DifferenceTo(const BakedScene& now) const;

  bool IsEmpty() const { return this->Things.empty(); }

private:
  friend class BakedSceneWatch;
  enum Kind
  {
    Prop,
    Lamp,
    Surroundings,
    Kinds
  };
  /// Of a prop: where, shape, look. Of a lamp: where, colour, kind. Of an environment: how it is turned,
  /// picture, nothing.
  static constexpr int Traits = 3;
  struct Thing
  {
    Kind What = Prop;
    std::string Name;
    std::array<std::vector<double>, Traits> Values;
  };
  /// Whether nothing is seen through any of the props: none is translucent, clipped or culled.
  static bool AddProps(
    vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name, std::vector<Thing>& things);
  static void AddLamps(vtkRenderer* renderer, std::vector<Thing>& things);
  static void AddSurroundings(
    vtkRenderer* renderer, BakedSceneCache& cache, std::vector<Thing>& things);
  static bool Alike(const std::vector<double>& a, const std::vector<double>& b);
  static int AlikeTraits(const Thing& a, const Thing& b);
  static void Compare(std::vector<const Thing*> baked, std::vector<const Thing*> now,
    std::vector<std::string>& differences);

  std::vector<Thing> Things;
};

/// The scene of a renderer, as bakes know it, followed from frame to frame.
class BakedSceneWatch
{
public:
  /// The bake's DifferenceTo() the renderer's scene. Props are looked at again where they changed or a frame was missed,
  /// lamps every time. changed: any prop moved, came, went or looks different since the last frame.
  std::string Difference(
    const BakedScene& baked, vtkRenderer* renderer, bool changed, int frameNumber);

  /// Of the last Difference(): whether nothing is seen through any prop, be it translucent, clipped or culled.
  bool IsSolid() const { return this->Solid; }

private:
  std::vector<BakedScene::Thing> Props;
  bool Solid = false;
  BakedSceneCache Cache;
  int Frame = -2;
};
}
