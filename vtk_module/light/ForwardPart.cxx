// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/ForwardPart.h"

#include "vtkOpenGLState.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cctype>

namespace penumbra
{
ForwardProgram::ForwardProgram(GLuint program, std::string field, bool volume)
  : Program(program, false)
  , Field(std::move(field))
  , Volume(volume)
{
}

void ForwardProgram::Begin(vtkOpenGLState* state, const int* units)
{
  this->State = state;
  this->NextUnit = units;
}

std::string ForwardProgram::NameOf(const char* uniform) const
{
  const std::string name = uniform;
  const bool own =
    name.compare(0, 5, "field") == 0 && std::isupper(static_cast<unsigned char>(name[5])) != 0;
  return own ? this->Field + name.substr(5) : name;
}

void ForwardProgram::SetTexture(const char* uniform, GLuint texture)
{
  const int unit = *this->NextUnit++;
  this->State->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  glUniform1i(this->Location(uniform), unit);
}

void ForwardProgram::SetField(
  const glm::dmat4& viewToWorld, const glm::dvec3& origin, double intensity) const
{
  const glm::mat4 fromView(glm::translate(glm::dmat4(1.0), -origin) * viewToWorld);
  glUniformMatrix4fv(this->Location("fieldFromView"), 1, GL_FALSE, &fromView[0][0]);
  glUniform1f(this->Location("fieldIntensity"), static_cast<GLfloat>(intensity));
}

void ForwardLight::Spread(double share, const glm::dvec3& total)
{
  this->Kept = 1.0 - share;
  if (this->Visibility.IsEmpty())
  {
    this->Visibility.Source = "forward/unshadowed.glsl";
    this->Visibility.Bind = [](ForwardProgram&) {};
  }
  ForwardPart part;
  part.Source = "forward/spread.glsl";
  part.Bind = [light = glm::vec3(share * total)](ForwardProgram& program) {
    glUniform3fv(program.Location("fieldSpread"), 1, &light[0]);
  };
  this->Indirect = { part };
}

bool ForwardLight::HasShadersOf(const ForwardLight& other) const
{
  return this->Visibility.HasShadersOf(other.Visibility) &&
    std::equal(this->Indirect.begin(), this->Indirect.end(), other.Indirect.begin(),
      other.Indirect.end(),
      [](const ForwardPart& a, const ForwardPart& b) { return a.HasShadersOf(b); });
}
}
