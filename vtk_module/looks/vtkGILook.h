// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGILook
 * @brief   a named set-up of lights, sky, background and techniques
 *
 * A look replaces a renderer's light by one that shows data well, without a change to the scene:
 * @code
 * vtkNew<vtkGILook> look;
 * if (look->Load("studio"))
 * {
 *   look->ApplyTo(renderer, pass);
 * }
 * // later
 * vtkGILook::RemoveFrom(renderer); // everything is as it was before
 * @endcode
 *
 * A look changes only what its file names: with lights, the renderer's own lights are switched off; a sky replaces the
 * environment, and a background the renderer's; techniques of the pass are switched and get parameters on top of its
 * preset. The camera and the props are never touched. "as-is" is the look that changes nothing.
 *
 * A look is a small JSON file, whose format is described in docs/looks.md. Several come with Penumbra. The environment
 * variable PENUMBRA_LOOK_PATH names a folder with further ones, which come before those of the same name.
 *
 * @sa vtkGIPass
 */
#ifndef vtkGILook_h
#define vtkGILook_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

#include <memory> // for the implementation

class vtkGIPass;
class vtkRenderer;

class VTKRENDERINGGI_EXPORT vtkGILook : public vtkObject
{
public:
  static vtkGILook* New();
  vtkTypeMacro(vtkGILook, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The names of all looks, "as-is" first. The number is determined again at each call, as the user's folder may change.
   */
  static int GetNumberOfLooks();
  static const char* GetLookName(int index);
  ///@}

  /**
   * Read a look, given by its name or by the path of a file that ends with .json. Returns false if there is no such look
   * or if its file has a mistake; GetLastError() then tells which, and the former look is kept.
   */
  bool Load(const char* nameOrPath);

  ///@{
  /**
   * The name or path given to Load(), a title, and what the look is for, in one sentence. Before Load(), the look is "as-is".
   */
  const char* GetName();
  const char* GetTitle();
  const char* GetDescription();
  ///@}

  /**
   * Give the look to a renderer, and its settings to the techniques of the renderer's pass. The renderer's former look is
   * removed first. The pass may be nullptr to change lights and background only; it may serve several renderers, which
   * then share the settings of the last look.
   *
   * Lights that follow the camera do so even if the renderer's own did not. Those that are fixed to the world are placed
   * in the renderer's next frame, with the axis nearest to the camera's view-up as the vertical (unless the look names
   * one), and stay there. Lights that are added later stay on.
   */
  void ApplyTo(vtkRenderer* renderer, vtkGIPass* pass);

  /**
   * Remove the look of a renderer: lights, creation of lights, background and the techniques' settings are as they were
   * before ApplyTo(). Does nothing if there is none. What was changed in the meantime of what the look sets is lost.
   */
  static void RemoveFrom(vtkRenderer* renderer);

  /**
   * Show the sky and the background of a renderer's look again, after the program set its own. Those return with
   * RemoveFrom(). Does nothing if there is no look.
   */
  static void Restore(vtkRenderer* renderer);

  /**
   * The name or path of a renderer's look; "as-is" if it has none.
   */
  static const char* GetAppliedName(vtkRenderer* renderer);

  /**
   * Why Load() failed, in one sentence, or "" if it did not.
   */
  const char* GetLastError();

protected:
  vtkGILook();
  ~vtkGILook() override;

private:
  vtkGILook(const vtkGILook&) = delete;
  void operator=(const vtkGILook&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
