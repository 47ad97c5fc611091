// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// A flight of the camera that ends where the camera is.
#pragma once

#include <vtkNew.h>

class vtkCamera;
class vtkRenderer;

namespace penumbra::tool
{
/// Frames after which a frame budget has settled.
constexpr int FlightFrames = 120;

class Flight
{
public:
  explicit Flight(vtkRenderer* renderer);
  ~Flight();
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;

  /// Places the camera for the frame with this number of frames after it.
  void Place(int remaining);

private:
  vtkRenderer* Renderer;
  vtkNew<vtkCamera> End;
};
}
