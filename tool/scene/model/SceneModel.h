// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// The scene as plain data, as described by the command line or the scene file. Default values are those documented for
/// the scene file.
#pragma once

#include <vtkGISkySource.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace penumbra::tool
{
using Vec3 = std::array<double, 3>;

enum class Culling
{
  None,
  Back,
  Front
};

struct Material
{
  int Shading = VTK_GOURAUD; ///< VTK_FLAT, VTK_GOURAUD, VTK_PHONG or VTK_PBR
  Vec3 Color = { 1, 1, 1 };
  double Ambient = 0;
  double Diffuse = 1;
  double Specular = 0;
  double SpecularPower = 1;
  std::optional<Vec3> SpecularColor; ///< white if not set
  double Metallic = 0;               ///< PBR only, as roughness
  double RefractiveIndex = 1.5;      ///< PBR only; 1 means no highlight
  double Roughness = 0.5;
  Vec3 Emission = { 0, 0, 0 }; ///< radiance
  double Opacity = 1;
  bool Lighting = true;
  int Representation = VTK_SURFACE;
  Culling Cull = Culling::None;
  std::optional<Vec3> EdgeColor; ///< edges are drawn if set
  double LineWidth = 1;
  double PointSize = 3;
  std::string Texture; ///< colour; for PBR, base colour
  std::string NormalTexture;
  std::string OrmTexture; ///< occlusion, roughness, metallic in red, green, blue
  std::string EmissionTexture;
  std::optional<Vec3> BackColor; ///< colour of back faces, if different
};

struct ColorBy
{
  std::string Array;
  std::string Component; ///< "", "magnitude", "x", "y", "z" or an index
  std::optional<std::array<double, 2>> Range;
  std::string Map = "viridis";
  bool ScalarBar = false;
};

struct Terrain
{
  std::optional<double> Exaggeration; ///< chosen from the relief if not set
  std::optional<double> Spacing;      ///< world units between samples; by default the file's, or 1
  int Stride = 1;                     ///< use every n-th sample
};

enum class MoleculeStyle
{
  Balls,
  BallAndStick,
  Sticks
};

/// A simple shape. Each kind uses some of the fields.
struct Primitive
{
  std::string Kind; ///< see PrimitiveTable() in scene/build/Shapes.cxx
  Vec3 Center = { 0, 0, 0 };
  Vec3 Size = { 1, 1, 1 };   ///< box; plane uses the first two
  Vec3 Normal = { 0, 0, 1 }; ///< plane and disk; axis of cylinder, cone and torus
  double Radius = 0.5;
  double InnerRadius = 0; ///< disk: hole; torus: radius of the tube
  double Height = 1;
  int Resolution = 64;
};

/// Geometry given in the scene file.
struct Mesh
{
  std::vector<Vec3> Points;
  std::vector<std::vector<long long>> Polygons;
  std::vector<std::vector<long long>> Lines;
  std::vector<Vec3> Normals;
  std::vector<std::array<double, 2>> TextureCoordinates;
  std::map<std::string, std::vector<double>> PointArrays;
  std::map<std::string, std::vector<double>> CellArrays;
};

struct Placement
{
  Vec3 Translate = { 0, 0, 0 };
  Vec3 Rotate = { 0, 0, 0 }; ///< degrees about x, then y, then z
  Vec3 Scale = { 1, 1, 1 };
};

struct Object
{
  std::string Name;
  std::string Path; ///< either Path, Shape or Geometry
  std::optional<Primitive> Shape;
  std::optional<Mesh> Geometry;
  std::vector<double> IsoValues;
  std::string IsoArray;
  std::vector<double>
    Opacities;          ///< one per isosurface, outermost first; the last is used for all others
  double Smoothing = 0; ///< volumes: Gaussian standard deviation in voxels
  std::optional<ColorBy> Color;
  std::optional<Terrain> Heights;
  MoleculeStyle Molecule = MoleculeStyle::Balls;
  std::optional<Material> Appearance; ///< a default material if not set
  std::optional<Placement> Place;
  std::optional<double> FeatureAngle; ///< degrees; edges with a greater angle are sharp
  bool PointsAsBalls = false;
  double Radius = 0; ///< of balls at points and of tubes along lines; 0 for automatic
};

enum class LightKind
{
  Key,         ///< directional, fixed to the camera
  Head,        ///< at the camera
  Directional, ///< from Position towards Target
  Point,
  Cone
};

struct Light
{
  LightKind Kind = LightKind::Directional;
  Vec3 Position = { 0, 0, 1 };
  Vec3 Target = { 0, 0, 0 };
  double Azimuth = -40; ///< key: degrees to the right of the camera
  double Elevation = 45;
  double Angle = 30; ///< cone: half angle in degrees
  double Exponent = 1;
  std::optional<double> Diameter; ///< key and directional: angle in degrees
  std::optional<double> Radius;   ///< point and cone: of a sphere
  std::optional<double> Disc;     ///< point and cone: radius
  std::vector<double> Rectangle;  ///< point and cone: width and height, or empty
  double Turn = 0;                ///< rectangle: degrees about its axis
  Vec3 Attenuation = { 1, 0, 0 };
  Vec3 Color = { 1, 1, 1 };
  double Intensity = 1;
  bool On = true;
};

struct Camera
{
  std::optional<Vec3> Position; ///< chosen to show the whole scene if not set
  std::optional<Vec3> FocalPoint;
  std::optional<Vec3> ViewUp;
  double ViewAngle = 30;
  std::optional<double> Azimuth; ///< degrees about the up axis, from the default view
  std::optional<double> Elevation;
  double Roll = 0;
  double Zoom = 1;
  bool Parallel = false;
  std::optional<double> ParallelScale;
};

struct EnvironmentMap
{
  std::string Path;                    ///< a picture, or "" with a sky
  vtkSmartPointer<vtkGISkySource> Sky; ///< its directions of the world are set with the scene
  bool Visible = false;                ///< shown as the background
};

struct Background
{
  Vec3 Bottom = { 0.74, 0.77, 0.81 };
  Vec3 Top = { 0.95, 0.96, 0.97 };
  bool Transparent = false;
};

struct ParameterSetting
{
  std::string Technique;
  std::string Parameter;
  std::string Value;
};

struct TechniqueSettings
{
  std::string Preset = "balanced";
  std::vector<std::string> On;
  std::vector<std::string> Off;
  std::vector<ParameterSetting> Parameters;
};

/// The look of a scene that keeps its own lights and background.
constexpr const char* OwnLook = "as-is";

struct Scene
{
  std::vector<Object> Objects;
  std::optional<std::vector<Light>> Lights; ///< a key light and a weak headlight if not set
  Camera View;
  std::optional<EnvironmentMap> Environment;
  std::optional<Background> Backdrop; ///< that of the look, or a grey gradient, if not set
  std::string Look;                   ///< name or file
  bool LookGiven = false;             ///< asked for, not chosen
  TechniqueSettings Techniques;
  std::vector<std::string> Bakes; ///< files of baked light
  int Width = 1280;
  int Height = 720;
  int Frames = 16;          ///< number of frames to accumulate
  bool FramesGiven = false; ///< set on the command line, and valid for the path tracer too
  bool DepthPeeling = true;
};
}
