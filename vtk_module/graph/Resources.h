// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Names of the resources that passes share. Techniques interact only through these.
 */
#pragma once

#include <map>
#include <string>

namespace penumbra
{
namespace resource
{
constexpr const char* Depth = "depth";               ///< the depth buffer, to test against
constexpr const char* Albedo = "gbuffer.albedo";     ///< rgb, a: 1 where captured
constexpr const char* Normal = "gbuffer.normal";     ///< octahedral, material
constexpr const char* Facet = "gbuffer.facet";       ///< see capture/declarations.glsl
constexpr const char* DepthCopy = "gbuffer.depth";   ///< a copy of it for shaders to read
constexpr const char* Ambient = "gbuffer.ambient";   ///< reflected ambient light
constexpr const char* Surface = "gbuffer.surface";   ///< see capture/declarations.glsl
constexpr const char* Emission = "gbuffer.emission"; ///< emitted radiance
constexpr const char* Displacement =
  "gbuffer.displacement"; ///< vector to the previous position of a point of a deforming surface
constexpr const char* DirectVisibility = "visibility.direct"; ///< a channel per shadowed light
constexpr const char* Surroundings =
  "gbuffer.surroundings"; ///< the part of Ambient that PBR highlights reflect from the environment
/// How far a filter of direct visibility may reach, in scene units, in the same channels; 0 if unknown.
constexpr const char* VisibilityReach = "visibility.reach";
constexpr const char* AmbientVisibility =
  "visibility.ambient";                          ///< r: openness; for other channels see giOpen()
constexpr const char* Irradiance = "irradiance"; ///< see IndirectLight.h
constexpr const char* TracedIrradiance = "irradiance.rays"; ///< what rays add to it; a: see accumulate.frag
constexpr const char* MeanTracedIrradiance = "irradiance.rays.mean"; ///< see NoisyResource::Mean
/// Mean light that paths carried to lit surfaces, divided by their colours; a: number of paths, and in its fraction the
/// relative standard error of the luminance. Only if LightingPlan::FiltersNoise().
constexpr const char* PathLight = "paths.light";
/// Mean surface of the paths: octahedral normal in view coordinates, depth in the window, 1 where they met any.
constexpr const char* PathSurface = "paths.surface";
constexpr const char* LampLight = "irradiance.lamps"; ///< see IndirectLight.h
/// Where each pixel's surface was in the previous frame, and for how many frames it has been visible, see
/// temporal_accumulation/reproject.frag.
constexpr const char* Reprojection = "reprojection";
/// A skybox behind everything, if there is one. rgb: output of its shader, unclamped; a: 1 if rgb is encoded for
/// display.
constexpr const char* Sky = "sky";
constexpr const char* Backdrop =
  "backdrop"; ///< the window before the frame: background, lower layers
constexpr const char* LitRadiance = "radiance.lit"; ///< linear, with direct light; on request only
/// Linear radiance of lit surfaces whose values VTK shows as they are (Phong), times the share of the pixel that they
/// cover, which is a. Only if LightingPlan::MapsTones().
constexpr const char* LitShown = "radiance.shown";
constexpr const char* LitEncoded = "radiance.encoded"; ///< of those that VTK encodes for display (PBR)
constexpr const char* Reflection = "reflection";    ///< radiance over each pixel's lobe, confidence
/// How far a filter of reflections may reach, in scene units; 0 if unknown, negative where nothing reflects.
constexpr const char* ReflectionReach = "reflection.reach";
/// Coverage of edge pixels by the surfaces around them, see anti_aliasing/coverage.glsl.
constexpr const char* EdgeCoverage = "edge-coverage";
constexpr const char* Color = "color";              ///< the picture, encoded for display
constexpr const char* Radiance = "radiance";        ///< the picture, linear
}

namespace resource
{
/// Name of a shared resource in shaders, unless their pass declares another one; "" for none.
inline std::string SamplerOf(const std::string& resource)
{
  static const std::map<std::string, std::string> names = { { Albedo, "albedoTexture" },
    { Normal, "normalTexture" }, { Facet, "facetTexture" }, { DepthCopy, "depthTexture" },
    { Ambient, "ambientTexture" }, { Surface, "surfaceTexture" }, { Emission, "emissionTexture" },
    { Displacement, "displacementTexture" }, { DirectVisibility, "directVisibility" },
    { VisibilityReach, "reachTexture" }, { Surroundings, "surroundingsTexture" },
    { AmbientVisibility, "ambientVisibility" }, { Irradiance, "irradianceTexture" },
    { Reprojection, "reprojection" }, { TracedIrradiance, "tracedTexture" },
    { MeanTracedIrradiance, "meanTexture" }, { PathLight, "pathLight" },
    { PathSurface, "pathSurface" }, { LampLight, "lampLightTexture" }, { Sky, "skyTexture" },
    { Backdrop, "backdropTexture" }, { LitRadiance, "litTexture" }, { LitShown, "shownTexture" },
    { LitEncoded, "encodedTexture" }, { Reflection, "reflectionTexture" },
    { ReflectionReach, "reachTexture" }, { EdgeCoverage, "coverageTexture" },
    { Color, "colorTexture" }, { Radiance, "colorTexture" } };
  const auto found = names.find(resource);
  return found == names.end() ? std::string() : found->second;
}
}

/// A result of few samples with the noise of a frame, to be accumulated over frames, and then filtered. The table below is sorted by
/// name.
struct NoisyResource
{
  const char* Name;
  bool PerLight;   ///< has a channel for each shadowed light
  bool Appearance; ///< depends on the appearance of surfaces, not only on their geometry
  /// Light on surfaces: does not depend on the camera, unless it carries lights. Its first frames after a change are wrong,
  /// as it relies on what takes some frames itself. a of its mean is the number of frames.
  bool Light;
  /// Resource with the reach of the spatial filter, in scene units, for each channel. nullptr: light may be filtered as far as
  /// its surface goes on, and other results are filtered by their own techniques.
  const char* Reach;
  /// Resource with the surfaces, as PathSurface, of a result that is a mean over frames already. nullptr: the frame's own.
  const char* Surface;
  /// Resource with the mean over frames, the filter's guide, where the result has this frame's values because still frames are
  /// averaged. nullptr: none.
  const char* Mean;
};
namespace resource
{
constexpr NoisyResource Noisy[] = { { AmbientVisibility, false, false, false, nullptr, nullptr,
                                      nullptr },
  { DirectVisibility, true, false, false, VisibilityReach, nullptr, nullptr },
  { PathLight, false, true, true, nullptr, PathSurface, nullptr },
  { Reflection, false, true, false, ReflectionReach, nullptr, nullptr },
  { TracedIrradiance, false, true, true, nullptr, nullptr, MeanTracedIrradiance } };
}
}
