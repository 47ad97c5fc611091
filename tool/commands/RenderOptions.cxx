// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/RenderOptions.h"

#include "commands/OptionGroup.h"

#include <fmt/format.h>

namespace penumbra::tool
{
namespace
{
constexpr const char* TechniqueGroup = "Global illumination";
constexpr const char* OutputGroup = "Output";

void DeclareData(CLI::App& command, RenderOptions& options)
{
  command.add_option("FILE", options.Files, "data files, or one scene file (.json)")->required();
  OptionGroup data(command, "Data");
  data.Add("--isovalue", options.IsoValues, "value of an isosurface; may be repeated");
  data.Add("--isosurface-of", options.IsoArray, "point array of the isosurfaces");
  data.Add("--smooth", options.Smoothing,
    "smooth volumes with a Gaussian of this many voxels (0 to 20)", Bounds{ 0, 20 });
  data.Add("--molecule", options.Molecule, "balls (default), ball-and-stick or sticks");
  data.Flag("--terrain", options.Terrain,
    "interpret a flat image as elevations, as is always done with pictures");
  data.Add(
    "--exaggeration", options.Exaggeration, "factor of terrain heights", Bounds{ -1e12, 1e12 });
  data.Add(
    "--spacing", options.Spacing, "distance between samples of terrain", Bounds{ 1e-12, 1e12 });
  data.Add("--stride", options.Stride, "use every n-th sample of terrain", Bounds{ 1, 10000 });
  data.Flag("--points", options.Points, "draw points as balls");
  data.Add("--radius", options.Radius, "radius of balls at points and tubes along lines",
    Bounds{ 0, 1e15 });
  data.Add("--feature-angle", options.FeatureAngle, "angle in degrees above which edges are sharp",
    Bounds{ 0, 180 });
  data.AddShown("--max-triangles", options.MaximumTriangles,
    "maximum number of triangles in the scene", Bounds{ 1, 1e12 });
}

void DeclareAppearance(CLI::App& command, RenderOptions& options)
{
  OptionGroup group(command, "Appearance");
  group.Add("--color-by", options.ColorBy,
    "point or cell array that gives colours, or ARRAY:x, :y, :z, :INDEX");
  group.Add(
    "--color-map", options.ColorMap, "viridis, plasma, inferno, cool-warm, terrain or gray");
  group.Add("--color-range", options.ColorRange, "range of the colour map: LOW,HIGH");
  group.Flag("--scalar-bar", options.ScalarBar, "show the colour map and its values");
  group.Add(
    "--color", options.Color, "colour of all objects: #rrggbb, r,g,b from 0 to 1, or a name");
  group.Add("--opacity", options.Opacities,
    "opacity; repeat it for the second isosurface, and so on", Bounds{ 0, 1 });
  group.Add("--background", options.Background, "a colour, bottom=COLOR,top=COLOR, or transparent");
  group.Add("--light", options.Lights,
    "a light, may be repeated: key:azimuth=-40,elevation=50,intensity=1 (follows the camera), "
    "head, "
    "directional:X,Y,Z,angle=0.53, point:X,Y,Z,disc=1, cone:X,Y,Z,target=X,Y,Z,angle=25");
  group.Add("--camera", options.Camera,
    "azimuth=30,elevation=20,zoom=1.2,roll=0,parallel, or "
    "position=X,Y,Z,focal=X,Y,Z,up=X,Y,Z,angle=30");
  group.Add(
    "--env", options.Environment, "environment map (.hdr, .exr, .jpg) that lights the scene");
  group.Flag("--show-env", options.ShowEnvironment, "show the environment as the background");
}

void DeclareTechniques(CLI::App& command, RenderOptions& options)
{
  OptionGroup techniques(command, TechniqueGroup);
  techniques.Add(
    "--preset", options.Preset, "off, fast, balanced (default), high or reference (path tracing)");
  techniques.Add("--look", options.Look,
    "set-up of light and background: a name, of which penumbra info lists all, a file (.json), or "
    "as-is for the scene's "
    "own light [studio, or as-is where the scene has lights]");
  techniques.Add("--on", options.On, "switch a technique on; may be repeated");
  techniques.Add("--off", options.Off, "switch a technique off; may be repeated");
  techniques.Add("--set", options.Set, "TECHNIQUE.PARAMETER=VALUE; may be repeated");
  techniques.Add(
    "--bake", options.Bakes, "file written by penumbra bake, whose light is used; may be repeated");
  techniques.Flag("--stock", options.Stock, "draw with plain VTK, without Penumbra");
}

void DeclareDrawing(CLI::App& command, RenderOptions& options, const char* size)
{
  OptionGroup output(command, OutputGroup);
  output.Add("--size", options.Size, fmt::format("WIDTHxHEIGHT of the picture [{}]", size));
  output.Flag("--stats", options.Statistics, "print statistics and timings as JSON on stdout");
  output.Flag("-q,--quiet", options.Quiet, "no notes and no progress");
  output.Flag("--verbose", options.Verbose, "show the output of libraries");
}

void DeclareOutput(CLI::App& command, RenderOptions& options)
{
  OptionGroup output(command, OutputGroup);
  output
    .Add("-o,--output", options.Output,
      "picture: .png, .jpg, .tif, or .exr and .hdr with linear radiance")
    ->required();
  output.Add("--frames", options.Frames, "number of frames to accumulate [16]", Bounds{ 1, 65536 });
  output.Add("--spp", options.Samples, "paths per pixel, with --preset reference");
  output.Flag("--denoise", options.Denoise,
    "filter the noise of few paths, with --preset reference; an exr also holds the noisy picture");
  output.Add("--budget", options.Budget,
    "draw what a moving picture looks like if a frame may take this many milliseconds on this "
    "machine: the last of 120 frames (or --frames) in which the camera turns",
    Bounds{ 1, 10000 });
  output.Add("--stats-plot", options.StatisticsPlot,
    "chart of where the last frame's time went, and what more time would buy: .svg or .png");
  output.Add("--error", options.Error,
    "stop tracing at this standard error, relative to the mean luminance of the picture");
  output.Add("--checkpoint", options.Checkpoint,
    "file (.vti) that stores the samples; if it exists, tracing resumes from it");
  DeclareDrawing(command, options, "1280x720");
  DeclareBackend(command, options.Backend);
}
}

void DeclareBackend(CLI::App& command, std::string& backend)
{
  OptionGroup(command, OutputGroup).AddShown("--backend", backend, "egl, osmesa, x11 or auto");
}

void DeclareSceneOptions(CLI::App& command, RenderOptions& options)
{
  DeclareData(command, options);
  DeclareAppearance(command, options);
  DeclareDrawing(command, options, "the scene's");
}

void DeclareRenderOptions(CLI::App& command, RenderOptions& options)
{
  DeclareOutput(command, options);
  DeclareData(command, options);
  DeclareAppearance(command, options);
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
