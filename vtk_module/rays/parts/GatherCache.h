// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What gathering keeps from frame to frame, so that it costs what changed: mapped colours, places
 * of glyphs. Each gatherer keeps values of types of its own, found again by what they were made of.
 */
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <typeindex>

namespace penumbra
{
class GatherCache
{
public:
  /// The value made of these two objects, as the last frame left it; a new one where there is none.
  /// An address can come back as another object's: compare modification times, which do not.
  template <typename T>
  T& At(const void* a, const void* b)
  {
    Entry& entry = this->Entries[Name(typeid(T), a, b)];
    if (!entry.Value)
    {
      entry.Value = std::make_shared<T>();
    }
    entry.Used = true;
    return *static_cast<T*>(entry.Value.get());
  }

  /// Forget what was not asked for since the last call.
  void Sweep()
  {
    for (auto it = this->Entries.begin(); it != this->Entries.end();)
    {
      it = it->second.Used ? std::next(it) : this->Entries.erase(it);
    }
    for (auto& entry : this->Entries)
    {
      entry.second.Used = false;
    }
  }

private:
  using Name = std::tuple<std::type_index, const void*, const void*>;
  struct Entry
  {
    std::shared_ptr<void> Value;
    bool Used = false;
  };
  std::map<Name, Entry> Entries;
};
}
