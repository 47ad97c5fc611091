// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures shared by the frames of one context: transient ones lent for part of a frame, histories
 * kept by view and name, and the framebuffers that bind them.
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

/// A texture that a view keeps from frame to frame.
struct History
{
  Texture Storage;
  bool Written = false; ///< by a pass, since it was made
};

class ResourcePool
{
public:
  /// Borrow a transient texture; contents are undefined.
  Texture* Acquire(const TextureDesc& desc);
  void Release(Texture* texture);

  /// A texture that a view keeps under this name, made where it has none of this shape.
  History& Keep(const std::string& view, const std::string& name, const TextureDesc& desc);

  /// The same where it is there, else nullptr.
  const Texture* FindHistory(const std::string& view, const std::string& name) const;

  /// A framebuffer of these attachments (colour in order, then depth), made once.
  GLuint Framebuffer(const std::vector<Attachment>& colors, const Attachment& depth);

  /// End a frame of a view: forget what no frame, and histories that none of this view, has used
  /// lately.
  void EndFrame(const std::string& view);
  /// Forget the histories of a view that is gone.
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
  struct Kept
  {
    History Held;
    int IdleFrames = 0;
  };
  void ForgetFramebuffersOf(const Texture& texture);

  std::list<Slot> Slots;
  std::map<std::string, std::map<std::string, Kept>> Histories; ///< by view and name
  std::map<std::vector<GLuint>, FramebufferHandle> Framebuffers;
  /// Those that bind a texture of VTK's, which may be replaced behind our back between frames.
  std::map<std::vector<GLuint>, FramebufferHandle> FrameFramebuffers;
};
}
