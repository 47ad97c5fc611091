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

void ForwardProgram::Set(const Arguments& arguments) const
{
  this->SetValues(arguments);
  if (arguments.Blocks().empty())
  {
    return; // this is called for each draw of a prop
  }
  for (const Input& input : this->Inputs())
  {
    const auto block = arguments.Blocks().find(input.Name);
    if (block != arguments.Blocks().end() && input.Location < 0)
    {
      block->second.Object->BindBase(
        input.Kind == InputKind::StorageBlock ? GL_SHADER_STORAGE_BUFFER : GL_UNIFORM_BUFFER,
        static_cast<GLuint>(input.Unit));
    }
  }
}

std::string ForwardProgram::NameOf(const std::string& name) const
{
  const bool isPrivate =
    name.compare(0, 5, "field") == 0 && std::isupper(static_cast<unsigned char>(name[5])) != 0;
  return isPrivate ? this->Field + name.substr(5) : name;
}

void ForwardProgram::SetTexture(const char* uniform, GLuint texture)
{
  const int unit = *this->NextUnit++;
  this->State->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  this->SetValues(Arguments().Set(uniform, unit));
}

void ForwardProgram::SetField(
  const glm::dmat4& viewToWorld, const glm::dvec3& origin, double intensity) const
{
  this->SetValues(
    Arguments()
      .Set("fieldFromView", glm::mat4(glm::translate(glm::dmat4(1.0), -origin) * viewToWorld))
      .Set("fieldIntensity", intensity));
}

void ForwardLight::Spread(double share, const glm::dvec3& total)
{
  this->DirectScale = 1.0 - share;
  if (this->Visibility.IsEmpty())
  {
    this->Visibility.Source = "forward/unshadowed.glsl";
    this->Visibility.Bind = [](ForwardProgram&) {};
  }
  ForwardPart part;
  part.Source = "forward/spread.glsl";
  part.Bind = [light = glm::vec3(share * total)](
                ForwardProgram& program) { program.Set(Arguments().Set("fieldSpread", light)); };
  this->Indirect = { part };
}

bool ForwardLight::HasShadersOf(const ForwardLight& other) const
{
  return this->Visibility.HasShadersOf(other.Visibility) &&
    this->Display.HasShadersOf(other.Display) && this->HasRules() == other.HasRules() &&
    std::equal(this->Indirect.begin(), this->Indirect.end(), other.Indirect.begin(),
      other.Indirect.end(),
      [](const ForwardPart& a, const ForwardPart& b) { return a.HasShadersOf(b); });
}
}
