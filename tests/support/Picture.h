// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of windows, and differences between two of them.
#pragma once

#include <array>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace penumbra_test
{
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels; ///< rgba, bottom row first
  std::vector<float> Depth;          ///< window depth of each pixel

  std::array<int, 4> At(int x, int y) const
  {
    const unsigned char* p = &this->Pixels[4 * (static_cast<std::size_t>(y) * this->Width + x)];
    return { { p[0], p[1], p[2], p[3] } };
  }
  /// Mean of red, green and blue.
  double Grey(int x, int y) const
  {
    const auto p = this->At(x, y);
    return (p[0] + p[1] + p[2]) / 3.0;
  }
  /// Mean of Grey() over a rectangle without its right and top bounds.
  double MeanGrey(int left, int bottom, int right, int top) const;
};

/// Render the window and read it back.
Picture Shoot(vtkRenderWindow* window);

/// Read back the window's current content.
Picture Read(vtkRenderWindow* window);

struct Difference
{
  double Within = 0.0;      ///< share of pixels whose every channel is within the tolerance
  double DepthWithin = 0.0; ///< share of pixels whose depth is within 1e-5
  int Max = 255;
  double Mean = 255.0;
};

/// Compare two pictures. If their sizes differ, all pixels count as different.
Difference Compare(const Picture& a, const Picture& b, int tolerance);

/// Relative mean squared error: the mean of (x - r)^2 / (r^2 + 0.01).
class RelativeError
{
public:
  void Add(double value, double reference)
  {
    this->Sum += (value - reference) * (value - reference) / (reference * reference + 0.01);
    ++this->Count;
  }
  double Mean() const { return this->Sum / this->Count; }

private:
  double Sum = 0.0;
  int Count = 0;
};

/// Share of pixels that do not have the most frequent colour: 0 for a constant picture.
double Busyness(const Picture& picture);

/// Write a PNG file for inspection to the folder PENUMBRA_TEST_OUTPUT. Does nothing if the variable is not set.
void Save(const Picture& picture, const std::string& name);

/// The absolute difference of two pictures times 16.
Picture Amplified(const Picture& a, const Picture& b);
}
