// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Textures that VTK keeps bound are bound again after a pass, unless they were deleted.
#include "WindowTest.h"

#include "gpu/HeldTextures.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureUnitManager.h>

using namespace penumbra;
using namespace penumbra_test;

namespace
{
class HeldTexturesTest : public WindowTest
{
protected:
  void SetUp() override
  {
    WindowTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Unit = this->Window->GetTextureUnitManager()->Allocate();
    this->Bind(GL_TEXTURE_2D, MakeTexture(GL_TEXTURE_2D));
    this->Held.Record(this->Window);
  }

  void TearDown() override
  {
    if (this->Window)
    {
      this->Window->GetTextureUnitManager()->Free(this->Unit);
    }
  }

  static GLuint MakeTexture(GLenum target)
  {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    glBindTexture(target, 0);
    return name;
  }

  void Bind(GLenum target, GLuint name)
  {
    this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->Unit));
    glBindTexture(target, name);
    this->Recorded = name;
  }

  GLuint BoundAfterRestore()
  {
    this->Held.Restore(this->Window->GetState());
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->Unit));
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    return static_cast<GLuint>(bound);
  }

  HeldTextures Held;
  int Unit = 0;
  GLuint Recorded = 0;
};
}

TEST_F(HeldTexturesTest, AreBoundAgain)
{
  glBindTexture(GL_TEXTURE_2D, 0);
  EXPECT_EQ(this->BoundAfterRestore(), this->Recorded);
}

TEST_F(HeldTexturesTest, AreLeftOutOnceDeleted)
{
  glDeleteTextures(1, &this->Recorded);
  EXPECT_EQ(this->BoundAfterRestore(), 0u);
}

TEST_F(HeldTexturesTest, AreLeftOutIfAnotherKindOfTextureHasTheName)
{
  glDeleteTextures(1, &this->Recorded);
  for (int i = 0; i < 4096; ++i)
  {
    if (MakeTexture(GL_TEXTURE_2D_ARRAY) == this->Recorded)
    {
      EXPECT_EQ(this->BoundAfterRestore(), 0u);
      return;
    }
  }
  GTEST_SKIP() << "this driver does not use names again";
}
