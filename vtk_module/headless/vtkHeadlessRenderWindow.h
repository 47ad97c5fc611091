// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeadlessRenderWindow
 * @brief   offscreen render window through EGL or OSMesa, for VTK builds that only know X
 *
 * Draws with OpenGL 4.3 or later without any window system: on a GPU through EGL's device platform,
 * on the CPU through Mesa's surfaceless EGL or through OSMesa. EGL and OSMesa are loaded at run time.
 *
 * It is used like any offscreen vtkRenderWindow. EnableAutomatic(), which runs when the module is
 * loaded, also lets vtkRenderWindow::New() return this class if there is no display.
 *
 * The environment variable PENUMBRA_BACKEND selects the backend if the program does not: `auto` (EGL first,
 * then OSMesa), `egl`, `osmesa`, or `x11` (never replace VTK's own window).
 * PENUMBRA_EGL_DEVICE is the index of the EGL device, counted from 0.
 *
 * If no context can be created, a single error gives the reason and the remedy, GetContextError() returns its text,
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
   * Backend of the OpenGL context.
   */
  enum BackendType
  {
    AUTO = 0,  ///< PENUMBRA_BACKEND if it is set, else EGL, else OSMesa
    EGL = 1,   ///< EGL, on a GPU or Mesa's software driver
    OSMESA = 2 ///< Mesa's OSMesa, on the CPU
  };

  ///@{
  /**
   * Set the backend of the context; AUTO by default. A window that already has a context releases it
   * and creates another at the next Render().
   */
  virtual void SetBackend(int backend);
  vtkGetMacro(Backend, int);
  void SetBackendToAuto() { this->SetBackend(AUTO); }
  void SetBackendToEGL() { this->SetBackend(EGL); }
  void SetBackendToOSMesa() { this->SetBackend(OSMESA); }
  ///@}

  ///@{
  /**
   * Set the index of the EGL device, from 0 to GetNumberOfDevices() - 1, in EGL's order. With -1, the
   * default, PENUMBRA_EGL_DEVICE applies, else the first hardware device that works, else a software device.
   */
  void SetDeviceIndex(int index) override;
  int GetNumberOfDevices() override;
  ///@}

  /**
   * Get the backend in use, "EGL" or "OSMesa". Creates the context if there is none yet. Empty if that fails.
   */
  const char* GetBackendName();

  /**
   * Get backend, renderer and OpenGL version in one line. Creates the context if there is none yet. Empty
   * if that fails.
   */
  const char* GetDescription();

  /**
   * Get the reason why there is no context, in one sentence; empty if there is one or none was requested.
   */
  const char* GetContextError() { return this->ContextError.c_str(); }

  /**
   * Let vtkRenderWindow::New() return this class, and vtkRenderWindowInteractor::New() a matching
   * interactor, if DISPLAY is unset or empty and VTK knows only X windows or would try X first
   * (VTK 9.4 and later, unless VTK_DEFAULT_OPENGL_WINDOW names a window), or if
   * PENUMBRA_BACKEND is egl or osmesa. This is decided at each New(). EnableAutomatic() runs
   * when the module is loaded, costs nothing and may be repeated.
   */
  static void EnableAutomatic() { vtkHeadlessRenderWindow::SetAutomatic(true); }

  ///@{
  /**
   * Set or get whether EnableAutomatic() is in effect.
   */
  static void SetAutomatic(bool automatic);
  static bool GetAutomatic();
  ///@}

  ///@{
  /**
   * Create and free the context. Render() initialises it by itself. Finalize() frees all objects of
   * the context, then the context; the next Render() creates a new one.
   */
  void Initialize() override;
  void Finalize() override;
  void OpenGLInit() override;
  void OpenGLInitContext() override;
  ///@}

  ///@{
  /**
   * Control the current context of the calling thread. Push and pop restore the context that was current before,
   * including that of another library.
   */
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  ///@}

  ///@{
  /**
   * Draw. These do nothing if no context can be created.
   */
  void Render() override;
  void Start() override;
  void End() override;
  void Frame() override;
  ///@}

  /**
   * Does nothing, as there is no window to show.
   */
  void SetShowWindow(bool) override {}

  ///@{
  /**
   * Query the context. These create it if there is none yet. Without a context, buffer sizes of zero prevent
   * vtkHardwareSelector, which queries them first, from drawing.
   */
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override;
  const char* ReportCapabilities() override;
  int GetColorBufferSizes(int* rgba) override;
  int GetDepthBufferSize() override;
  ///@}

  ///@{
  /**
   * Get the native context and display (an EGLContext and EGLDisplay, or an OSMesaContext).
   */
  void* GetGenericContext() override;
  void* GetGenericDisplayId() override;
  ///@}

  ///@{
  /**
   * Create or set the interactor, a vtkGenericRenderWindowInteractor. X's interactor would crash without an X
   * window, so it is rejected with an error.
   */
  vtkRenderWindowInteractor* MakeRenderWindowInteractor() override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;
  ///@}

  /**
   * Not supported, always returns false, as this window owns its context. Use vtkGenericOpenGLRenderWindow to adopt
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
