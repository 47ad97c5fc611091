// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Textures from picture files.
#pragma once

#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <string>

namespace penumbra::tool
{
enum class TextureUse
{
  Color, ///< display colours, made linear by PBR shading
  Data   ///< values used unchanged
};

/// An 8-bit texture of a picture file.
vtkSmartPointer<vtkTexture> ReadTexture(const std::string& path, TextureUse use);

/// One white pixel.
vtkSmartPointer<vtkTexture> MakeWhiteTexture();

/// A float texture of linear radiance in latitude-longitude format. 8-bit files are made linear.
vtkSmartPointer<vtkTexture> ReadEnvironmentTexture(const std::string& path);
}
