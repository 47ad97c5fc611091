// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cache of gathered data such as mapped colours and positions of glyphs, so that only changes cost time.
 * Each gatherer stores values of its own types, under the objects from which they were computed.
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
  /// The value of type T for two objects, default-constructed at first use.
  /// A new object may reuse an address, so compare modification times, which are unique.
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

  /// Delete values that were not used since the last call.
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
