// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Records that a shader reads as texels of an image buffer, with blocks of them handed out and
 * taken back, so that one mesh can come or go without touching the others.
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
  /// name: for messages ("nodes"). recordTexels: 16-byte texels of a record.
  RayBuffer(const char* name, int recordTexels)
    : Name(name)
    , RecordTexels(recordTexels)
  {
  }

  /// A free block of so many records. Grows the buffer, keeping its contents. Throws
  /// std::runtime_error, naming the sizes and the remedy, where the context cannot hold that many.
  std::size_t Allocate(std::size_t records);
  void Free(std::size_t first, std::size_t records);

  void Write(std::size_t first, const void* records, std::size_t count);
  /// For a uimageBuffer, or a usamplerBuffer. Holds until the buffer grows.
  void AddImage(Arguments& arguments, const char* name) const;
  void AddSampler(Arguments& arguments, const char* name) const;

  std::size_t Used() const { return this->Taken; }
  std::size_t RecordBytes() const { return 16 * static_cast<std::size_t>(this->RecordTexels); }

  /// Forget everything; the context that made it must be current.
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
