// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Everything that baked light depends on: the props as rays see them, the lights and the environment. It is stored as
 * text with the bake and compared with the scene that is drawn, so that light of another scene is never shown.
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
/// Hashes of content, kept until the content is modified.
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

  /// The current scene of a renderer: visible props that rays see, lights that are on and do not follow the camera, and
  /// the environment. name: returns the name of a prop for messages, or "" for a name such as "object 3".
  static BakedScene Of(vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name = {});

  /// The text that is stored with the bake, one line per entry.
  std::string ToText() const;
  /// Throws std::invalid_argument with a sentence if the text was not written by ToText().
  static BakedScene FromText(const std::string& text);

  /// The difference to the current scene, such as "light 1 moved"; "" if the bake fits. Additional lights count as
  /// differences, additional props do not.
  std::string DifferenceTo(const BakedScene& current) const;

  bool IsEmpty() const { return this->Entries.empty(); }

private:
  friend class BakedSceneWatch;
  enum Kind
  {
    Prop,
    LightSource,
    Environment,
    Kinds
  };
  /// Traits of a prop: position, shape, appearance. Of a light: position, colour, kind. Of the environment:
  /// orientation, picture, unused.
  static constexpr int Traits = 3;
  struct Entry
  {
    Kind Type = Prop;
    std::string Name;
    std::array<std::vector<double>, Traits> Values;
  };
  /// Returns whether all props are opaque and complete: none is translucent, clipped or culled.
  static bool AddProps(
    vtkRenderer* renderer, BakedSceneCache& cache, const Namer& name, std::vector<Entry>& entries);
  static void AddLights(vtkRenderer* renderer, std::vector<Entry>& entries);
  static void AddEnvironment(
    vtkRenderer* renderer, BakedSceneCache& cache, std::vector<Entry>& entries);
  static bool NearlyEqual(const std::vector<double>& a, const std::vector<double>& b);
  static int CountEqualTraits(const Entry& a, const Entry& b);
  static void Compare(std::vector<const Entry*> baked, std::vector<const Entry*> current,
    std::vector<std::string>& differences);

  std::vector<Entry> Entries;
};

/// Follows the scene of a renderer from frame to frame.
class BakedSceneWatch
{
public:
  /// DifferenceTo() between the bake and the renderer's scene. Props are read again only if they changed or a frame was
  /// missed, lights every time. changed: whether any prop moved, came, went or looks different since the last frame.
  std::string Difference(
    const BakedScene& baked, vtkRenderer* renderer, bool changed, int frameNumber);

  /// Whether, at the last Difference(), all props were opaque and complete: none translucent, clipped or culled.
  bool IsSolid() const { return this->Solid; }

private:
  std::vector<BakedScene::Entry> Props;
  bool Solid = false;
  BakedSceneCache Cache;
  int Frame = -2;
};
}
