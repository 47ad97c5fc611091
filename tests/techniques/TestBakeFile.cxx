// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of baked light: a loaded bake gives the same picture as one in memory, and a bad file is refused with one
 * sentence.
 */
#include "LightmapStage.h"

#include <vtkFieldData.h>
#include <vtkGIBakeFile.h>
#include <vtkGISHProbes.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <unistd.h>

using namespace penumbra_test;

namespace
{
class BakeFiles : public LightmapTechnique
{
protected:
  void SetUp() override
  {
    this->LightmapTechnique::SetUp();
    this->Folder =
      std::filesystem::temp_directory_path() / ("penumbra_bakes_" + std::to_string(getpid()));
    std::filesystem::create_directories(this->Folder);
    this->Path = (this->Folder / "map.vti").string();
  }
  void TearDown() override
  {
    this->LightmapTechnique::TearDown();
    std::filesystem::remove_all(this->Folder);
  }

  // Linear colours of all pixels of the next frame, four floats each.
  std::vector<float> Radiance()
  {
    this->Scene.Window->Render();
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(this->Pass->GetRadiance(this->Scene.Renderer, image));
    const auto* values = static_cast<float*>(image->GetScalarPointer());
    return { values, values + 4 * image->GetNumberOfPoints() };
  }

  void Write(int channels = 3)
  {
    vtkNew<vtkImageData> bake;
    ASSERT_TRUE(this->Map->JoinBake(this->Surfaces(), Light(channels), bake));
    ASSERT_TRUE(this->File->Write(this->Path.c_str(), bake)) << this->File->GetLastError();
  }

  std::string Bytes() const
  {
    std::ifstream file(this->Path, std::ios::binary);
    return { std::istreambuf_iterator<char>(file), {} };
  }

  // Expect that a file of these bytes is refused with a sentence that names it and contains the words, and that nothing
  // changes.
  void ExpectRefused(const std::string& bytes, const std::string& words)
  {
    const std::string bad = (this->Folder / "bad.vti").string();
    std::ofstream(bad, std::ios::binary) << bytes;
    this->Map->EnabledOff();
    EXPECT_FALSE(this->File->Load(bad.c_str(), this->Pass));
    const std::string error = this->File->GetLastError();
    EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_NE(error.find("'" + bad + "'"), std::string::npos) << error;
    EXPECT_FALSE(this->Map->GetEnabled());
    EXPECT_FALSE(this->File->Load(bad.c_str(), this->Map));
    EXPECT_NE(std::string(this->File->GetLastError()).find(bad), std::string::npos);
  }

  std::filesystem::path Folder;
  std::string Path;
  vtkNew<vtkGIBakeFile> File;
};
}

TEST_F(BakeFiles, GiveTheSamePictureAsMemory)
{
  for (const int channels : { 3, 6, 12, 24 })
  {
    this->Bake(channels);
    const std::vector<float> memory = this->Radiance();
    EXPECT_GT(*std::max_element(memory.begin(), memory.end()), 0.1f);
    this->Write(channels);
    this->Map->SetBake(nullptr);
    this->Map->EnabledOff();
    EXPECT_NE(this->Radiance(), memory) << "without any map";
    EXPECT_EQ(this->File->Load(this->Path.c_str(), this->Pass), this->Map);
    EXPECT_STREQ(this->File->GetLastError(), "");
    EXPECT_TRUE(this->Map->GetEnabled());
    EXPECT_EQ(this->Map->HasLampLight(), channels % 12 == 0 ? channels == 24 : channels == 6);
    EXPECT_TRUE(this->Radiance() == memory) << channels << " components";
  }
}

TEST_F(BakeFiles, AreRefusedIfDamagedOrForeign)
{
  this->Write();
  const std::string whole = this->Bytes();
  for (const int part : { 0, 1, 2, 5, 9 })
  {
    this->ExpectRefused(
      whole.substr(0, whole.size() * part / 10), part == 0 ? "no baked light" : "damaged");
  }
  this->ExpectRefused("no picture at all", "holds no baked light");
  this->ExpectRefused("\x76\x2f\x31\x01 and so on", "penumbra bake convert ");
  this->ExpectRefused("<VTKFile type=\"PolyData\">", "holds no baked light");
  // A changed value under the old checksum.
  vtkNew<vtkImageData> bake;
  ASSERT_TRUE(this->File->Read(this->Path.c_str(), bake));
  bake->GetPointData()->GetScalars()->SetComponent(0, 0, 0.125);
  ASSERT_TRUE(this->File->Write(this->Path.c_str(), bake));
  this->ExpectRefused(this->Bytes(), "checksum");
  vtkStringArray::SafeDownCast(bake->GetFieldData()->GetAbstractArray("format"))
    ->SetValue(0, "penumbra lightmap 77");
  ASSERT_TRUE(this->File->Write(this->Path.c_str(), bake));
  this->ExpectRefused(this->Bytes(), "this version reads 'penumbra lightmap 2'");
  bake->GetFieldData()->RemoveArray("format");
  ASSERT_TRUE(this->File->Write(this->Path.c_str(), bake));
  this->ExpectRefused(this->Bytes(), "holds no baked light");
  EXPECT_FALSE(this->File->Load("/nowhere/map.vti", this->Pass));
  EXPECT_NE(std::string(this->File->GetLastError()).find("does not exist"), std::string::npos);
}

TEST_F(BakeFiles, AreRefusedByOtherTechniques)
{
  this->Write();
  auto* probes = vtkGISHProbes::SafeDownCast(this->Pass->GetTechnique("sh-probes"));
  EXPECT_FALSE(this->File->Load(this->Path.c_str(), probes));
  EXPECT_FALSE(probes->HasBake());
  EXPECT_FALSE(this->File->Load(this->Path.c_str(), this->Pass->GetTechnique("shadow-maps")));
  EXPECT_NE(
    std::string(this->File->GetLastError()).find("takes no baked light"), std::string::npos);
}

TEST_F(BakeFiles, AreWrittenWholeOrNotAtAll)
{
  this->Write();
  const std::string before = this->Bytes();
  vtkNew<vtkImageData> bake;
  ASSERT_TRUE(this->Map->JoinBake(this->Surfaces(), Light(6), bake));
  std::filesystem::create_directories(this->Path + ".half"); // blocks the temporary file
  EXPECT_FALSE(this->File->Write(this->Path.c_str(), bake));
  EXPECT_NE(std::string(this->File->GetLastError()).find("cannot be written"), std::string::npos);
  EXPECT_EQ(this->Bytes(), before);
  EXPECT_FALSE(this->File->Write("/nowhere/map.vti", bake));
  EXPECT_FALSE(std::filesystem::exists("/nowhere"));
}
