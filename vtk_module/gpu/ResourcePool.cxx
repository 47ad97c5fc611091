// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/ResourcePool.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace penumbra
{
namespace
{
// Number of frames after which an unused texture is deleted.
constexpr int IdleLimit = 16;

// Fill a texture with NaN, for tests of shaders that read what no pass has written. On a GPU such texels hold arbitrary values,
// whereas software OpenGL clears them.
void Spoil(const Texture& texture)
{
  static const char* asked = std::getenv("PENUMBRA_SPOIL_TEXTURES");
  const TextureDesc& desc = texture.Desc();
  if (!asked || !*asked || desc.IsDepth())
  {
    return;
  }
  GLint type = GL_NONE;
  glBindTexture(texture.Target(), texture.Get());
  glGetTexLevelParameteriv(texture.Target(), 0, GL_TEXTURE_RED_TYPE, &type);
  if (type == GL_FLOAT || type == GL_UNSIGNED_NORMALIZED)
  {
    const float value = type == GL_FLOAT ? std::numeric_limits<float>::quiet_NaN() : 0.37f;
    const std::size_t layers = std::max(desc.Layers, 1);
    const std::vector<float> values(layers * desc.Width * desc.Height * 4, value);
    if (desc.Layers > 0)
    {
      glTexSubImage3D(texture.Target(), 0, 0, 0, 0, desc.Width, desc.Height, desc.Layers, GL_RGBA,
        GL_FLOAT, values.data());
    }
    else
    {
      glTexSubImage2D(
        texture.Target(), 0, 0, 0, desc.Width, desc.Height, GL_RGBA, GL_FLOAT, values.data());
    }
  }
  glBindTexture(texture.Target(), 0);
}
}

Texture* ResourcePool::Acquire(const TextureDesc& desc)
{
  for (auto& slot : this->Slots)
  {
    if (!slot.Lent && slot.Storage.Desc() == desc)
    {
      slot.Lent = true;
      slot.IdleFrames = 0;
      Spoil(slot.Storage);
      return &slot.Storage;
    }
  }
  this->Slots.push_back({ Texture(desc), true, 0 });
  Spoil(this->Slots.back().Storage);
  return &this->Slots.back().Storage;
}

void ResourcePool::Release(Texture* texture)
{
  for (auto& slot : this->Slots)
  {
    if (&slot.Storage == texture)
    {
      slot.Lent = false;
    }
  }
}

History& ResourcePool::Keep(
  const std::string& view, const std::string& name, const TextureDesc& desc)
{
  auto& histories = this->Histories[view];
  auto found = histories.find(name);
  if (found != histories.end() && !(found->second.Value.Storage.Desc() == desc))
  {
    this->ForgetFramebuffersOf(found->second.Value.Storage);
    histories.erase(found);
    found = histories.end();
  }
  if (found == histories.end())
  {
    found = histories.emplace(name, KeptHistory{ { Texture(desc), false }, 0 }).first;
    Spoil(found->second.Value.Storage);
  }
  found->second.IdleFrames = 0;
  return found->second.Value;
}

const Texture* ResourcePool::FindHistory(const std::string& view, const std::string& name) const
{
  const auto histories = this->Histories.find(view);
  if (histories == this->Histories.end())
  {
    return nullptr;
  }
  const auto found = histories->second.find(name);
  return found == histories->second.end() ? nullptr : &found->second.Value.Storage;
}

GLuint ResourcePool::Framebuffer(const std::vector<Attachment>& colors, const Attachment& depth)
{
  std::vector<GLuint> key;
  for (const auto& color : colors)
  {
    key.push_back(color.Target ? color.Target->Get() : 0);
    key.push_back(static_cast<GLuint>(color.Layer));
  }
  key.push_back(depth.Target ? depth.Target->Get() : 0);
  key.push_back(static_cast<GLuint>(depth.Layer));
  bool borrowed = depth.Target && depth.Target->IsBorrowed();
  for (const auto& color : colors)
  {
    borrowed |= color.Target && color.Target->IsBorrowed();
  }
  auto& cache = borrowed ? this->FrameFramebuffers : this->Framebuffers;
  auto found = cache.find(key);
  if (found != cache.end())
  {
    return found->second.Get();
  }

  GLuint name = 0;
  glGenFramebuffers(1, &name);
  GLint previousDraw = 0;
  GLint previousRead = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &previousDraw);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &previousRead);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  const auto attach = [](GLenum point, const Attachment& what) {
    if (what.Layer >= 0)
    {
      glFramebufferTextureLayer(GL_FRAMEBUFFER, point, what.Target->Get(), 0, what.Layer);
    }
    else
    {
      glFramebufferTexture(GL_FRAMEBUFFER, point, what.Target->Get(), 0);
    }
  };
  std::vector<GLenum> buffers;
  for (const auto& color : colors)
  {
    const auto point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    buffers.push_back(color.Target ? point : GL_NONE);
    if (color.Target)
    {
      attach(point, color);
    }
  }
  if (depth.Target)
  {
    attach(depth.Target->Desc().DepthAttachment(), depth);
  }
  if (buffers.empty())
  {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }
  else
  {
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, previousDraw);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, previousRead);
  return cache.emplace(key, FramebufferHandle(name)).first->second.Get();
}

void ResourcePool::ForgetFramebuffersOf(const Texture& texture)
{
  for (auto it = this->Framebuffers.begin(); it != this->Framebuffers.end();)
  {
    bool uses = false;
    for (std::size_t i = 0; i < it->first.size(); i += 2)
    {
      uses |= it->first[i] == texture.Get();
    }
    it = uses ? this->Framebuffers.erase(it) : std::next(it);
  }
}

void ResourcePool::EndFrame(const std::string& view)
{
  this->FrameFramebuffers.clear();
  for (auto it = this->Slots.begin(); it != this->Slots.end();)
  {
    if (!it->Lent && ++it->IdleFrames > IdleLimit)
    {
      this->ForgetFramebuffersOf(it->Storage);
      it = this->Slots.erase(it);
      continue;
    }
    ++it;
  }
  auto& histories = this->Histories[view];
  for (auto it = histories.begin(); it != histories.end();)
  {
    if (++it->second.IdleFrames > IdleLimit)
    {
      this->ForgetFramebuffersOf(it->second.Value.Storage);
      it = histories.erase(it);
      continue;
    }
    ++it;
  }
}

void ResourcePool::ForgetView(const std::string& view)
{
  for (const auto& history : this->Histories[view])
  {
    this->ForgetFramebuffersOf(history.second.Value.Storage);
  }
  this->Histories.erase(view);
}

void ResourcePool::Clear()
{
  this->Framebuffers.clear();
  this->FrameFramebuffers.clear();
  this->Slots.clear();
  this->Histories.clear();
}

std::size_t ResourcePool::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& slot : this->Slots)
  {
    bytes += slot.Storage.Desc().Bytes();
  }
  for (const auto& view : this->Histories)
  {
    for (const auto& history : view.second)
    {
      bytes += history.second.Value.Storage.Desc().Bytes();
    }
  }
  return bytes;
}

int ResourcePool::Count() const
{
  std::size_t count = this->Slots.size();
  for (const auto& view : this->Histories)
  {
    count += view.second.size();
  }
  return static_cast<int>(count);
}
}
