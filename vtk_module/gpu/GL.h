// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL through the loader that VTK was built with: GLEW up to VTK 9.3, glad since 9.4. A second
 * loader in the process would have its own function pointers, which nobody initializes.
 */
#pragma once

#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // IWYU pragma: export
#elif __has_include("vtk_glew.h")
#include "vtk_glew.h" // IWYU pragma: export
#else
#error "Neither vtk_glad.h nor vtk_glew.h was found: VTK's RenderingOpenGL2 headers are needed."
#endif
