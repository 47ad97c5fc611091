// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph/FrameGraph.h"
#include "graph/Resources.h"

#include <stdexcept>

namespace
{
using namespace penumbra;

const TextureDesc Small{ GL_RGBA8, 4, 4, 0 };

std::vector<std::string> Order(const FrameGraph& graph)
{
  std::vector<std::string> names;
  for (const auto& step : graph.Steps())
  {
    names.push_back(step.Name);
  }
  return names;
}

using Names = std::vector<std::string>;

std::string ErrorOf(FrameGraph& graph)
{
  try
  {
    graph.Compile();
  }
  catch (const std::logic_error& error)
  {
    return error.what();
  }
  return "";
}

TEST(FrameGraph, WritersRunBeforeReaders)
{
  FrameGraph graph;
  graph.AddPass("present").Read("color").SideEffect();
  graph.AddPass("light").Read("normal").Read("mask").Write("color", Small);
  graph.AddPass("shadow").Read("normal").Write("mask", Small);
  graph.AddPass("capture").Write("normal", Small);
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "capture", "shadow", "light", "present" }));
}

TEST(FrameGraph, IndependentPassesKeepTheDeclaredOrder)
{
  FrameGraph graph;
  for (const char* name : { "c", "a", "b" })
  {
    graph.AddPass(name).Write(name, Small).SideEffect();
  }
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "c", "a", "b" }));
}

TEST(FrameGraph, UnusedPassesAreCulled)
{
  FrameGraph graph;
  graph.AddPass("capture").Write("normal", Small);
  graph.AddPass("unused").Read("normal").Write("mask", Small);
  graph.AddPass("unused too").Read("mask").Write("blurred", Small);
  graph.AddPass("light").Read("normal").Write("color", Small).SideEffect();
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "capture", "light" }));
}

TEST(FrameGraph, WithoutSideEffectsAllPassesAreCulled)
{
  FrameGraph graph;
  graph.AddPass("capture").Write("normal", Small);
  graph.Compile();
  EXPECT_TRUE(graph.Steps().empty());
}

TEST(FrameGraph, ReadIfPresent)
{
  FrameGraph graph;
  graph.AddPass("light").ReadIfPresent("mask").Write("color", Small).SideEffect();
  graph.Compile();
  ASSERT_EQ(graph.Steps().size(), 1u);
  EXPECT_EQ(graph.Steps()[0].Inputs.count("mask"), 0u);

  graph.AddPass("shadow").Write("mask", Small);
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "shadow", "light" }));
  EXPECT_EQ(graph.Steps()[1].Inputs.count("mask"), 1u);
}

TEST(FrameGraph, ModifiersRunByOrderBeforeReaders)
{
  FrameGraph graph;
  graph.AddPass("present").Read("color").SideEffect();
  graph.AddPass("sharpen").Modify("color", 20);
  graph.AddPass("denoise").Modify("color", 10);
  graph.AddPass("light").Write("color", Small);
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "light", "denoise", "sharpen", "present" }));
  // Each modifier reads a version of the resource and writes the next one; the last is final.
  int finals = 0;
  for (const auto& version : graph.Versions())
  {
    EXPECT_EQ(version.Resource, "color");
    EXPECT_EQ(version.Desc, Small);
    finals += version.IsFinal;
  }
  EXPECT_EQ(graph.Versions().size(), 3u);
  EXPECT_EQ(finals, 1);
  EXPECT_NE(graph.Steps()[1].Inputs.at("color"), graph.Steps()[1].Outputs.at("color"));
  EXPECT_EQ(graph.Steps()[3].Inputs.at("color"), graph.Steps()[2].Outputs.at("color"));
  EXPECT_TRUE(graph.Versions()[graph.Steps()[2].Outputs.at("color")].IsFinal);
}

TEST(FrameGraph, DrawOverKeepsTheTexture)
{
  FrameGraph graph;
  graph.AddPass("present").Read("light").SideEffect();
  graph.AddPass("sharpen").Modify("light", 20);
  graph.AddPass("map").DrawOver("light", 10);
  graph.AddPass("capture").Write("light", Small);
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "capture", "map", "sharpen", "present" }));
  const auto& steps = graph.Steps();
  const auto& versions = graph.Versions();
  const int first = steps[0].Outputs.at("light");
  const int second = steps[1].Outputs.at("light");
  const int third = steps[2].Outputs.at("light");
  EXPECT_EQ(steps[1].Inputs.at("light"), first);
  EXPECT_EQ(versions[first].Over, FrameGraph::None);
  EXPECT_EQ(versions[second].Over, first);
  EXPECT_EQ(versions[third].Over, FrameGraph::None);
  EXPECT_EQ(versions[first].Last, versions[second].First);

  FrameGraph nothing;
  nothing.AddPass("map").DrawOver("light", 0).SideEffect();
  EXPECT_EQ(ErrorOf(nothing), "frame graph: the pass 'map' needs 'light', which no pass writes");

  FrameGraph optional;
  optional.AddPass("map").DrawOverIfPresent("light", 0);
  optional.Compile();
  EXPECT_TRUE(optional.Steps().empty());
}

TEST(FrameGraph, VersionsUnderTheLastAreFinal)
{
  FrameGraph graph;
  graph.AddPass("light").Write("color", Small);
  graph.AddPass("reflect").Modify("color", 10);
  graph.AddPass("shade").DrawOverIfPresent("color", 20);
  graph.AddPass("mark").DrawOver("color", 30);
  graph.AddPass("present").Read("color").SideEffect();
  graph.Compile();
  ASSERT_EQ(Order(graph), (Names{ "light", "reflect", "shade", "mark", "present" }));
  std::vector<bool> finals;
  for (int step = 0; step < 4; ++step)
  {
    finals.push_back(graph.Versions()[graph.Steps()[step].Outputs.at("color")].IsFinal);
  }
  EXPECT_EQ(finals, (std::vector<bool>{ false, true, true, true }));
}

TEST(FrameGraph, VersionsHaveLifetimes)
{
  FrameGraph graph;
  graph.AddPass("capture").Write("normal", Small);
  graph.AddPass("shadow").Read("normal").Write("mask", Small);
  graph.AddPass("light").Read("mask").Write("color", Small);
  graph.AddPass("present").Read("color").SideEffect();
  graph.Compile();
  std::map<std::string, std::pair<int, int>> lifetimes;
  for (const auto& version : graph.Versions())
  {
    lifetimes[version.Resource] = { version.First, version.Last };
  }
  EXPECT_EQ(lifetimes["normal"], std::make_pair(0, 1));
  EXPECT_EQ(lifetimes["mask"], std::make_pair(1, 2));
  EXPECT_EQ(lifetimes["color"], std::make_pair(2, 3));
}

TEST(FrameGraph, ErrorsNamePassAndResource)
{
  FrameGraph twice;
  twice.AddPass("one").Write("color", Small).SideEffect();
  twice.AddPass("two").Write("color", Small).SideEffect();
  EXPECT_EQ(ErrorOf(twice), "frame graph: the passes 'one' and 'two' both write 'color'");

  FrameGraph missing;
  missing.AddPass("light").Read("normal").SideEffect();
  EXPECT_EQ(ErrorOf(missing), "frame graph: the pass 'light' needs 'normal', which no pass writes");

  FrameGraph nothingToModify;
  nothingToModify.AddPass("blur").Modify("color", 0).SideEffect();
  EXPECT_EQ(
    ErrorOf(nothingToModify), "frame graph: the pass 'blur' needs 'color', which no pass writes");

  FrameGraph cycle;
  cycle.AddPass("hatch").Read("egg").Write("chicken", Small).SideEffect();
  cycle.AddPass("lay").Read("chicken").Write("egg", Small);
  EXPECT_NE(ErrorOf(cycle).find("waits for a pass that waits for it"), std::string::npos);
}

TEST(FrameGraph, CompilingTwiceChangesNothing)
{
  FrameGraph graph;
  graph.AddPass("light").Write("color", Small).SideEffect();
  graph.Compile();
  graph.Compile();
  EXPECT_EQ(graph.Steps().size(), 1u);
  EXPECT_EQ(graph.Versions().size(), 1u);
}

// Passes use a history in the order of declaration, even if one of them could run earlier.
TEST(FrameGraph, HistoriesAreUsedInDeclaredOrder)
{
  History sums{ Texture::Borrow(1, Small), false };
  FrameGraph graph;
  graph.AddPass("show before").ReadHistory(sums, "sums").Write("before", Small).SideEffect();
  graph.AddPass("late").Read("light").UpdateHistory(sums, "sums").SideEffect();
  graph.AddPass("show after").ReadHistory(sums, "sums").Write("after", Small).SideEffect();
  graph.AddPass("early").Read("before").Write("light", Small);
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "show before", "early", "late", "show after" }));
}

TEST(FrameGraph, WritersOfAHistoryThatIsReadLaterAreKept)
{
  History read{ Texture::Borrow(1, Small), false };
  History unread{ Texture::Borrow(2, Small), false };
  FrameGraph graph;
  graph.AddPass("fill").WriteHistory(read);
  graph.AddPass("continue").UpdateHistory(read);
  graph.AddPass("unused").WriteHistory(unread);
  graph.AddPass("show").ReadHistory(read, "read").SideEffect();
  graph.AddPass("too late").UpdateHistory(read);
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "fill", "continue", "show" }));
}

TEST(FrameGraph, CyclesThroughHistoriesAreAnError)
{
  History kept{ Texture::Borrow(1, Small), false };
  FrameGraph graph;
  graph.AddPass("first").Read("light").WriteHistory(kept).SideEffect();
  graph.AddPass("second").ReadHistory(kept, "kept").Write("light", Small);
  EXPECT_NE(ErrorOf(graph).find("waits for a pass that waits for it"), std::string::npos);
}

TEST(FrameGraph, APassMayReadAndOverwriteAHistory)
{
  History kept{ Texture::Borrow(1, Small), false };
  FrameGraph graph;
  graph.AddPass("first").WriteHistory(kept);
  graph.AddPass("both").ReadHistory(kept, "kept").WriteHistory(kept).SideEffect();
  graph.AddPass("both again").WriteHistory(kept).ReadHistory(kept, "kept").SideEffect();
  graph.Compile();
  EXPECT_EQ(Order(graph), (Names{ "first", "both", "both again" }));
}

TEST(FrameGraph, DeclaredInputsAreBoundByName)
{
  History kept{ Texture::Borrow(1, Small), false };
  FrameGraph graph;
  graph.AddPass("capture").Write(resource::Albedo, Small).Write("own", Small);
  graph.AddPass("light")
    .Read(resource::Albedo)
    .Read("own", "ownTexture")
    .ReadIfPresent(resource::Sky, "GI_SKY")
    .ReadIfPresent(resource::Albedo, "GI_ALBEDO")
    .UpdateHistory(kept, "sums")
    .Write("color", Small, "picture")
    .Offer(Arguments().Set("strength", 2.0))
    .SideEffect();
  graph.Compile();
  const FrameGraph::Step& step = graph.Steps().back();
  EXPECT_EQ(step.InputSamplers.at(resource::Albedo), "albedoTexture");
  EXPECT_EQ(step.InputSamplers.at("own"), "ownTexture");
  EXPECT_EQ(step.OutputImages.at("color"), "picture");
  EXPECT_EQ(step.Variant, (Defines{ { "GI_ALBEDO", "1" } }));
  EXPECT_EQ(step.Offered.Images().count("sums"), 1u);
  EXPECT_EQ(step.Offered.Values().count("strength"), 1u);
  EXPECT_EQ(step.Written, std::vector<History*>{ &kept });
}
}
