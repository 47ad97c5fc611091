// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures shared by the frames of one context: transient textures lent for part of a frame, histories
 * by view and name, and the framebuffers that bind them.
 */
#pragma once

#include "gpu/GLObjects.h"

#include <list>
#include <map>
#include <string>
#include <vector>

namespace penumbra
{
/// A texture, or one layer of it, to draw into.
struct Attachment
{
  const Texture* Target = nullptr;
  int Layer = -1; ///< -1: the whole texture
};

/// A texture that outlives a frame and belongs to a view.
struct History
{
  Texture Storage;
  bool Written = false; ///< whether a pass has written it since it was created
};

class ResourcePool
{
public:
  /// Borrow a transient texture; contents are undefined.
  Texture* Acquire(const TextureDesc& desc);
  void Release(Texture* texture);

  /// History of a view with this name. It is created if the view has none of this shape.
  History& Keep(const std::string& view, const std::string& name, const TextureDesc& desc);

  /// The texture of an existing history, or nullptr.
  const Texture* FindHistory(const std::string& view, const std::string& name) const;

  /// Cached framebuffer with these attachments.
  GLuint Framebuffer(const std::vector<Attachment>& colors, const Attachment& depth);

  /// End a frame of a view: delete transient textures that no recent frame has used, and histories that no recent
  /// frame of this view has used.
  void EndFrame(const std::string& view);
  /// Delete the histories of a view that no longer exists.
  void ForgetView(const std::string& view);
  void Clear();

  std::size_t Bytes() const;
  int Count() const;

private:
  struct Slot
  {
    Texture Storage;
    bool Lent = false;
    int IdleFrames = 0;
  };
  struct KeptHistory
  {
    History Value;
    int IdleFrames = 0;
  };
  void ForgetFramebuffersOf(const Texture& texture);

  std::list<Slot> Slots;
  std::map<std::string, std::map<std::string, KeptHistory>> Histories; ///< by view and name
  std::map<std::vector<GLuint>, FramebufferHandle> Framebuffers;
  /// Framebuffers that bind a texture of VTK, which may be replaced between frames without notice.
  std::map<std::vector<GLuint>, FramebufferHandle> FrameFramebuffers;
};
}
