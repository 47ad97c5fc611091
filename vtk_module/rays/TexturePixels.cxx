// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/TexturePixels.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <cmath>

namespace penumbra
{
namespace
{
float Linear(float value)
{
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

vtkImageData* Input(vtkTexture* texture, int face)
{
  if (texture->GetNumberOfInputPorts() <= face || texture->GetNumberOfInputConnections(face) == 0)
  {
    return nullptr;
  }
  texture->GetInputAlgorithm(face, 0)->UpdateWholeExtent();
  return vtkImageData::SafeDownCast(texture->GetInputDataObject(face, 0));
}

std::uint32_t Pack(const unsigned char* color, int components)
{
  const std::uint32_t alpha = components > 3 ? color[3] : 255u;
  return color[0] | color[1] << 8 | color[2] << 16 | alpha << 24;
}

// Whether the texture keeps the numbers of an image with more than eight bits per component.
bool IsDirect(vtkTexture* texture, vtkDataArray* scalars)
{
  const int type = scalars->GetDataType();
  return texture->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS &&
    scalars->GetNumberOfComponents() >= 3 && (type == VTK_FLOAT || type == VTK_UNSIGNED_SHORT);
}
}

glm::vec4 TexturePixels::At(int x, int y) const
{
  const std::size_t i = static_cast<std::size_t>(y) * this->Width + x;
  glm::vec4 value = this->Floats.empty() ? glm::unpackUnorm4x8(this->Bytes[i]) : this->Floats[i];
  for (int channel = 0; channel < 3 && this->Srgb; ++channel)
  {
    value[channel] = Linear(value[channel]);
  }
  return value;
}

TexturePixels ReadTexturePixels(vtkTexture* texture, int face)
{
  TexturePixels pixels;
  vtkImageData* image = Input(texture, face);
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  const bool ofCells = image && !scalars;
  scalars = ofCells ? image->GetCellData()->GetScalars() : scalars;
  if (!scalars)
  {
    return pixels;
  }
  // An image can lie in any coordinate plane.
  int size[3];
  image->GetDimensions(size);
  for (int& length : size)
  {
    length -= ofCells && length > 1 ? 1 : 0;
  }
  const int width = size[0] == 1 ? size[1] : size[0];
  const int height = size[0] == 1 || size[1] == 1 ? size[2] : size[1];
  const vtkIdType count = static_cast<vtkIdType>(width) * height;
  if (count == 0 || scalars->GetNumberOfTuples() < count)
  {
    return pixels;
  }
  const int components = scalars->GetNumberOfComponents();
  const int mode = texture->GetColorMode();
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(scalars);
  const bool mapped = mode == VTK_COLOR_MODE_MAP_SCALARS || components < 3;
  const bool direct = IsDirect(texture, scalars);
  if (direct)
  {
    const float scale = scalars->GetDataType() == VTK_FLOAT ? 1.0f : 1.0f / 65535.0f;
    pixels.Floats.resize(static_cast<std::size_t>(count), glm::vec4(1.0f));
    for (vtkIdType i = 0; i < count; ++i)
    {
      for (int channel = 0; channel < std::min(4, components); ++channel)
      {
        pixels.Floats[static_cast<std::size_t>(i)][channel] =
          scale * static_cast<float>(scalars->GetComponent(i, channel));
      }
    }
  }
  else
  {
    const bool plain = bytes && !mapped;
    const unsigned char* colors =
      plain ? bytes->GetPointer(0) : texture->MapScalarsToColors(scalars);
    const int stride = plain ? components : 4;
    pixels.Bytes.resize(colors ? static_cast<std::size_t>(count) : 0);
    for (std::size_t i = 0; i < pixels.Bytes.size(); ++i)
    {
      pixels.Bytes[i] = Pack(colors + i * static_cast<std::size_t>(stride), stride);
    }
  }
  const bool read = !pixels.Floats.empty() || !pixels.Bytes.empty();
  pixels.Width = read ? width : 0;
  pixels.Height = read ? height : 0;
  pixels.Mapped = !direct && !(bytes && !mapped);
  pixels.EightBits = scalars->GetDataTypeSize() == 1;
  pixels.Srgb = texture->GetUseSRGBColorSpace() && pixels.Floats.empty();
  return pixels;
}

bool HoldsDisplayValues(vtkTexture* texture)
{
  vtkImageData* image = Input(texture, 0);
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  return scalars && !IsDirect(texture, scalars) && !texture->GetUseSRGBColorSpace();
}

TexturePixels ReadPlainPixels(vtkTexture* texture)
{
  TexturePixels pixels;
  vtkImageData* image = Input(texture, 0);
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfComponents() < 3)
  {
    return pixels;
  }
  const int type = scalars->GetDataType();
  const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
  const double maximum = real ? 1.0 : scalars->GetDataTypeMax();
  int size[3];
  image->GetDimensions(size);
  pixels.Width = size[0];
  pixels.Height = size[1];
  pixels.EightBits = scalars->GetDataTypeSize() == 1;
  pixels.Floats.resize(static_cast<std::size_t>(size[0]) * size[1], glm::vec4(1.0f));
  for (std::size_t i = 0; i < pixels.Floats.size(); ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      pixels.Floats[i][channel] =
        static_cast<float>(scalars->GetComponent(static_cast<vtkIdType>(i), channel) / maximum);
    }
  }
  return pixels;
}

vtkMTimeType TextureTime(vtkTexture* texture)
{
  vtkMTimeType time = texture->GetMTime();
  for (int face = 0; face < texture->GetNumberOfInputPorts(); ++face)
  {
    if (vtkImageData* image = Input(texture, face))
    {
      time = std::max(time, image->GetMTime());
    }
  }
  if (vtkScalarsToColors* table = texture->GetLookupTable())
  {
    time = std::max(time, table->GetMTime());
  }
  return time;
}
}
