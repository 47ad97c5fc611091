// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Targets that the capture writes in a frame: two always, one more if a surface may have an ambient term, two more if
 * the scene has textures or PBR, and those that techniques request.
 */
#pragma once

#include "gpu/GL.h"
#include "gpu/ShaderLibrary.h"
#include "graph/Resources.h"

#include <array>
#include <set>

namespace penumbra
{
class CaptureOutputs
{
public:
  /// A target that is written on request: its resource, its macro in snippets, its format.
  struct Optional
  {
    const char* Resource;
    const char* Name;
    GLenum Format;
  };
  static constexpr std::array<Optional, 3> All = { {
    { resource::Surroundings, "GI_SURROUNDINGS", GL_RGBA16F },
    { resource::Displacement, "GI_DISPLACEMENT", GL_RGBA32F },
    { resource::Facet, "GI_FACET", GL_RGBA16 },
  } };

  bool Extended = false; ///< whether there are textures or PBR
  /// Whether the third target is kept. Shaders write the same values in any case.
  bool Ambient = true;

  void Request(const char* resource) { this->Requested.insert(resource); }
  bool Has(const char* resource) const { return this->Requested.count(resource) > 0; }

  bool operator==(const CaptureOutputs& other) const
  {
    return this->Extended == other.Extended && this->Requested == other.Requested;
  }

  /// The requested optional targets, in order.
  std::vector<const Optional*> RequestedTargets() const;

  /// The resources of all targets, in order; nullptr for one that is not kept.
  std::vector<const char*> Resources() const;

  /// Macros of a snippet for the targets that are written.
  Defines SnippetDefines() const;

  /// Replace the names of targets in a snippet by numbers, as VTK expects them.
  void NumberTargets(std::string& snippet) const;

private:
  std::set<std::string> Requested;
};
}
