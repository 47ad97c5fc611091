// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/ShaderLibrary.h"

#include <bitset>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <unistd.h>

namespace
{
using namespace penumbra;
namespace fs = std::filesystem;

class Folder
{
public:
  Folder()
    : Path(fs::temp_directory_path() / ("penumbra_library_" + std::to_string(getpid())))
  {
    fs::create_directories(this->Path / "lib");
  }
  ~Folder() { fs::remove_all(this->Path); }
  void Write(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->Path / name) << text;
  }
  const fs::path Path;
};

int CountOf(const std::string& text, const std::string& what)
{
  int count = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
  {
    ++count;
  }
  return count;
}

TEST(ShaderLibrary, IncludesEachFileOnce)
{
  Folder folder;
  folder.Write(
    "a.glsl", "#version 430 core\n#include \"lib/b.glsl\"\n#include \"lib/c.glsl\"\nA\n");
  folder.Write("lib/b.glsl", "#include \"lib/c.glsl\"\nB\n");
  folder.Write("lib/c.glsl", "C\n");
  ShaderLibrary library;
  library.SetOverrideFolder(folder.Path.string());
  EXPECT_EQ(library.Source("a.glsl"), "#version 430 core\nC\nB\nA\n");
}

TEST(ShaderLibrary, DefinesFollowTheVersion)
{
  Folder folder;
  folder.Write("a.glsl", "// a comment\n#version 430 core\nbody\n");
  folder.Write("b.glsl", "body\n");
  ShaderLibrary library;
  library.SetOverrideFolder(folder.Path.string());
  EXPECT_EQ(library.Source("a.glsl", { { "B", "2" }, { "A", "1" } }),
    "// a comment\n#version 430 core\n#define A 1\n#define B 2\nbody\n");
  EXPECT_EQ(library.Source("b.glsl", { { "A", "1" } }), "#define A 1\nbody\n");
}

TEST(ShaderLibrary, AFolderReplacesShaders)
{
  Folder folder;
  folder.Write("lib/phong.glsl", "replaced\n");
  ShaderLibrary library;
  const std::string embedded = library.Source("lib/phong.glsl");
  EXPECT_EQ(embedded.find("replaced"), std::string::npos);
  library.SetOverrideFolder(folder.Path.string());
  EXPECT_EQ(library.Source("lib/phong.glsl"), "replaced\n");
  EXPECT_EQ(CountOf(library.Source("direct_light/resolve.frag"), "replaced"), 1);
  EXPECT_NE(library.Source("lib/octahedral.glsl").find("giEncodeOctahedral"), std::string::npos);
  library.SetOverrideFolder("");
  EXPECT_EQ(library.Source("lib/phong.glsl"), embedded);
}

TEST(ShaderLibrary, ErrorsNameTheMissingShader)
{
  ShaderLibrary library;
  try
  {
    library.Source("lib/none.glsl");
    FAIL() << "found a shader that does not exist";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("lib/none.glsl"), std::string::npos);
  }
  Folder folder;
  folder.Write("a.glsl", "#include \"lib/none.glsl\"\n");
  library.SetOverrideFolder(folder.Path.string());
  try
  {
    library.Source("a.glsl");
    FAIL() << "included a shader that does not exist";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("'a.glsl' includes"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find(folder.Path.string()), std::string::npos);
  }
}

TEST(ShaderLibrary, EmbeddedTextEqualsTheFile)
{
  const fs::path root = PENUMBRA_GLSL_DIR;
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root))
  {
    const bool shader =
      std::regex_match(entry.path().extension().string(), std::regex("\\.(glsl|h|vert|frag|comp)"));
    if (shader)
    {
      const std::string name = fs::relative(entry.path(), root).generic_string();
      ASSERT_EQ(EmbeddedShaders().count(name), 1u) << name;
      std::ifstream file(entry.path());
      const std::string text((std::istreambuf_iterator<char>(file)), {});
      EXPECT_TRUE(text == EmbeddedShaders().at(name)) << name << " changed since the build";
      ++files;
    }
  }
  const auto isGenerated = [](const auto& shader) {
    return shader.first.find("denoising/network/") == 0;
  };
  const auto generated =
    std::count_if(EmbeddedShaders().begin(), EmbeddedShaders().end(), isGenerated);
  EXPECT_GT(generated, 0);
  EXPECT_EQ(files + generated, static_cast<int>(EmbeddedShaders().size()));
}

// Names of the options of a shader: those after #ifdef, #ifndef and defined, and those that #if tests as 0 or 1, unless the
// shader itself defines them.
std::vector<std::string> Flags(const std::string& text)
{
  std::vector<std::string> flags;
  const std::regex name("(?:#ifn?def |#(?:el)?if !?|defined\\()(GI_\\w+)");
  for (std::sregex_iterator it(text.begin(), text.end(), name); it != std::sregex_iterator(); ++it)
  {
    const bool isOwn = std::regex_search(text, std::regex("#define " + (*it)[1].str() + "\\b"));
    if (!isOwn && std::find(flags.begin(), flags.end(), (*it)[1]) == flags.end())
    {
      flags.push_back((*it)[1]);
    }
  }
  return flags;
}

// Whether a permutation is tested: all of up to six flags; of more flags, those with at most two set or at most one
// unset.
bool IsTested(unsigned int bits, std::size_t flags)
{
  const std::size_t set = std::bitset<32>(bits).count();
  return flags <= 6 || set <= 2 || set + 1 >= flags;
}

// All complete shaders in their permutations. The snippets in capture/ are parts of VTK's templates, and are tested by
// rendering.
TEST(ShaderLibrary, ReferenceCompilerAcceptsPermutations)
{
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "glslangValidator is not installed (package glslang-tools)";
  }
  Folder folder;
  ShaderLibrary library;
  int shaders = 0;
  int permutations = 0;
  for (const auto& shader : EmbeddedShaders())
  {
    const std::string extension = fs::path(shader.first).extension();
    if (extension != ".frag" && extension != ".vert" && extension != ".comp")
    {
      continue;
    }
    ++shaders;
    const std::string text = library.Source(shader.first);
    const auto flags = Flags(text);
    ASSERT_LE(flags.size(), 24u) << shader.first
                                 << " has too many flags to enumerate their subsets";
    for (unsigned int bits = 0; bits < 1u << flags.size(); ++bits)
    {
      if (!IsTested(bits, flags.size()))
      {
        continue;
      }
      Defines defines{ { "GI_LOOKUPS", "8" }, { "GI_SAMPLES", "8" },
        { "GI_STRIDE", "2" } }; // values rather than flags
      std::string name = std::regex_replace(shader.first, std::regex("[/.]"), "_");
      for (std::size_t i = 0; i < flags.size(); ++i)
      {
        const bool set = (bits >> i & 1u) != 0;
        const bool isValue = std::regex_search(text, std::regex("#if !?" + flags[i] + "\\b"));
        if (set || isValue)
        {
          defines[flags[i]] = set ? "1" : "0";
        }
        name += set ? '1' : '0';
      }
      folder.Write(name + extension, library.Source(shader.first, defines));
      ++permutations;
    }
  }
  EXPECT_GT(shaders, 3);
  RecordProperty("Permutations", permutations);
  const std::string log = (folder.Path / "log.txt").string();
  const std::string command = "cd '" + folder.Path.string() +
    "' && ls | grep -E '\\.(frag|vert|comp)$' | xargs glslangValidator > '" + log + "' 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream file(log);
  std::string line;
  std::string errors;
  while (std::getline(file, line))
  {
    errors += line.find("ERROR") != std::string::npos ? line + "\n" : "";
  }
  EXPECT_EQ(status, 0) << errors;
  EXPECT_EQ(errors, "");
}
}
