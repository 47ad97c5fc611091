// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Arguments are bound by name, and memory barriers are set before data that shaders wrote are used.
#include "TestData.h"
#include "WindowTest.h"

#include "gpu/Commands.h"

#include <glm/gtc/type_ptr.hpp>

using namespace penumbra;
using namespace penumbra_test;

namespace
{
class CommandsTest : public WindowTest
{
protected:
  void SetUp() override
  {
    WindowTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    setenv("PENUMBRA_CHECK_SHADERS", "1", 1);
    this->StartRunner();
  }

  /// Begin with commands that know the environment as it is now.
  void StartRunner()
  {
    this->Runner = std::make_unique<Commands>(this->Library);
    this->Runner->SetWindow(this->Window);
  }

  /// A shader of tests/gpu/shaders.
  std::unique_ptr<Program> Compile(const std::string& name) const
  {
    const std::string text = TestText("gpu/shaders/" + name);
    const char* source = text.c_str();
    return std::make_unique<Program>(
      glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source), true, "test", text);
  }

  std::string ErrorOf(const Program& program, const Arguments& given)
  {
    try
    {
      this->Runner->Dispatch(program, given, Work::Items(1));
    }
    catch (const std::logic_error& error)
    {
      return error.what();
    }
    return "";
  }

  std::vector<float> Read(const Buffer& buffer, std::size_t count)
  {
    std::vector<float> values(count);
    this->Runner->BeforeUse(buffer, GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.Get());
    glGetBufferSubData(
      GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(float)), values.data());
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return values;
  }

  ShaderLibrary Library;
  std::unique_ptr<Commands> Runner;
};
}

TEST_F(CommandsTest, ValuesOfEveryTypeAreBoundByName)
{
  const auto program = this->Compile("values.comp");
  glm::mat3 turn(0.0f);
  turn[2][1] = 9.0f;
  glm::mat4 place(0.0f);
  place[3][2] = 10.0f;
  Buffer results;
  const std::vector<float> blank(14, -1.0f);
  results.Upload(GL_SHADER_STORAGE_BUFFER, blank.data(), blank.size() * sizeof(float));
  this->Runner->Dispatch(*program,
    Arguments()
      .Block("ResultBlock", results, ShaderAccess::Write)
      .Set("flag", true)
      .Set("whole", 2)
      .Set("real", 3.0)
      .Set("two", glm::vec2(0.0f, 4.0f))
      .Set("three", glm::vec3(0.0f, 0.0f, 5.0f))
      .Set("four", glm::vec4(0.0f, 0.0f, 0.0f, 6.0f))
      .Set("pair", glm::ivec2(0, 7))
      .Set("triple", glm::ivec3(0, 0, 8))
      .Set("turn", turn)
      .Set("place", place)
      .Set("wholes", std::vector<int>{ 0, 0, 11 })
      .Set("places", std::vector<glm::vec3>{ glm::vec3(0.0f), glm::vec3(0.0f, 12.0f, 0.0f) })
      .Set("pairs", std::vector<glm::ivec2>{ glm::ivec2(0), glm::ivec2(13, 0) })
      .Set("triples", std::vector<glm::ivec3>{ glm::ivec3(0), glm::ivec3(0, 0, 14) }),
    Work::Items(1));
  EXPECT_EQ(
    this->Read(results, 14), (std::vector<float>{ 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 }));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(CommandsTest, MismatchedNamesAreErrorsIfShadersAreChecked)
{
  const auto program = this->Compile("strength.comp");
  Buffer results;
  const float blank = 0.0f;
  results.Upload(GL_SHADER_STORAGE_BUFFER, &blank, sizeof(blank));
  Arguments given = Arguments().Block("ResultBlock", results, ShaderAccess::Write);
  EXPECT_EQ(this->ErrorOf(*program, given), "the shader test is not given 'strength'");
  given.Set("strength", 1.0);
  EXPECT_EQ(this->ErrorOf(*program, given), "");
  given.Set("strengths", 1.0);
  EXPECT_EQ(
    this->ErrorOf(*program, given), "the shader test does not know 'strengths', which it is given");
  EXPECT_EQ(this->ErrorOf(*program, Arguments().Set("strength", 1.0)),
    "the shader test is not given 'ResultBlock'");
  unsetenv("PENUMBRA_CHECK_SHADERS");
  this->StartRunner();
  EXPECT_EQ(this->ErrorOf(*program, given), "");
}

TEST_F(CommandsTest, OfferedArgumentsMayBeUnused)
{
  const auto program = this->Compile("sum.comp");
  Buffer results;
  const float blank = 0.0f;
  results.Upload(GL_SHADER_STORAGE_BUFFER, &blank, sizeof(blank));
  const Arguments offered = Arguments().Set("strength", 1.0).Set("width", 2.0).Set("height", 3.0);
  this->Runner->Dispatch(*program,
    Arguments().Block("ResultBlock", results, ShaderAccess::Write).Set("width", 20.0),
    Work::Items(1), offered);
  EXPECT_EQ(this->Read(results, 1), std::vector<float>{ 21.0f });
}

TEST_F(CommandsTest, SetsOneBarrierPerUseOfWrittenData)
{
  const auto writer = this->Compile("write.comp");
  const auto reader = this->Compile("read.comp");
  const Texture texture({ GL_R32F, 1, 1, 0 });
  const Texture other({ GL_R32F, 1, 1, 0 });
  Buffer results;
  const float blank = 0.0f;
  results.Upload(GL_SHADER_STORAGE_BUFFER, &blank, sizeof(blank));
  const auto write = [&](const Texture& target) {
    this->Runner->Dispatch(
      *writer, Arguments().Image("target", target, ShaderAccess::Write), Work::Items(1));
    return this->Runner->NumberOfBarriers();
  };
  const auto read = [&](const Texture& source) {
    this->Runner->Dispatch(*reader,
      Arguments().Sample("source", &source).Block("ResultBlock", results, ShaderAccess::Write),
      Work::Items(1));
    return this->Runner->NumberOfBarriers();
  };
  EXPECT_EQ(read(texture), 0); // not written yet
  EXPECT_EQ(write(texture), 0);
  EXPECT_EQ(read(other), 1);   // for the results, which are written again
  EXPECT_EQ(read(texture), 3); // for the results and the texture
  EXPECT_EQ(write(texture), 4);
  EXPECT_EQ(write(other), 4);
  this->Runner->BeforeUse(texture, GL_FRAMEBUFFER_BARRIER_BIT);
  EXPECT_EQ(this->Runner->NumberOfBarriers(), 5);
  this->Runner->BeforeUse(other, GL_FRAMEBUFFER_BARRIER_BIT); // covered by the same barrier
  EXPECT_EQ(this->Runner->NumberOfBarriers(), 5);
  this->Runner->Finish();
  this->Runner->BeforeUse(texture, GL_TEXTURE_FETCH_BARRIER_BIT);
  EXPECT_EQ(this->Runner->NumberOfBarriers(), 5);
}
