// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause

#include "headless/HeadlessChoice.h"

#include "headless/EGLContext.h"
#include "headless/OSMesaContext.h"

#include <cstdlib>

namespace penumbra
{
const char* ReadVariable(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

BackendWish ReadBackendWish()
{
  const std::string value = ReadVariable("PENUMBRA_BACKEND");
  if (value.empty() || value == "auto")
  {
    return BackendWish::None;
  }
  return value == "egl" ? BackendWish::EGL
    : value == "osmesa" ? BackendWish::OSMesa
    : value == "x11"    ? BackendWish::X11
                        : BackendWish::Unknown;
}

std::string DescribeUnknownBackend()
{
  return std::string("PENUMBRA_BACKEND is '") + ReadVariable("PENUMBRA_BACKEND") +
    "': set it to auto, egl, osmesa or x11, or unset it.";
}

std::shared_ptr<HeadlessContext> ChooseContext(BackendWish wish, int device, std::string& error)
{
  if (wish == BackendWish::None)
  {
    wish = ReadBackendWish();
    if (wish == BackendWish::Unknown)
    {
      error = DescribeUnknownBackend();
      return nullptr;
    }
  }

  const char* variable = ReadVariable("PENUMBRA_EGL_DEVICE");
  if (device < 0 && *variable && wish != BackendWish::OSMesa)
  {
    char* end = nullptr;
    const long index = std::strtol(variable, &end, 10);
    if (*end != '\0' || index < 0 || index > 1000)
    {
      error = std::string("PENUMBRA_EGL_DEVICE is '") + variable +
        "': set it to the index of an EGL device, counted from 0, or unset it.";
      return nullptr;
    }
    device = static_cast<int>(index);
  }

  ContextError egl;
  if (wish != BackendWish::OSMesa)
  {
    if (auto context = CreateEGLContext(device, egl))
    {
      return context;
    }
    // A requested device must not be replaced by another one.
    if (wish == BackendWish::EGL || device >= 0)
    {
      error = "No OpenGL context through EGL: " + egl.Cause + "; " + egl.Remedy + ".";
      return nullptr;
    }
  }
  ContextError osmesa;
  if (auto context = CreateOSMesaContext(osmesa))
  {
    return context;
  }
  error = wish == BackendWish::OSMesa
    ? "No OpenGL context through OSMesa: " + osmesa.Cause + "; " + osmesa.Remedy + "."
    : "No OpenGL context without a display: " + egl.Cause + ", and " + osmesa.Cause + "; " +
      egl.Remedy + ", or " + osmesa.Remedy + ".";
  return nullptr;
}
}
