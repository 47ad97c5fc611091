// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Frees GPU objects in the context that created them, when their owner no longer needs them or when their window
 * releases its context, whichever comes first. The context that was current before is current afterwards.
 *
 * Each VTK window has a list of resources to free. VTK before 9.6 does not install the header of the class that joins
 * the list, so this derives from a class that joins it by itself.
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

  /// Set the function that frees all objects of the context. It is called with the context current.
  void SetFree(std::function<void()> free) { this->FreeObjects = std::move(free); }

  /// Make a window's context current; objects are created in it from now on. Frees the objects of another context.
  void Enter(vtkOpenGLRenderWindow* window);

  /// Free the objects now.
  void Leave();

  /// The window whose context has objects; nullptr for none.
  vtkOpenGLRenderWindow* Window() const { return this->GuardedWindow; }

  /// VTK calls this, with the context current.
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGIContextGuard() = default;
  ~vtkGIContextGuard() override;

private:
  vtkGIContextGuard(const vtkGIContextGuard&) = delete;
  void operator=(const vtkGIContextGuard&) = delete;

  std::function<void()> FreeObjects;
  /// Calls ReleaseGraphicsResources() before it is deleted.
  vtkOpenGLRenderWindow* GuardedWindow = nullptr;
};
