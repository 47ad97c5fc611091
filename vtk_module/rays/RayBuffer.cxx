// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayBuffer.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace penumbra
{
namespace
{
std::string Mebibytes(std::size_t bytes)
{
  return std::to_string((bytes + (std::size_t(1) << 20) - 1) >> 20) + " MiB";
}
}

std::size_t RayBuffer::Allocate(std::size_t records)
{
  auto fits = [records](const auto& gap) { return gap.second >= records; };
  auto gap = std::find_if(this->Gaps.begin(), this->Gaps.end(), fits);
  if (gap == this->Gaps.end())
  {
    this->Grow(records);
    gap = std::find_if(this->Gaps.begin(), this->Gaps.end(), fits);
  }
  const std::size_t first = gap->first;
  const std::size_t left = gap->second - records;
  this->Gaps.erase(gap);
  if (left > 0)
  {
    this->Gaps[first + records] = left;
  }
  this->Taken += records;
  return first;
}

void RayBuffer::Free(std::size_t first, std::size_t records)
{
  if (records == 0)
  {
    return;
  }
  this->Taken -= records;
  auto gap = this->Gaps.emplace(first, records).first;
  const auto next = std::next(gap);
  if (next != this->Gaps.end() && gap->first + gap->second == next->first)
  {
    gap->second += next->second;
    this->Gaps.erase(next);
  }
  if (gap != this->Gaps.begin())
  {
    const auto before = std::prev(gap);
    if (before->first + before->second == gap->first)
    {
      before->second += gap->second;
      this->Gaps.erase(gap);
    }
  }
}

void RayBuffer::Grow(std::size_t records)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  const std::size_t most = static_cast<std::size_t>(limit) / this->RecordTexels;
  // A gap at the end counts towards the requested records.
  std::size_t end = this->Capacity;
  if (!this->Gaps.empty())
  {
    const auto& last = *this->Gaps.rbegin();
    end = last.first + last.second == this->Capacity ? last.first : end;
  }
  const std::size_t needed = end + records;
  if (needed > most)
  {
    throw std::runtime_error("the scene is too large to trace rays against: its " +
      std::string(this->Name) + " need " + Mebibytes(needed * this->RecordBytes()) +
      " and this OpenGL allows " + Mebibytes(most * this->RecordBytes()) +
      "; show less of it or decimate it.");
  }
  const std::size_t capacity =
    std::min(most, std::max(needed, this->Capacity + this->Capacity / 4));

  GLuint name = 0;
  glGenBuffers(1, &name);
  Handle<gl::DeleteBuffer> storage(name);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  glBindBuffer(GL_TEXTURE_BUFFER, name);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(capacity * this->RecordBytes()), nullptr,
    GL_DYNAMIC_DRAW);
  if (glGetError() == GL_OUT_OF_MEMORY)
  {
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
    throw std::runtime_error(
      "the scene is too large to trace rays against: there is no memory for the " +
      Mebibytes(capacity * this->RecordBytes()) + " of its " + this->Name +
      "; show less of it or decimate it.");
  }
  if (this->Capacity > 0)
  {
    glBindBuffer(GL_COPY_READ_BUFFER, this->Storage.Get());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_TEXTURE_BUFFER, 0, 0,
      static_cast<GLsizeiptr>(this->Capacity * this->RecordBytes()));
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
  }
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  this->Storage = std::move(storage);

  GLuint view = 0;
  glGenTextures(1, &view);
  this->View = Handle<gl::DeleteTexture>(view);
  glBindTexture(GL_TEXTURE_BUFFER, view);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, this->Storage.Get());
  glBindTexture(GL_TEXTURE_BUFFER, 0);

  const std::size_t added = capacity - this->Capacity;
  const std::size_t old = this->Capacity;
  this->Capacity = capacity;
  this->Taken += added;
  this->Free(old, added);
}

void RayBuffer::Write(std::size_t first, const void* records, std::size_t count)
{
  if (count > 0)
  {
    glBindBuffer(GL_TEXTURE_BUFFER, this->Storage.Get());
    glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * this->RecordBytes()),
      static_cast<GLsizeiptr>(count * this->RecordBytes()), records);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
  }
}

void RayBuffer::AddImage(Arguments& arguments, const char* name) const
{
  arguments.Image(name, this->View.Get(), GL_RGBA32UI);
}

void RayBuffer::AddSampler(Arguments& arguments, const char* name) const
{
  arguments.Sample(name, GL_TEXTURE_BUFFER, this->View.Get());
}

void RayBuffer::Release()
{
  this->Gaps.clear();
  this->Capacity = this->Taken = 0;
  this->Storage = Handle<gl::DeleteBuffer>();
  this->View = Handle<gl::DeleteTexture>();
}
}
