// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Motion of a view's props since the previous frame, for the reprojection of their surfaces.
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
  /// Begin a frame. Jitter may still change the view's matrices until the frame is drawn.
  void Begin(const View& view);

  /// Find the motion of points within these props. Returns whether any prop deforms now or did so in an earlier
  /// frame.
  bool Deform(const std::vector<vtkProp*>& props);
  const Deformations& Shapes() const { return this->PointMotions; }

  /// Motion row and number of the prop that is drawn next, at its current position. The number changes if the shape
  /// has changed in an unknown way.
  MaterialTable::Owner Find(vtkActor* actor);

  const glm::dmat4& WorldToView() const;

  /// Whether the previous frame was recorded too.
  bool IsContinued() const { return this->Continued; }

  /// Whether props of this frame have moved. Valid after they are drawn.
  bool PropsMove() const { return this->Rows.size() > 1; }

  /// Upload the matrices of both frames and the motions, after all of the frame's props are drawn.
  void Upload();
  /// Arguments of shaders that include shared/motion.h.
  Arguments ShaderArguments() const
  {
    return Arguments().Block("MotionViewBlock", this->ViewBlock).Block("MotionBlock", this->RowBlock);
  }

private:
  struct Track
  {
    int Number = 0;
    vtkMTimeType Shape = 0;
    std::vector<glm::dmat4> Transforms; ///< transformations; more than one if assemblies share the prop
    std::vector<int> Rows;              ///< motion row of each
  };
  using Tracks = std::map<vtkActor*, Track>;

  /// Camera of a frame.
  struct Camera
  {
    glm::dmat4 WorldToView{ 1.0 };
    glm::dmat4 ViewToClip{ 1.0 }; ///< without jitter
    glm::dvec2 Shift{ 0.0 };      ///< jitter in clip coordinates
  };
  static Camera CameraOf(const View& view);
  int RowOf(const glm::dmat4& propToWorld, const Track* previous);
  int NewNumber();

  const View* CurrentView = nullptr;
  int FrameNumber = -2;
  bool Continued = false;
  int LastNumber = 0;
  Camera PreviousCamera;
  Camera CurrentCamera;
  Tracks PreviousTracks;
  Tracks CurrentTracks;
  std::vector<glm::mat4> Rows; ///< rows of the table
  Deformations PointMotions;
  bool Deforms = false;
  Buffer ViewBlock;
  Buffer RowBlock;
};
}
