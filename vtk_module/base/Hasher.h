// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A hash of data, to detect changes.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace penumbra
{
/// FNV-1a (Fowler, Noll, Vo) over words of eight bytes, with additional mixing of bits.
class Hasher
{
public:
  void Add(const void* data, std::size_t bytes)
  {
    const auto* from = static_cast<const unsigned char*>(data);
    for (; bytes > 0;)
    {
      std::uint64_t word = 0;
      const std::size_t count = std::min(bytes, sizeof(word));
      std::memcpy(&word, from, count);
      this->State = (this->State ^ word) * 0x100000001b3ull;
      this->State ^= this->State >> 29;
      from += count;
      bytes -= count;
    }
  }
  template <typename T>
  void Add(const std::vector<T>& values)
  {
    const std::size_t count = values.size();
    this->Add(&count, sizeof(count));
    this->Add(values.data(), count * sizeof(T));
  }
  template <typename T>
  void AddValue(const T& value)
  {
    this->Add(&value, sizeof(value));
  }
  std::uint64_t Get() const { return this->State; }

private:
  std::uint64_t State = 0xcbf29ce484222325ull;
};
}
