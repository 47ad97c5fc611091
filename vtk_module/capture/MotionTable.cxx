// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/MotionTable.h"

#include "base/Matrices.h"
#include "capture/ChangeTimes.h"
#include "graph/View.h"

#include "motion.h"

#include "vtkActor.h"
#include "vtkMapper.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace penumbra
{
MotionTable::Camera MotionTable::CameraOf(const View& view)
{
  const glm::dvec3 shift(2.0 * view.Jitter / glm::dvec2(view.Viewport.z, view.Viewport.w), 0.0);
  return { view.WorldToView, glm::translate(glm::dmat4(1.0), -shift) * view.ViewToClip,
    glm::dvec2(shift) };
}

void MotionTable::Begin(const View& view)
{
  this->PreviousCamera = this->CurrentCamera;
  this->PreviousTracks.swap(this->CurrentTracks);
  this->CurrentTracks.clear();
  this->Continued = view.FrameNumber == this->FrameNumber + 1;
  this->CurrentView = &view;
  this->Rows.assign(1, glm::mat4(this->PreviousCamera.WorldToView * view.ViewToWorld));
}

bool MotionTable::Deform(const std::vector<vtkProp*>& props)
{
  // This never returns to false, as mappers rebuild their shaders when it changes.
  this->Deforms |= this->PointMotions.Update(props);
  return this->Deforms;
}

const glm::dmat4& MotionTable::WorldToView() const
{
  return this->CurrentView->WorldToView;
}

int MotionTable::NewNumber()
{
  constexpr int limit = 1 << 24; // a float represents all smaller integers
  return this->LastNumber = this->LastNumber % (limit - 1) + 1;
}

int MotionTable::RowOf(const glm::dmat4& propToWorld, const Track* previous)
{
  // The prop is at rest, or it has several transformations that cannot be matched.
  if (!previous || previous->Transforms.size() != 1 || previous->Transforms[0] == propToWorld)
  {
    return 0;
  }
  this->Rows.emplace_back(this->PreviousCamera.WorldToView * previous->Transforms[0] *
    glm::inverse(propToWorld) * this->CurrentView->ViewToWorld);
  return static_cast<int>(this->Rows.size()) - 1;
}

MaterialTable::Owner MotionTable::Find(vtkActor* actor)
{
  const glm::dmat4 propToWorld = ToMatrix(actor->GetMatrix());
  Track& track = this->CurrentTracks[actor];
  const auto transform = std::find(track.Transforms.begin(), track.Transforms.end(), propToWorld);
  if (transform != track.Transforms.end())
  {
    return { track.Rows[transform - track.Transforms.begin()], track.Number };
  }
  const auto found = this->PreviousTracks.find(actor);
  const Track* previous = found == this->PreviousTracks.end() ? nullptr : &found->second;
  if (track.Number == 0)
  {
    track.Shape = actor->GetMapper() ? ShapeTime(actor->GetMapper()) : 0;
    track.Number =
      previous && (previous->Shape == track.Shape || this->PointMotions.HasDisplacements(actor))
      ? previous->Number
      : this->NewNumber();
  }
  track.Transforms.push_back(propToWorld);
  track.Rows.push_back(this->RowOf(propToWorld, previous));
  return { track.Rows.back(), track.Number };
}

void MotionTable::Upload()
{
  this->CurrentCamera = CameraOf(*this->CurrentView);
  this->FrameNumber = this->CurrentView->FrameNumber;
  const shared::MotionViewData data = { glm::mat4(this->CurrentCamera.ViewToClip),
    glm::mat4(this->PreviousCamera.ViewToClip), this->Rows.front(),
    glm::vec4(this->PreviousCamera.Shift, 0.0, 0.0) };
  this->ViewBlock.Upload(GL_UNIFORM_BUFFER, &data, sizeof(data));
  this->RowBlock.Upload(
    GL_SHADER_STORAGE_BUFFER, this->Rows.data(), this->Rows.size() * sizeof(this->Rows[0]));
}
}
