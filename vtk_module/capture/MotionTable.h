// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a view's props were in the frame before, so that a pixel's surface can be found there.
 */
#pragma once

#include "capture/Deformations.h"
#include "capture/MaterialTable.h"

#include <vtkType.h>

#include <glm/glm.hpp>

#include <map>
#include <vector>

class vtkActor;

namespace penumbra
{
struct View;

class MotionTable
{
public:
  /// Begin a frame. The view's matrices may be shifted until it is drawn.
  void Begin(const View& view);

  /// Find out how the points of these props moved. Returns whether any prop needs more than a matrix,
  /// now or in a frame before.
  bool Deform(const std::vector<vtkProp*>& props);
  const Deformations& Shapes() const { return this->Points; }

  /// The prop about to be drawn, as it is placed now. Its number is another one where what it shows
  /// has changed, or where nobody can tell from where it came.
  MaterialTable::Owner Find(vtkActor* actor);

  const glm::dmat4& WorldToView() const;

  /// Whether the frame before was recorded too.
  bool IsContinued() const { return this->Continued; }

  /// Whether props of this frame, once drawn, were found to have moved.
  bool PropsMove() const { return this->Rows.size() > 1; }

  /// Once the frame's props were seen: the matrices of both frames, and the motions.
  void Upload();
  /// For shaders that include shared/motion.h.
  Arguments ShaderArguments() const
  {
    return Arguments().Block("MotionViewBlock", this->ViewBlock).Block("MotionBlock", this->RowBlock);
  }

private:
  struct Track
  {
    int Number = 0;
    vtkMTimeType Shape = 0;
    std::vector<glm::dmat4> Places; ///< more than one where assemblies share the prop
    std::vector<int> Rows;          ///< of each place
  };
  using Tracks = std::map<vtkActor*, Track>;

  /// The camera of a frame.
  struct Eye
  {
    glm::dmat4 WorldToView{ 1.0 };
    glm::dmat4 ViewToClip{ 1.0 }; ///< without jitter
    glm::dvec2 Shift{ 0.0 };      ///< the jitter, in clip coordinates
  };
  static Eye EyeOf(const View& view);
  int RowOf(const glm::dmat4& now, const Track* before);
  int NewNumber();

  const View* Current = nullptr;
  int FrameNumber = -2;
  bool Continued = false;
  int Numbers = 0;
  Eye Before;
  Eye Now;
  Tracks TracksBefore;
  Tracks TracksNow;
  std::vector<glm::mat4> Rows; ///< of the table
  Deformations Points;
  bool Deforms = false;
  Buffer ViewBlock;
  Buffer RowBlock;
};
}
