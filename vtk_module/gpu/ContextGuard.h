// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Frees GPU objects in the context that made them: when their owner is done with them, or when their window
 * gives its context up, whichever comes first. Whatever context is current before is current afterwards.
 *
 * VTK keeps a list of what to free in each window. VTK before 9.6 does not install the class that joins it, so
 * this derives from one that joins by itself.
 */
#pragma once

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <functional>

class vtkGIContextGuard : public vtkTextureObject
{
public:
  static vtkGIContextGuard* New();
  vtkTypeMacro(vtkGIContextGuard, vtkTextureObject);

  /// What frees all objects of the context, which is current then.
  void SetFree(std::function<void()> free) { this->Free = std::move(free); }

  /// Objects are made in this window's context from now on, which becomes current. Those of another one are freed.
  void Enter(vtkOpenGLRenderWindow* window);

  /// Free them now.
  void Leave();

  /// The window whose context has objects; nullptr for none.
  vtkOpenGLRenderWindow* Window() const { return this->Guarded; }

  /// VTK calls this, with the context current.
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGIContextGuard() = default;
  ~vtkGIContextGuard() override;

private:
  vtkGIContextGuard(const vtkGIContextGuard&) = delete;
  void operator=(const vtkGIContextGuard&) = delete;

  std::function<void()> Free;
  vtkOpenGLRenderWindow* Guarded = nullptr; ///< it calls ReleaseGraphicsResources() before it goes
};
