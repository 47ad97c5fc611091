// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image/Capture.h"

#include "base/ScopeExit.h"
#include "common/Failure.h"

#include <vtkDataArray.h>
#include <vtkGIPass.h>
#include <vtkGIPathTracing.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace penumbra::tool
{
namespace
{
/// A picture with an image's values. VTK's first row is the bottom one.
template <typename Convert>
Picture FromImage(vtkImageData* image, int channels, Convert convert)
{
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  Picture picture(size[0], size[1], channels);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      float* pixel = picture.Pixel(std::size_t(size[1] - 1 - y) * size[0] + x);
      for (int channel = 0; channel < channels; ++channel)
      {
        pixel[channel] =
          static_cast<float>(convert(values->GetComponent(vtkIdType(y) * size[0] + x, channel)));
      }
    }
  }
  return picture;
}

/// Visible props that the opaque radiance does not contain.
std::vector<vtkProp*> FindOverlays(vtkRenderer* renderer)
{
  std::vector<vtkProp*> overlays;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cursor;
  props->InitTraversal(cursor);
  while (vtkProp* prop = props->GetNextProp(cursor))
  {
    if (prop->GetVisibility() &&
      (prop->HasTranslucentPolygonalGeometry() || prop->IsA("vtkVolume") ||
        prop->IsA("vtkActor2D")))
    {
      overlays.push_back(prop);
    }
  }
  return overlays;
}

void SetVisible(const std::vector<vtkProp*>& props, bool visible)
{
  for (vtkProp* prop : props)
  {
    prop->SetVisibility(visible);
  }
}

/// Standard error of a pixel's luminance, from the sums that the path tracer keeps.
float StandardError(const float* shown, const float* encoded, float samples)
{
  const double sum = Luminance(shown[0] + encoded[0], shown[1] + encoded[1], shown[2] + encoded[2]);
  const double mean = sum / samples;
  const double variance = std::max(0.0, encoded[3] / samples - mean * mean);
  return samples > 1.0f ? static_cast<float>(std::sqrt(variance / (samples - 1.0))) : 0.0f;
}
}

Picture CaptureWindow(vtkRenderWindow* window, bool alpha)
{
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  alpha ? capture->SetInputBufferTypeToRGBA() : capture->SetInputBufferTypeToRGB();
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  capture->Update();
  return FromImage(capture->GetOutput(), alpha ? 4 : 3, [](double value) { return value / 255; });
}

Picture CaptureRadiance(
  vtkGIPass* pass, vtkRenderer* renderer, bool alpha, const std::function<void()>& redraw)
{
  vtkNew<vtkImageData> image;
  if (!pass->GetRadiance(renderer, image))
  {
    Fail("the pass kept no radiance of the last frame, so no linear picture can be written");
  }
  Picture radiance = FromImage(image, alpha ? 4 : 3, [](double value) { return value; });
  // Path tracing includes translucent props, and would start again without them.
  vtkGITechnique* tracer = pass->GetTechnique("path-tracing");
  if (tracer && tracer->GetEnabled())
  {
    return radiance;
  }
  const std::vector<vtkProp*> overlays = FindOverlays(renderer);
  if (overlays.empty())
  {
    return radiance;
  }
  const Picture shown = CaptureWindow(renderer->GetRenderWindow(), alpha);
  SetVisible(overlays, false);
  const ScopeExit restore([&overlays] { SetVisible(overlays, true); });
  redraw();
  const Picture opaque = CaptureWindow(renderer->GetRenderWindow(), alpha);
  constexpr float rounding = 1.5f / 255; // ignore one step of the 8-bit picture
  for (std::size_t i = 0; i < radiance.PixelCount(); ++i)
  {
    bool differs = false;
    for (int channel = 0; channel < 3; ++channel)
    {
      differs = differs || std::abs(shown.Color(i, channel) - opaque.Color(i, channel)) > rounding;
    }
    for (int channel = 0; differs && channel < radiance.Channels; ++channel)
    {
      radiance.Pixel(i)[channel] = shown.Pixel(i)[channel];
    }
  }
  return radiance;
}

void AppendSurfaceLayers(vtkGIPass* pass, vtkRenderer* renderer, Picture& picture)
{
  auto* tracer = vtkGIPathTracing::SafeDownCast(pass->GetTechnique("path-tracing"));
  if (!tracer || !tracer->GetEnabled())
  {
    return;
  }
  std::array<Picture, 4> buffers;
  const std::array<const char*, 4> bufferNames = { "path-tracing.albedo", "path-tracing.normal",
    "path-tracing.shown", "path-tracing.encoded" };
  for (std::size_t i = 0; i < buffers.size(); ++i)
  {
    vtkNew<vtkImageData> image;
    if (!pass->GetBuffer(renderer, bufferNames[i], image))
    {
      return;
    }
    buffers[i] = FromImage(image, 4, [](double value) { return value; });
  }
  const auto& [albedo, normal, shown, encoded] = buffers;
  const auto samples = static_cast<float>(tracer->GetSamplesTaken(renderer));
  std::vector<std::string> names = { "albedo.R", "albedo.G", "albedo.B", "normal.X", "normal.Y",
    "normal.Z", "Z", "samples", "error" };
  vtkGITechnique* denoising = pass->GetTechnique("denoising");
  const bool filtered = denoising && denoising->GetEnabled();
  if (filtered)
  {
    names.insert(names.end(), { "noisy.R", "noisy.G", "noisy.B" });
  }
  Picture all(picture.Width, picture.Height, picture.Channels + static_cast<int>(names.size()));
  all.Layers = names;
  for (std::size_t i = 0; i < all.PixelCount(); ++i)
  {
    float* out = std::copy_n(picture.Pixel(i), picture.Channels, all.Pixel(i));
    const float hits = std::max(1.0f, albedo.Pixel(i)[3]);
    out = std::transform(
      albedo.Pixel(i), albedo.Pixel(i) + 3, out, [hits](float v) { return v / hits; });
    out = std::transform(
      normal.Pixel(i), normal.Pixel(i) + 4, out, [hits](float v) { return v / hits; });
    *out++ = samples;
    *out++ = StandardError(shown.Pixel(i), encoded.Pixel(i), samples);
    if (filtered)
    {
      std::transform(shown.Pixel(i), shown.Pixel(i) + 3, encoded.Pixel(i), out,
        [samples](float a, float b) { return (a + b) / samples; });
    }
  }
  picture = std::move(all);
}
}
