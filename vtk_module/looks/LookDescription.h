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
  double Angle = 0; ///< angular diameter in degrees
};

/// A bright rectangle or disc of the sky. See vtkGISoftBox.
struct LookSoftBox
{
  double Elevation = 45; ///< as a light's
  double Azimuth = 0;
  double Width = 40; ///< degrees
  double Height = 40;
  double Radius = 0; ///< of a disc in degrees; 0 for a rectangle
  double Radiance = 10;
  LookColor Color = { 1, 1, 1 };
  double Softness = 0.3;
};

/// See vtkGISkySource.
struct LookSkyDescription
{
  std::size_t Kind = 0; ///< one of vtkGISkySource::Kinds
  double Strength = 1;
  LookColor Color = { 1, 1, 1 };
  LookColor Zenith = { 1, 1, 1 };
  LookColor Horizon = { 0.6, 0.6, 0.6 };
  LookColor Ground = { 0.25, 0.25, 0.25 };
  LookColor GroundAlbedo = { 0.3, 0.3, 0.3 };
  double Turbidity = 2.5;
  double SunElevation = 40;
  double SunAzimuth = 0; ///< as a light's
  double SunStrength = 1;
  bool Visible = false;
  std::vector<LookSoftBox> Boxes;
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
  std::optional<LookSkyDescription> Sky;        ///< nothing: the renderer's own environment stays
  std::optional<LookBackground> Background;
  std::map<std::string, LookTechnique> Techniques;
};
}
