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
MotionTable::Eye MotionTable::EyeOf(const View& view)
{
  const glm::dvec3 shift(2.0 * view.Jitter / glm::dvec2(view.Viewport.z, view.Viewport.w), 0.0);
  return { view.WorldToView, glm::translate(glm::dmat4(1.0), -shift) * view.ViewToClip,
    glm::dvec2(shift) };
}

void MotionTable::Begin(const View& view)
{
  this->Before = this->Now;
  this->TracksBefore.swap(this->TracksNow);
  this->TracksNow.clear();
  this->Continued = view.FrameNumber == this->FrameNumber + 1;
  this->Current = &view;
  this->Rows.assign(1, glm::mat4(this->Before.WorldToView * view.ViewToWorld));
}

bool MotionTable::Deform(const std::vector<vtkProp*>& props)
{
  // Kept once it was seen, as mappers rebuild their shaders for it.
  this->Deforms |= this->Points.Update(props);
  return this->Deforms;
}

const glm::dmat4& MotionTable::WorldToView() const
{
  return this->Current->WorldToView;
}

int MotionTable::NewNumber()
{
  constexpr int limit = 1 << 24; // a float holds every integer below
  return this->Numbers = this->Numbers % (limit - 1) + 1;
}

int MotionTable::RowOf(const glm::dmat4& now, const Track* before)
{
  // At rest, or one of several places of which nobody can tell which it was.
  if (!before || before->Places.size() != 1 || before->Places[0] == now)
  {
    return 0;
  }
  this->Rows.emplace_back(
    this->Before.WorldToView * before->Places[0] * glm::inverse(now) * this->Current->ViewToWorld);
  return static_cast<int>(this->Rows.size()) - 1;
}

MaterialTable::Owner MotionTable::Find(vtkActor* actor)
{
  const glm::dmat4 now = ToMatrix(actor->GetMatrix());
  Track& track = this->TracksNow[actor];
  const auto place = std::find(track.Places.begin(), track.Places.end(), now);
  if (place != track.Places.end())
  {
    return { track.Rows[place - track.Places.begin()], track.Number };
  }
  const auto found = this->TracksBefore.find(actor);
  const Track* before = found == this->TracksBefore.end() ? nullptr : &found->second;
  if (track.Number == 0)
  {
    track.Shape = actor->GetMapper() ? ShapeTime(actor->GetMapper()) : 0;
    track.Number = before && (before->Shape == track.Shape || this->Points.Knows(actor))
      ? before->Number
      : this->NewNumber();
  }
  track.Places.push_back(now);
  track.Rows.push_back(this->RowOf(now, before));
  return { track.Rows.back(), track.Number };
}

void MotionTable::Upload()
{
  this->Now = EyeOf(*this->Current);
  this->FrameNumber = this->Current->FrameNumber;
  const shared::MotionViewData data = { glm::mat4(this->Now.ViewToClip),
    glm::mat4(this->Before.ViewToClip), this->Rows.front(),
    glm::vec4(this->Before.Shift, 0.0, 0.0) };
  this->ViewBlock.Upload(GL_UNIFORM_BUFFER, &data, sizeof(data));
  this->RowBlock.Upload(
    GL_SHADER_STORAGE_BUFFER, this->Rows.data(), this->Rows.size() * sizeof(this->Rows[0]));
}
}
