// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A technique's light at points without a G-buffer, as parts of VTK's own shaders.
 */
#pragma once

#include "gpu/ShaderLibrary.h"
#include "rays/SurfaceRules.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkOpenGLState;

namespace penumbra
{
/// One of VTK's programs, as seen by one technique's part of it: uniforms have the names of that part.
class ForwardProgram : public Program
{
public:
  /// field: replaces "field" at the beginning of names, see FieldName().
  ForwardProgram(GLuint program, std::string field, bool volume);

  /// Call before the part's inputs are set. units: texture units for its textures.
  void Begin(vtkOpenGLState* state, const int* units);

  bool IsOfVolume() const { return this->Volume; }

  /// Set those uniforms that the program uses, and bind its blocks.
  void Set(const Arguments& arguments) const;

  /// Bind a texture to the next of the part's units, and set its sampler.
  void SetTexture(const char* uniform, GLuint texture);

  /// Set the uniforms of probes (probes/forward.glsl). origin: of their coordinates, in the world.
  void SetField(const glm::dmat4& viewToWorld, const glm::dvec3& origin, double intensity) const;

  /// Replacement of "field" in names of the part with this number.
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
  std::string Source; ///< shader file that defines the functions of the part; "" for none
  Defines OnSurfaces; ///< variant for translucent surfaces
  Defines InVolumes;  ///< variant for volumes
  int Textures = 0;   ///< number of textures that Bind sets
  /// Sets the part's inputs in a program that is about to draw.
  std::function<void(ForwardProgram& program)> Bind;

  bool IsEmpty() const { return this->Source.empty(); }
  bool HasShadersOf(const ForwardPart& other) const
  {
    return this->Source == other.Source && this->OnSurfaces == other.OnSurfaces &&
      this->InVolumes == other.InVolumes;
  }
};

/// The light of a frame for everything that VTK draws itself.
struct ForwardLight
{
  ForwardPart Visibility; ///< visibility of the lights: giVisibility(), see forward/lights.glsl
  /// Indirect light: fieldIndirect() and others, see forward/indirect.glsl, in order of preference.
  std::vector<ForwardPart> Indirect;
  double DirectScale = 1.0; ///< factor of the lights' strength
  /// Maps finished colours to the display: giDisplayed(), see tone_mapping/forward.glsl.
  ForwardPart Display;
  SurfaceRules Rules;

  /// Take a share of the lights' strength and spread it evenly over all directions, in place of indirect light.
  /// total: sum of the lights' colours.
  void Spread(double share, const glm::dvec3& total);
  bool IsSpread() const { return this->DirectScale < 1.0; }

  bool IsEmpty() const
  {
    return this->Visibility.IsEmpty() && this->Indirect.empty() && this->Display.IsEmpty() &&
      !this->HasRules();
  }
  bool HasRules() const { return !(this->Rules == SurfaceRules()); }
  bool HasShadersOf(const ForwardLight& other) const;
};
}
