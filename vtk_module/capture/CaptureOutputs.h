// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which targets the capture writes in a frame: three always, two more where the scene holds textures
 * or PBR, and those that techniques ask for.
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
  /// One that is written on request: its resource, the name by which snippets know it, its format.
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

  bool Extended = false; ///< textures or PBR
  /// What the third target is. Shaders write the same, whatever it is.
  const char* Third = resource::Ambient;

  void Request(const char* resource) { this->Requested.insert(resource); }
  bool Has(const char* resource) const { return this->Requested.count(resource) > 0; }

  bool operator==(const CaptureOutputs& other) const
  {
    return this->Extended == other.Extended && this->Requested == other.Requested;
  }

  /// Those of the optional ones that were asked for, in the order of their targets.
  std::vector<const Optional*> Chosen() const;

  /// The resources of all targets, in order.
  std::vector<const char*> Resources() const;

  /// For a snippet: what is written.
  Defines SnippetDefines() const;

  /// Name targets by number, as VTK expects them.
  void NumberTargets(std::string& snippet) const;

private:
  std::set<std::string> Requested;
};
}
