// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/RenderOptions.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace penumbra::tool
{
namespace
{
void DeclareData(CLI::App& command, RenderOptions& options)
{
  const char* group = "Data";
  command.add_option("FILE", options.Files, "data files, or one scene file (.json)")->required();
  command.add_option("--isovalue", options.IsoValues, "value of an isosurface; may be repeated")
    ->allow_extra_args(false)
    ->group(group);
  command.add_option("--isosurface-of", options.IsoArray, "point array to make isosurfaces of")
    ->group(group);
  command
    .add_option(
      "--smooth", options.Smoothing, "smooth volumes first, by this many voxels (0 to 20)")
    ->group(group);
  command.add_option("--molecule", options.Molecule, "balls (default), ball-and-stick or sticks")
    ->group(group);
  command
    .add_flag("--terrain", options.Terrain, "take a flat image as elevations (pictures always are)")
    ->group(group);
  command.add_option("--exaggeration", options.Exaggeration, "heights of terrain times this")
    ->group(group);
  command.add_option("--spacing", options.Spacing, "distance between samples of terrain")
    ->group(group);
  command.add_option("--stride", options.Stride, "take every n-th sample of terrain")->group(group);
  command.add_flag("--points", options.Points, "draw points as balls")->group(group);
  command.add_option("--radius", options.Radius, "radius of balls at points and tubes along lines")
    ->group(group);
  command
    .add_option(
      "--feature-angle", options.FeatureAngle, "degrees above which an edge is drawn sharp")
    ->group(group);
  command
    .add_option("--max-triangles", options.MaximumTriangles, "refuse scenes with more triangles")
    ->group(group)
    ->capture_default_str();
}

void DeclareLook(CLI::App& command, RenderOptions& options)
{
  const char* group = "Look";
  command
    .add_option(
      "--color-by", options.ColorBy, "point or cell array to colour by, or ARRAY:x, :y, :z, :INDEX")
    ->group(group);
  command
    .add_option(
      "--color-map", options.ColorMap, "viridis, plasma, inferno, cool-warm, terrain or gray")
    ->group(group);
  command.add_option("--color-range", options.ColorRange, "LOW,HIGH of the colour map")
    ->group(group);
  command.add_flag("--scalar-bar", options.ScalarBar, "show the colour map with its numbers")
    ->group(group);
  command
    .add_option(
      "--color", options.Color, "one colour for all: #rrggbb, r,g,b from 0 to 1, or a name")
    ->group(group);
  command
    .add_option(
      "--opacity", options.Opacities, "opacity, repeated: of the first isosurface, the second...")
    ->allow_extra_args(false)
    ->group(group);
  command
    .add_option(
      "--background", options.Background, "a colour, bottom=COLOR,top=COLOR, or transparent")
    ->group(group);
  command
    .add_option("--light", options.Lights,
      "a light, may be repeated: key:azimuth=-40,elevation=50,intensity=1 (follows the camera), "
      "head, "
      "directional:X,Y,Z, point:X,Y,Z, cone:X,Y,Z,target=X,Y,Z,angle=25")
    ->allow_extra_args(false)
    ->group(group);
  command
    .add_option("--camera", options.Camera,
      "azimuth=30,elevation=20,zoom=1.2,roll=0,parallel, or "
      "position=X,Y,Z,focal=X,Y,Z,up=X,Y,Z,angle=30")
    ->group(group);
  command
    .add_option(
      "--env", options.Environment, "environment map (.hdr, .exr, .jpg) that lights the scene")
    ->group(group);
  command.add_flag("--show-env", options.ShowEnvironment, "show the environment as the background")
    ->group(group);
}

constexpr const char* TechniqueGroup = "Global illumination";
constexpr const char* OutputGroup = "Output";

void DeclareParameters(CLI::App& command, RenderOptions& options)
{
  command.add_option("--set", options.Set, "TECHNIQUE.PARAMETER=VALUE; may be repeated")
    ->allow_extra_args(false)
    ->group(TechniqueGroup);
}

void DeclareTechniques(CLI::App& command, RenderOptions& options)
{
  const char* group = TechniqueGroup;
  command
    .add_option(
      "--preset", options.Preset, "off, fast, balanced (default), high or reference (path tracing)")
    ->group(group);
  command.add_option("--on", options.On, "switch a technique on; may be repeated")
    ->allow_extra_args(false)
    ->group(group);
  command.add_option("--off", options.Off, "switch a technique off; may be repeated")
    ->allow_extra_args(false)
    ->group(group);
  DeclareParameters(command, options);
  command
    .add_option(
      "--bake", options.Bakes, "file of penumbra bake whose light to use; may be repeated")
    ->allow_extra_args(false)
    ->group(group);
  command.add_flag("--stock", options.Stock, "draw as VTK does without Penumbra")->group(group);
}

void DeclareBackend(CLI::App& command, RenderOptions& options)
{
  command.add_option("--backend", options.Backend, "egl, osmesa, x11 or auto")
    ->capture_default_str()
    ->group(OutputGroup);
}

void DeclareDrawing(CLI::App& command, RenderOptions& options, const char* size)
{
  command.add_option("--size", options.Size, fmt::format("WIDTHxHEIGHT of the picture [{}]", size))
    ->group(OutputGroup);
  command.add_flag("--stats", options.Statistics, "print statistics and timings as JSON on stdout")
    ->group(OutputGroup);
  command.add_flag("-q,--quiet", options.Quiet, "no notes, no progress")->group(OutputGroup);
  command.add_flag("--verbose", options.Verbose, "let libraries print")->group(OutputGroup);
}

void DeclareOutput(CLI::App& command, RenderOptions& options)
{
  const char* group = OutputGroup;
  command
    .add_option("-o,--output", options.Output,
      "picture: .png, .jpg, .tif, or .exr and .hdr with linear radiance")
    ->required()
    ->group(group);
  command.add_option("--frames", options.Frames, "still frames to accumulate [16]")->group(group);
  command
    .add_option(
      "--spp", options.Samples, "paths traced through each pixel, with --preset reference")
    ->group(group);
  command
    .add_option("--error", options.Error,
      "stop tracing at this standard error of the picture, relative to its mean luminance")
    ->group(group);
  command
    .add_option("--checkpoint", options.Checkpoint,
      "file (.vti) that keeps what was traced: where it exists tracing goes on from it")
    ->group(group);
  DeclareDrawing(command, options, "1280x720");
  DeclareBackend(command, options);
}
}

void DeclareSceneOptions(CLI::App& command, RenderOptions& options, const char* size, bool drawn)
{
  DeclareData(command, options);
  DeclareLook(command, options);
  DeclareDrawing(command, options, size);
  if (drawn)
  {
    DeclareParameters(command, options);
    DeclareBackend(command, options);
  }
}

void DeclareRenderOptions(CLI::App& command, RenderOptions& options)
{
  DeclareOutput(command, options);
  DeclareData(command, options);
  DeclareLook(command, options);
  DeclareTechniques(command, options);
  command.footer(
    "Examples:\n"
    "  penumbra render head.nii.gz -o head.png\n"
    "  penumbra render ct.vti --isovalue 500 --isovalue 1150 --opacity 0.3 --opacity 1 -o ct.png\n"
    "  penumbra render can.vtu --color-by VEL --color-map cool-warm --scalar-bar -o can.png\n"
    "  penumbra render protein.pdb --preset high --size 1920x1080 -o protein.png\n"
    "  penumbra render elevation.npz --light key:azimuth=-60,elevation=25 -o terrain.exr\n"
    "  penumbra render helmet.glb --env sky.hdr --set ambient-occlusion.samples=32 -o helmet.png\n"
    "  penumbra render scene.json -o scene.png --stats");
}
}
