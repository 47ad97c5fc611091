// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A buffer of records that a shader reads as texels. Blocks of records are allocated and freed,
 * so that a mesh can be added or removed without touching the others.
 */
#pragma once

#include "gpu/Arguments.h"

#include <cstddef>
#include <cstdint>
#include <map>

namespace penumbra
{
class RayBuffer
{
public:
  /// name: for messages ("nodes"). recordTexels: number of 16-byte texels per record.
  RayBuffer(const char* name, int recordTexels)
    : Name(name)
    , RecordTexels(recordTexels)
  {
  }

  /// Allocate a block of records and return its first one. May grow the buffer, which keeps its contents. Throws
  /// std::runtime_error, naming the sizes and the remedy, if the context cannot hold that many.
  std::size_t Allocate(std::size_t records);
  void Free(std::size_t first, std::size_t records);

  void Write(std::size_t first, const void* records, std::size_t count);
  /// Bind the buffer as a uimageBuffer or a usamplerBuffer. Valid until the buffer grows.
  void AddImage(Arguments& arguments, const char* name) const;
  void AddSampler(Arguments& arguments, const char* name) const;

  std::size_t Used() const { return this->Taken; }
  std::size_t RecordBytes() const { return 16 * static_cast<std::size_t>(this->RecordTexels); }

  /// Free everything. The context that created it must be current.
  void Release();

private:
  void Grow(std::size_t records);

  const char* Name;
  int RecordTexels;
  std::map<std::size_t, std::size_t> Gaps; ///< first record, length
  std::size_t Capacity = 0;
  std::size_t Taken = 0;
  Handle<gl::DeleteBuffer> Storage;
  Handle<gl::DeleteTexture> View;
};
}
