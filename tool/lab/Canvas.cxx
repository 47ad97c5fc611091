// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lab/Canvas.h"

#include "common/Failure.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>

namespace penumbra::tool
{
Canvas::Canvas(int width, int height)
  : Sheet(width, height, 3)
{
  std::fill(this->Sheet.Values.begin(), this->Sheet.Values.end(), 1.0f);
}

void Canvas::Place(const Picture& picture, int x, int y, int enlarged)
{
  const int right = std::min(x + picture.Width * enlarged, this->Sheet.Width);
  const int bottom = std::min(y + picture.Height * enlarged, this->Sheet.Height);
  for (int v = std::max(y, 0); v < bottom; ++v)
  {
    for (int u = std::max(x, 0); u < right; ++u)
    {
      const std::size_t from = std::size_t((v - y) / enlarged) * picture.Width + (u - x) / enlarged;
      float* pixel = this->Sheet.Pixel(std::size_t(v) * this->Sheet.Width + u);
      for (int channel = 0; channel < 3; ++channel)
      {
        pixel[channel] = picture.Color(from, channel);
      }
    }
  }
}

void Canvas::Fill(int x, int y, int width, int height, const Color& color)
{
  for (int v = std::max(y, 0); v < std::min(y + height, this->Sheet.Height); ++v)
  {
    for (int u = std::max(x, 0); u < std::min(x + width, this->Sheet.Width); ++u)
    {
      std::copy(
        color.begin(), color.end(), this->Sheet.Pixel(std::size_t(v) * this->Sheet.Width + u));
    }
  }
}

void Canvas::Frame(int x, int y, int width, int height, int thickness, const Color& color)
{
  const int t = thickness;
  this->Fill(x - t, y - t, width + 2 * t, t, color);
  this->Fill(x - t, y + height, width + 2 * t, t, color);
  this->Fill(x - t, y, t, height, color);
  this->Fill(x + width, y, t, height, color);
}

void Canvas::Write(const std::string& text, int x, int y, int size, const Color& color)
{
  constexpr int dotsPerInch = 72; // a point is a pixel
  vtkNew<vtkTextProperty> look;
  look->SetFontFamilyToArial();
  look->SetFontSize(size);
  look->SetColor(color[0], color[1], color[2]);
  vtkNew<vtkImageData> image;
  int used[2];
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (!renderer || !renderer->RenderString(look, text, image, used, dotsPerInch))
  {
    Fail("VTK cannot draw the text '{}'", text);
  }
  // The image is as large as a power of two, its first row at the bottom; the text starts there.
  const int* extent = image->GetExtent();
  for (int v = 0; v < used[1]; ++v)
  {
    for (int u = 0; u < used[0]; ++u)
    {
      const int left = x + u, top = y + used[1] - 1 - v;
      if (left < 0 || left >= this->Sheet.Width || top < 0 || top >= this->Sheet.Height)
      {
        continue;
      }
      const auto* ink =
        static_cast<unsigned char*>(image->GetScalarPointer(extent[0] + u, extent[2] + v, 0));
      float* pixel = this->Sheet.Pixel(std::size_t(top) * this->Sheet.Width + left);
      for (int channel = 0; channel < 3; ++channel)
      {
        const float cover = ink[3] / 255.0f;
        pixel[channel] += cover * (ink[channel] / 255.0f - pixel[channel]);
      }
    }
  }
}
}
