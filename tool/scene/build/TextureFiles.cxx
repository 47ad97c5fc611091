// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build/TextureFiles.h"

#include "image/Picture.h"
#include "scene/readers/Formats.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace penumbra::tool
{
namespace
{
template <typename Convert>
vtkSmartPointer<vtkImageData> ToImage(
  const Picture& picture, int channels, int type, Convert convert)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(type, channels);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      // VTK's first row is the bottom one.
      const std::size_t source = std::size_t(picture.Height - 1 - y) * picture.Width + x;
      for (int channel = 0; channel < channels; ++channel)
      {
        const float value =
          channel < 3 ? picture.Color(source, channel) : picture.Pixel(source)[channel];
        values->SetComponent(vtkIdType(y) * picture.Width + x, channel, convert(value));
      }
    }
  }
  return image;
}

/// IEC 61966-2-1, the sRGB transfer curve.
double LinearFromSrgb(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

vtkSmartPointer<vtkTexture> MakeTexture(vtkImageData* image)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}
}

vtkSmartPointer<vtkTexture> ReadTexture(const std::string& path, TextureUse use)
{
  RequireReadableFile(path);
  const Picture picture = ReadPicture(path);
  const int channels = picture.Channels == 4 ? 4 : 3;
  auto texture = MakeTexture(ToImage(picture, channels, VTK_UNSIGNED_CHAR,
    [](float value) { return std::round(255 * std::clamp(value, 0.0f, 1.0f)); }));
  texture->SetUseSRGBColorSpace(use == TextureUse::Color);
  texture->RepeatOn();
  return texture;
}

vtkSmartPointer<vtkTexture> MakeWhiteTexture()
{
  Picture white(1, 1, 3);
  std::fill(white.Values.begin(), white.Values.end(), 1.0f);
  auto texture = MakeTexture(ToImage(white, 3, VTK_UNSIGNED_CHAR, [](float v) { return 255 * v; }));
  texture->MipmapOff();
  texture->UseSRGBColorSpaceOn();
  return texture;
}

vtkSmartPointer<vtkTexture> ReadEnvironmentTexture(const std::string& path)
{
  RequireReadableFile(path);
  Picture picture = ReadPicture(path);
  RemoveNonFinite(picture);
  const bool linear = HoldsRadiance(path);
  return MakeTexture(ToImage(picture, 3, VTK_FLOAT,
    [linear](float value) { return linear ? double(value) : LinearFromSrgb(value); }));
}
}
