// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Names of the resources that passes share. A technique meets the others only through these.
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
constexpr const char* WindowDepth = "gbuffer.depth"; ///< a copy of it, to read meanwhile
constexpr const char* Ambient = "gbuffer.ambient";   ///< ambient light reflected
constexpr const char* Surface = "gbuffer.surface";   ///< see capture/gbuffer.glsl
constexpr const char* Emission = "gbuffer.emission"; ///< radiance not due to light
constexpr const char* Displacement =
  "gbuffer.displacement"; ///< how far a point of a deforming surface was from here, one frame ago
constexpr const char* DirectVisibility = "visibility.direct"; ///< a channel per shadowed light
constexpr const char* Surroundings =
  "gbuffer.surroundings"; ///< the part of Ambient that PBR highlights reflect of the environment
constexpr const char* AmbientVisibility =
  "visibility.ambient";                          ///< r: 0 closed to 1 open; see giOpen() for more
constexpr const char* Irradiance = "irradiance"; ///< see IndirectLight.h
constexpr const char* LampLight = "irradiance.lamps"; ///< see IndirectLight.h
/// A skybox behind everything, where there is one: rgb as its shader ends, unclamped; a: 1 where that is for display.
constexpr const char* Sky = "sky";
constexpr const char* LitRadiance = "radiance.lit"; ///< linear, with direct light; where asked for
constexpr const char* Reflection = "reflection";    ///< radiance over each pixel's lobe, confidence
constexpr const char* Color = "color";              ///< the picture, as displayed
constexpr const char* Radiance = "radiance";        ///< the picture, linear
}

namespace resource
{
/// The name that shaders have for a shared resource, unless their pass says otherwise; "" for none.
inline std::string SamplerOf(const std::string& resource)
{
  static const std::map<std::string, std::string> names = { { Albedo, "albedoTexture" },
    { Normal, "normalTexture" }, { Facet, "facetTexture" }, { WindowDepth, "depthTexture" },
    { Ambient, "ambientTexture" }, { Surface, "surfaceTexture" }, { Emission, "emissionTexture" },
    { Displacement, "displacementTexture" }, { DirectVisibility, "directVisibility" },
    { Surroundings, "surroundingsTexture" }, { AmbientVisibility, "ambientVisibility" },
    { Irradiance, "irradianceTexture" }, { LampLight, "lampLightTexture" }, { Sky, "skyTexture" },
    { LitRadiance, "litTexture" }, { Reflection, "reflectionTexture" },
    { Color, "colorTexture" }, { Radiance, "colorTexture" } };
  const auto found = names.find(resource);
  return found == names.end() ? std::string() : found->second;
}
}

/// Results of few samples that share the noise of a frame, in the order of their names: what
/// accumulates over frames.
struct NoisyResource
{
  const char* Name;
  bool PerLight; ///< a channel for each shadowed light, else of the scene as a whole
  bool Looks;    ///< depends on what surfaces look like, not only on where they are
};
namespace resource
{
constexpr NoisyResource Noisy[] = { { AmbientVisibility, false, false },
  { DirectVisibility, true, false }, { Reflection, false, true } };
}
}
