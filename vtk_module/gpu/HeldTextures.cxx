// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gpu/HeldTextures.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>

namespace penumbra
{
namespace
{
struct Kind
{
  GLenum Target;
  GLenum Query;
};

// All kinds of textures that VTK's classes or ours bind.
constexpr Kind Kinds[] = { { GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D },
  { GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP },
  { GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY },
  { GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER }, { GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D },
  { GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE } };

// Whether there is a texture of this name that can be bound to the target. A recorded texture may have been deleted, and
// its name given to another kind of texture.
bool CanBind(GLenum target, GLuint name)
{
  if (!glIsTexture(name))
  {
    return false;
  }
  if (!glGetTextureParameteriv) // before OpenGL 4.5
  {
    return true;
  }
  // Textures of buffers have no parameters but this one.
  GLint buffer = 0;
  glGetTextureLevelParameteriv(name, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
  if (buffer != 0 || target == GL_TEXTURE_BUFFER)
  {
    return buffer != 0 && target == GL_TEXTURE_BUFFER;
  }
  GLint actual = 0;
  glGetTextureParameteriv(name, GL_TEXTURE_TARGET, &actual);
  return static_cast<GLenum>(actual) == target;
}
}

void HeldTextures::Record(vtkOpenGLRenderWindow* window)
{
  this->Bindings.clear();
  vtkOpenGLState* state = window->GetState();
  vtkTextureUnitManager* units = window->GetTextureUnitManager();
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (int unit = 0; unit < units->GetNumberOfTextureUnits(); ++unit)
  {
    if (!units->IsAllocated(unit))
    {
      continue;
    }
    const GLenum name = GL_TEXTURE0 + static_cast<GLenum>(unit);
    state->vtkglActiveTexture(name);
    for (const Kind& kind : Kinds)
    {
      GLint bound = 0;
      glGetIntegerv(kind.Query, &bound);
      if (bound != 0)
      {
        this->Bindings.push_back({ name, kind.Target, static_cast<GLuint>(bound) });
      }
    }
  }
  state->vtkglActiveTexture(static_cast<GLenum>(active));
}

void HeldTextures::Restore(vtkOpenGLState* state) const
{
  for (const Binding& binding : this->Bindings)
  {
    if (CanBind(binding.Target, binding.Name))
    {
      state->vtkglActiveTexture(binding.Unit);
      glBindTexture(binding.Target, binding.Name);
    }
  }
}

void HeldTextures::UnbindOthers(vtkOpenGLRenderWindow* window) const
{
  vtkOpenGLState* state = window->GetState();
  vtkTextureUnitManager* units = window->GetTextureUnitManager();
  for (int unit = 0; unit < units->GetNumberOfTextureUnits(); ++unit)
  {
    const GLenum name = GL_TEXTURE0 + static_cast<GLenum>(unit);
    const bool held = std::any_of(this->Bindings.begin(), this->Bindings.end(),
      [name](const Binding& binding) { return binding.Unit == name; });
    if (units->IsAllocated(unit) && !held)
    {
      continue; // VTK allocated the unit during this frame
    }
    state->vtkglActiveTexture(name);
    for (const Kind& kind : Kinds)
    {
      glBindTexture(kind.Target, 0);
    }
  }
  this->Restore(state);
  state->vtkglActiveTexture(GL_TEXTURE0);
}
}
