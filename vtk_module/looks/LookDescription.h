// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The content of a look's file.
 */
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{
using LookColor = std::array<double, 3>;

struct LookLight
{
  double Elevation = 45; ///< degrees above the horizon
  double Azimuth = 0;    ///< degrees to the right of the viewer
  LookColor Color = { 1, 1, 1 };
  double Intensity = 1;
};

struct LookBackground
{
  LookColor Bottom = { 0, 0, 0 };
  LookColor Top = { 0, 0, 0 };
};

/// What a look sets of a technique.
struct LookTechnique
{
  std::optional<bool> Enabled;
  std::map<std::string, double> Parameters;
};

struct LookDescription
{
  std::string Title;
  std::string Text;
  bool FollowsCamera = true; ///< else fixed to the world
  /// The axis that points up in the world, or nothing for the axis nearest to the camera's view-up.
  std::optional<std::array<double, 3>> Up;
  std::optional<std::vector<LookLight>> Lights; ///< nothing: the renderer's own lights stay on
  std::optional<LookBackground> Background;
  std::map<std::string, LookTechnique> Techniques;
};
}
