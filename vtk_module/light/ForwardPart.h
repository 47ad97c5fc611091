// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a technique knows of light at points that are in no G-buffer.
 */
#pragma once

#include "gpu/ShaderLibrary.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkOpenGLState;

namespace penumbra
{
/// A program of VTK's that is in use, as the part of one technique in it sees it: the part's uniforms go by
/// the names that the technique gave them.
class ForwardProgram : public Program
{
public:
  /// field: what "field" at the beginning of a name became, as in FieldName().
  ForwardProgram(GLuint program, std::string field, bool volume);

  /// Before the part's uniforms are set. units: for its textures.
  void Begin(vtkOpenGLState* state, const int* units);

  bool IsOfVolume() const { return this->Volume; }

  /// Set the uniforms that the program uses, and bind its blocks.
  void Set(const Arguments& arguments) const;

  /// Have a uniform read a texture, by the next of the part's units.
  void SetTexture(const char* uniform, GLuint texture);

  /// For the parts of probes (probes/forward.glsl): their coordinates are those of the world, from an origin on.
  void SetField(const glm::dmat4& viewToWorld, const glm::dvec3& origin, double intensity) const;

  /// What "field" becomes in the part of that number.
  static std::string FieldName(std::size_t number) { return "giField" + std::to_string(number); }

protected:
  std::string NameOf(const std::string& uniform) const override;

private:
  std::string Field;
  vtkOpenGLState* State = nullptr;
  const int* NextUnit = nullptr;
  bool Volume;
};

/// A technique's part of the shaders of what VTK draws itself.
struct ForwardPart
{
  std::string Source; ///< a shader part with functions that its user names; "" for none
  Defines OnSurfaces; ///< its variant for translucent surfaces
  Defines InVolumes;
  int Textures = 0; ///< that Bind sets
  /// Set what the part needs in a program that is about to draw.
  std::function<void(ForwardProgram& program)> Bind;

  bool IsEmpty() const { return this->Source.empty(); }
  bool HasShadersOf(const ForwardPart& other) const
  {
    return this->Source == other.Source && this->OnSurfaces == other.OnSurfaces &&
      this->InVolumes == other.InVolumes;
  }
};

/// What lights that which VTK draws itself in a frame.
struct ForwardLight
{
  ForwardPart Visibility; ///< what of the lamps arrives: giVisibility(), see forward/lights.glsl
  /// Indirect light: fieldIndirect() and others, see forward/indirect.glsl, in the order in which they count.
  std::vector<ForwardPart> Indirect;
  double Kept = 1.0; ///< of the lamps' strength

  /// Take a share of the lamps' strength and spread it evenly over all directions, instead of indirect light.
  /// total: the lamps' colours added up.
  void Spread(double share, const glm::dvec3& total);
  bool IsSpread() const { return this->Kept < 1.0; }

  bool IsEmpty() const { return this->Visibility.IsEmpty() && this->Indirect.empty(); }
  bool HasShadersOf(const ForwardLight& other) const;
};
}
