// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>

namespace penumbra_test
{
double Picture::MeanGrey(int left, int bottom, int right, int top) const
{
  double sum = 0.0;
  for (int y = bottom; y < top; ++y)
  {
    for (int x = left; x < right; ++x)
    {
      sum += this->Grey(x, y);
    }
  }
  return sum / ((right - left) * (top - bottom));
}

Picture Shoot(vtkRenderWindow* window)
{
  window->Render();
  return Read(window);
}

Picture Read(vtkRenderWindow* window)
{
  Picture picture;
  picture.Width = window->GetActualSize()[0];
  picture.Height = window->GetActualSize()[1];
  const int right = picture.Width - 1;
  const int top = picture.Height - 1;
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, right, top, 0, pixels);
  picture.Pixels.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  vtkNew<vtkFloatArray> depth;
  window->GetZbufferData(0, 0, right, top, depth);
  picture.Depth.assign(depth->GetPointer(0), depth->GetPointer(0) + depth->GetNumberOfValues());
  return picture;
}

Difference Compare(const Picture& a, const Picture& b, int tolerance)
{
  Difference result;
  if (a.Width != b.Width || a.Height != b.Height || a.Pixels.empty())
  {
    return result;
  }
  const std::size_t count = a.Pixels.size() / 4;
  std::size_t within = 0;
  std::size_t depthWithin = 0;
  double sum = 0.0;
  result.Max = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    int largest = 0;
    for (std::size_t c = 4 * i; c < 4 * i + 4; ++c)
    {
      const int difference = std::abs(a.Pixels[c] - b.Pixels[c]);
      largest = std::max(largest, difference);
      sum += difference;
    }
    within += largest <= tolerance;
    result.Max = std::max(result.Max, largest);
    depthWithin += a.Depth.size() == b.Depth.size() && std::abs(a.Depth[i] - b.Depth[i]) <= 1e-5f;
  }
  result.Within = static_cast<double>(within) / count;
  result.DepthWithin = static_cast<double>(depthWithin) / count;
  result.Mean = sum / (4.0 * count);
  return result;
}

double Busyness(const Picture& picture)
{
  std::map<std::array<int, 4>, std::size_t> counts;
  std::size_t most = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      most = std::max(most, ++counts[picture.At(x, y)]);
    }
  }
  const auto count = static_cast<double>(picture.Width) * picture.Height;
  return count > 0.0 ? 1.0 - most / count : 0.0;
}

void Save(const Picture& picture, const std::string& name)
{
  const char* folder = std::getenv("PENUMBRA_TEST_OUTPUT");
  if (!folder || picture.Pixels.empty())
  {
    return;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < picture.Pixels.size(); ++i)
  {
    if (i % 4 != 3)
    {
      *out++ = picture.Pixels[i];
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName((std::string(folder) + "/" + name + ".png").c_str());
  writer->SetInputData(image);
  writer->Write();
}

Picture Amplified(const Picture& a, const Picture& b)
{
  Picture result = a;
  for (std::size_t i = 0; i < std::min(a.Pixels.size(), b.Pixels.size()); ++i)
  {
    result.Pixels[i] =
      static_cast<unsigned char>(std::min(255, 16 * std::abs(a.Pixels[i] - b.Pixels[i])));
  }
  return result;
}
}
