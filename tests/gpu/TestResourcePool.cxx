// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The pool lends, reuses, keeps and frees textures.
#include "gpu/ResourcePool.h"

#include "ComputeHarness.h"

namespace penumbra_test
{
namespace
{
using namespace penumbra;

const TextureDesc Color{ GL_RGBA8, 64, 32, 0 };
const TextureDesc Depth{ GL_DEPTH_COMPONENT32F, 64, 32, 0 };

class Pool : public ComputeHarness
{
protected:
  void TearDown() override
  {
    this->Textures.Clear();
    ComputeHarness::TearDown();
  }
  ResourcePool Textures;
};

TEST_F(Pool, ReturnedTexturesAreLentAgain)
{
  Texture* first = this->Textures.Acquire(Color);
  Texture* second = this->Textures.Acquire(Color);
  EXPECT_NE(first->Get(), second->Get());
  this->Textures.Release(first);
  Texture* third = this->Textures.Acquire(Color);
  EXPECT_EQ(first, third);
  EXPECT_NE(this->Textures.Acquire(Depth), nullptr);
  EXPECT_EQ(this->Textures.Count(), 3);
  EXPECT_EQ(this->Textures.Bytes(), 3u * 64u * 32u * 4u);
}

TEST_F(Pool, IdleTexturesAreFreed)
{
  Texture* texture = this->Textures.Acquire(Color);
  const GLuint name = texture->Get();
  this->Textures.Release(texture);
  for (int frame = 0; frame < 1000 && this->Textures.Count() > 0; ++frame)
  {
    this->Textures.EndFrame("view");
  }
  EXPECT_EQ(this->Textures.Count(), 0);
  EXPECT_FALSE(glIsTexture(name));
}

TEST_F(Pool, HistoriesKeepTheirContent)
{
  History& first = this->Textures.Keep("view", "radiance", Color);
  EXPECT_FALSE(first.Written);
  first.Written = true;
  const GLuint name = first.Storage.Get();
  this->Textures.EndFrame("view");
  EXPECT_EQ(this->Textures.Keep("view", "radiance", Color).Storage.Get(), name);
  EXPECT_TRUE(this->Textures.Keep("view", "radiance", Color).Written);
  EXPECT_NE(this->Textures.Keep("other", "radiance", Color).Storage.Get(), name);
  EXPECT_FALSE(this->Textures.Keep("other", "radiance", Color).Written);
  // A history whose size changes starts empty.
  TextureDesc larger = Color;
  larger.Width = 128;
  EXPECT_EQ(this->Textures.Keep("view", "radiance", larger).Storage.Desc(), larger);
  EXPECT_FALSE(this->Textures.Keep("view", "radiance", larger).Written);
}

TEST_F(Pool, FramebuffersAreCompleteAndCreatedOnce)
{
  Texture* color = this->Textures.Acquire(Color);
  Texture* layers = this->Textures.Acquire({ GL_RGBA16F, 64, 32, 3 });
  Texture* depth = this->Textures.Acquire(Depth);
  const std::vector<Attachment> colors = { { color, -1 }, { layers, 2 } };
  const GLuint name = this->Textures.Framebuffer(colors, { depth, -1 });
  EXPECT_EQ(this->Textures.Framebuffer(colors, { depth, -1 }), name);
  EXPECT_NE(this->Textures.Framebuffer({ { color, -1 } }, {}), name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST_F(Pool, ClearFreesEverything)
{
  const GLuint lent = this->Textures.Acquire(Color)->Get();
  const GLuint kept = this->Textures.Keep("view", "a", Depth).Storage.Get();
  this->Textures.Clear();
  EXPECT_FALSE(glIsTexture(lent));
  EXPECT_FALSE(glIsTexture(kept));
  EXPECT_EQ(this->Textures.Count(), 0);
  EXPECT_EQ(this->Textures.Bytes(), 0u);
}
}
}
