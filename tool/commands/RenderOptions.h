// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The options of penumbra render.
#pragma once

#include "scene/model/SceneModel.h"

#include <optional>

namespace CLI
{
class App;
}

namespace penumbra::tool
{
struct RenderOptions
{
  std::vector<std::string> Files;
  std::string Output;
  std::vector<double> IsoValues;
  std::string IsoArray;
  std::vector<double> Opacities;
  std::optional<double> Smoothing;
  std::string ColorBy;
  std::string ColorMap;
  std::string ColorRange;
  bool ScalarBar = false;
  std::string Color;
  std::string Molecule;
  bool Terrain = false;
  std::optional<double> Exaggeration;
  std::optional<double> Spacing;
  std::optional<int> Stride;
  bool Points = false;
  std::optional<double> Radius;
  std::optional<double> FeatureAngle;
  std::string Size;
  std::string Preset;
  std::vector<std::string> On;
  std::vector<std::string> Off;
  std::vector<std::string> Set;
  std::vector<std::string> Bakes;
  std::vector<std::string> Lights;
  std::string Camera;
  std::string Environment;
  bool ShowEnvironment = false;
  std::string Background;
  std::string Look;
  std::string Backend = "auto";
  std::optional<int> Frames;
  std::optional<int> Samples;
  std::optional<double> Error;
  bool Denoise = false;
  std::string Checkpoint;
  long long MaximumTriangles = 10000000;
  std::optional<double> Budget;
  bool Statistics = false;
  std::string StatisticsPlot;
  bool Stock = false;
  bool Quiet = false;
  bool Verbose = false;
};

/// Declares the options that describe a scene: data, appearance, size.
void DeclareSceneOptions(CLI::App& command, RenderOptions& options);
void DeclareBackend(CLI::App& command, std::string& backend);
void DeclareRenderOptions(CLI::App& command, RenderOptions& options);

/// Reads the scene of the files or of the scene file, and applies the options. Throws a Failure for an invalid option.
Scene MakeScene(const RenderOptions& options);
}
