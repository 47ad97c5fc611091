// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeadlessRenderWindow
 * @brief   offscreen render window through EGL or OSMesa, for VTK builds that only know X
 *
 * Draws with OpenGL 4.3 or later without any window system: on a GPU through EGL's device platform,
 * on the CPU through Mesa's surfaceless EGL or through OSMesa. EGL and OSMesa are opened at run time.
 *
 * It is used like any offscreen vtkRenderWindow. EnableAutomatic(), which runs when the module is
 * loaded, also lets vtkRenderWindow::New() give this class where there is no display.
 *
 * The environment variable PENUMBRA_BACKEND chooses where the program does not: `auto` (EGL first,
 * then OSMesa), `egl`, `osmesa`, or `x11` (never take the place of VTK's own window).
 * PENUMBRA_EGL_DEVICE is the index of the EGL device, counted from 0.
 *
 * Where no context can be made, one error says why and what to do, GetContextError() keeps the text,
 * and rendering is skipped.
 */

#ifndef vtkHeadlessRenderWindow_h
#define vtkHeadlessRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkRenderingGIModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKRENDERINGGI_EXPORT vtkHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the OpenGL context is made.
   */
  enum BackendType
  {
    AUTO = 0,  ///< PENUMBRA_BACKEND if it is set, else EGL, else OSMesa
    EGL = 1,   ///< EGL, on a GPU or Mesa's software driver
    OSMESA = 2 ///< Mesa's OSMesa, on the CPU
  };

  ///@{
  /**
   * Choose how the context is made; AUTO by default. A window that already has a context gives it up
   * and makes another at the next Render().
   */
  virtual void SetBackend(int backend);
  vtkGetMacro(Backend, int);
  void SetBackendToAuto() { this->SetBackend(AUTO); }
  void SetBackendToEGL() { this->SetBackend(EGL); }
  void SetBackendToOSMesa() { this->SetBackend(OSMESA); }
  ///@}

  ///@{
  /**
   * The EGL device, from 0 to GetNumberOfDevices() - 1, which is what EGL lists. With -1, the
   * default, PENUMBRA_EGL_DEVICE or the first hardware device that works, or else a software one.
   */
  void SetDeviceIndex(int index) override;
  int GetNumberOfDevices() override;
  ///@}

  /**
   * The backend in use, "EGL" or "OSMesa"; makes the context if there is none yet. Empty without one.
   */
  const char* GetBackendName();

  /**
   * Backend, renderer and OpenGL version in one line; makes the context if there is none yet. Empty
   * without one.
   */
  const char* GetDescription();

  /**
   * Why there is no context, in one sentence; empty if there is one or none was asked for.
   */
  const char* GetContextError() { return this->ContextError.c_str(); }

  /**
   * Let vtkRenderWindow::New() give this class, and vtkRenderWindowInteractor::New() an interactor
   * that goes with it, where DISPLAY is unset or empty and VTK knows only X windows or would try X first
   * (VTK 9.4 and later, unless VTK_DEFAULT_OPENGL_WINDOW names a window), or where
   * PENUMBRA_BACKEND asks for egl or osmesa. The question is asked again at each New(). Runs
   * when the module is loaded, costs nothing and may be repeated.
   */
  static void EnableAutomatic() { vtkHeadlessRenderWindow::SetAutomatic(true); }

  ///@{
  /**
   * Undo EnableAutomatic(), or ask whether it is in force.
   */
  static void SetAutomatic(bool automatic);
  static bool GetAutomatic();
  ///@}

  ///@{
  /**
   * The life of the context. Render() initialises by itself; Finalize() frees all that was made with
   * the context, then the context, and the next Render() starts afresh.
   */
  void Initialize() override;
  void Finalize() override;
  void OpenGLInit() override;
  void OpenGLInitContext() override;
  ///@}

  ///@{
  /**
   * Which context is current in the calling thread. Push and pop put back what was current before,
   * another library's context included.
   */
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  ///@}

  ///@{
  /**
   * Drawing; each does nothing where no context can be made.
   */
  void Render() override;
  void Start() override;
  void End() override;
  void Frame() override;
  ///@}

  /**
   * There is nothing to show: stays off.
   */
  void SetShowWindow(bool) override {}

  ///@{
  /**
   * What can be asked about the context; these make it if there is none yet. Buffers of no bits keep
   * vtkHardwareSelector, which asks for them first, from drawing without a context.
   */
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;
  const char* ReportCapabilities() override;
  int GetColorBufferSizes(int* rgba) override;
  int GetDepthBufferSize() override;
  ///@}

  ///@{
  /**
   * Handles of the native context and display (an EGLContext and EGLDisplay, or an OSMesaContext).
   */
  void* GetGenericContext() override;
  void* GetGenericDisplayId() override;
  ///@}

  ///@{
  /**
   * A vtkGenericRenderWindowInteractor serves this window. X's interactor would crash without an X
   * window to listen to, so it is refused with an error.
   */
  vtkRenderWindowInteractor* MakeRenderWindowInteractor() override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;
  ///@}

  /**
   * Not supported, always false: this window owns its context. vtkGenericOpenGLRenderWindow adopts
   * one.
   */
  bool InitializeFromCurrentContext() override { return false; }

  using vtkGenericOpenGLRenderWindow::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;

protected:
  vtkHeadlessRenderWindow();
  ~vtkHeadlessRenderWindow() override;

  int ReadPixels(const vtkRecti& rect, int front, int glFormat, int glType, void* data,
    int right) override;

  int Backend = AUTO;

private:
  vtkHeadlessRenderWindow(const vtkHeadlessRenderWindow&) = delete;
  void operator=(const vtkHeadlessRenderWindow&) = delete;

  bool CreateContext();
  bool EnsureContext();
  void ReportContextError(const std::string& text);

  struct Internals;
  std::unique_ptr<Internals> Internal;
  std::string ContextError;
  std::string Description;
};

#endif
