// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// The parameter tables of all techniques, as scripts and the command line use them.
#include "vtkGIPass.h"
#include "vtkGIShadowMaps.h"
#include "vtkGITechnique.h"

#include "Messages.h"

#include <regex>
#include <set>

namespace
{
template <typename Visit>
void ForEachTechnique(Visit visit)
{
  vtkNew<vtkGIPass> pass;
  ASSERT_GT(pass->GetNumberOfTechniques(), 0);
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    SCOPED_TRACE(pass->GetTechnique(i)->GetName());
    visit(pass->GetTechnique(i));
  }
}

TEST(Parameters, TechniquesDescribeThemselves)
{
  std::set<std::string> names;
  const std::regex kebab("[a-z]+(-[a-z0-9]+)*");
  ForEachTechnique([&](vtkGITechnique* technique) {
    EXPECT_TRUE(names.insert(technique->GetName()).second) << "the name is taken";
    EXPECT_TRUE(std::regex_match(technique->GetName(), kebab));
    for (const char* text : { technique->GetTitle(), technique->GetTerm(), technique->GetVerb(),
           technique->GetDynamic(), technique->GetSource() })
    {
      EXPECT_GT(std::string(text).size(), 1u);
    }
  });
}

TEST(Parameters, EachHasADocumentationAndItsDefault)
{
  const std::regex kebab("[a-z]+(-[a-z0-9]+)*");
  ForEachTechnique([&](vtkGITechnique* technique) {
    std::set<std::string> names;
    technique->SetDefaults();
    for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
    {
      const std::string name = technique->GetParameterName(i);
      SCOPED_TRACE(name);
      EXPECT_TRUE(std::regex_match(name, kebab));
      EXPECT_TRUE(names.insert(name).second);
      EXPECT_GT(std::string(technique->GetParameterDocumentation(i)).size(), 10u);
      const double value = technique->GetParameterDefault(i);
      EXPECT_LE(technique->GetParameterMinimum(i), value);
      EXPECT_GE(technique->GetParameterMaximum(i), value);
      EXPECT_EQ(technique->GetParameter(name.c_str()), value);
      const std::string type = technique->GetParameterType(i);
      EXPECT_TRUE(type == "bool" || type == "int" || type == "double" || type == "enum") << type;
      EXPECT_EQ(type == "enum", technique->GetNumberOfParameterValues(i) > 0);
    }
  });
}

TEST(Parameters, BoundsAreAcceptedAndValuesBeyondAreRefused)
{
  ForEachTechnique([](vtkGITechnique* technique) {
    for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
    {
      const char* name = technique->GetParameterName(i);
      SCOPED_TRACE(name);
      for (const double bound :
        { technique->GetParameterMinimum(i), technique->GetParameterMaximum(i) })
      {
        EXPECT_TRUE(technique->SetParameter(name, bound));
        EXPECT_EQ(technique->GetParameter(name), bound);
        EXPECT_STREQ(technique->GetLastError(), "");
      }
      const double before = technique->GetParameter(name);
      const double below = technique->GetParameterMinimum(i) - 1.0;
      EXPECT_FALSE(technique->SetParameter(name, below));
      EXPECT_NE(std::string(technique->GetLastError()).find(name), std::string::npos);
      EXPECT_EQ(technique->GetParameter(name), before);
      EXPECT_EQ(penumbra_test::TakeMessages().size(), 1u);
    }
  });
}

TEST(Parameters, EnumsByName)
{
  ForEachTechnique([](vtkGITechnique* technique) {
    for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
    {
      const char* name = technique->GetParameterName(i);
      for (int value = 0; value < technique->GetNumberOfParameterValues(i); ++value)
      {
        const char* text = technique->GetParameterValueName(i, value);
        EXPECT_TRUE(technique->SetParameterFromText(name, text));
        EXPECT_EQ(technique->GetParameter(name), value);
      }
      EXPECT_EQ(technique->GetParameterValueName(i, -1), nullptr);
      if (technique->GetNumberOfParameterValues(i) > 0)
      {
        EXPECT_FALSE(technique->SetParameterFromText(name, "no such value"));
        EXPECT_EQ(penumbra_test::TakeMessages().size(), 1u);
      }
    }
  });
}

TEST(Parameters, IndicesOutOfRange)
{
  ForEachTechnique([](vtkGITechnique* technique) {
    for (const int index : { -1, technique->GetNumberOfParameters() })
    {
      EXPECT_EQ(technique->GetParameterName(index), nullptr);
      EXPECT_EQ(technique->GetParameterType(index), nullptr);
      EXPECT_EQ(technique->GetParameterDefault(index), 0.0);
      EXPECT_EQ(technique->GetNumberOfParameterValues(index), 0);
      EXPECT_EQ(technique->GetParameterValueName(index, 0), nullptr);
    }
  });
}

TEST(Parameters, PresetsStartFromDefaults)
{
  vtkNew<vtkGIPass> pass;
  for (int i = 0; i < vtkGIPass::GetNumberOfPresets(); ++i)
  {
    const char* preset = vtkGIPass::GetPresetName(i);
    pass->GetTechnique("shadow-maps")->SetParameter("slope-bias", 7.0);
    EXPECT_TRUE(pass->SetPreset(preset));
    EXPECT_EQ(pass->GetTechnique("shadow-maps")->GetParameter("slope-bias"), 0.4) << preset;
    // The path tracer needs none of the techniques that approximate its light.
    const bool reference = std::string(preset) == "reference";
    EXPECT_EQ(
      pass->GetTechnique("shadow-maps")->GetEnabled(), !reference && std::string(preset) != "off");
    EXPECT_EQ(pass->GetTechnique("path-tracing")->GetEnabled(), reference);
  }
  EXPECT_EQ(vtkGIPass::GetPresetName(-1), nullptr);
}

TEST(Parameters, TypedSettersClamp)
{
  vtkNew<vtkGIShadowMaps> shadows;
  shadows->SetResolution(1 << 30);
  EXPECT_EQ(shadows->GetResolution(), 16384);
  EXPECT_EQ(shadows->GetParameter("resolution"), 16384.0);
  shadows->SetSlopeBias(-3.0);
  EXPECT_EQ(shadows->GetSlopeBias(), 0.0);
}

TEST(Parameters, ChangesUpdateTheModificationTime)
{
  ForEachTechnique([](vtkGITechnique* technique) {
    for (int i = 0; i < technique->GetNumberOfParameters(); ++i)
    {
      technique->SetDefaults();
      const vtkMTimeType before = technique->GetMTime();
      const double other = technique->GetParameterDefault(i) == technique->GetParameterMinimum(i)
        ? technique->GetParameterMaximum(i)
        : technique->GetParameterMinimum(i);
      technique->SetParameter(technique->GetParameterName(i), other);
      EXPECT_GT(technique->GetMTime(), before) << technique->GetParameterName(i);
    }
  });
}

// Messages of VTK's macros are recorded, so that unexpected ones fail the tests.
TEST(Parameters, TestsRecordErrors)
{
  vtkNew<vtkGIPass> pass;
  pass->SetPreset("none such");
  const auto messages = penumbra_test::TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("choose off, fast, balanced, high or reference"), std::string::npos);
}
}
