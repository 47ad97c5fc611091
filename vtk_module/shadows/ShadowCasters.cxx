// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shadows/ShadowCasters.h"

#include "base/ScopeExit.h"
#include "capture/ChangeTimes.h"
#include "capture/SceneCapture.h"
#include "gpu/ScopedState.h"
#include "graph/FrameContext.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkProp.h"

#include <algorithm>
#include <cstdint>

namespace penumbra
{
namespace
{
// Thickness, as a share of its width, up to which a caster is flat.
constexpr double FlatShare = 1e-3;

// Time of the last change of a prop or one of its parts.
vtkMTimeType CasterTime(vtkProp* prop)
{
  vtkMTimeType time = prop->GetRedrawMTime();
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    time = std::max(time, part->GetRedrawMTime());
    if (auto* actor = vtkActor::SafeDownCast(part))
    {
      time = std::max(time, AppearanceTime(actor));
    }
  }
  return time;
}

// Number of points or cells of a data set, or of all parts of a composite one.
vtkIdType Elements(vtkDataObject* data, int type)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    return type == vtkDataObject::POINT ? composite->GetNumberOfPoints()
                                        : composite->GetNumberOfCells();
  }
  return data ? data->GetNumberOfElements(type) : 0;
}

void Include(Bounds& sum, const Bounds& other, bool& empty)
{
  for (int i = 0; i < 6; ++i)
  {
    const bool wider = i % 2 == 0 ? other[i] < sum[i] : other[i] > sum[i];
    sum[i] = empty || wider ? other[i] : sum[i];
  }
  empty = false;
}

Bounds Union(const std::vector<Bounds>& parts, std::size_t without)
{
  Bounds sum{};
  bool empty = true;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (i != without)
    {
      Include(sum, parts[i], empty);
    }
  }
  return sum;
}

double Diagonal(const Bounds& b)
{
  return glm::length(glm::dvec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
}

// Whether a caster is flat along an axis and has the others on one side.
bool Borders(const Bounds& flat, const Bounds& others)
{
  const double allowed = FlatShare * Diagonal(flat);
  for (int axis = 0; axis < 6; axis += 2)
  {
    const bool onOneSide =
      others[axis] >= flat[axis + 1] - allowed || others[axis + 1] <= flat[axis] + allowed;
    if (flat[axis + 1] - flat[axis] <= allowed && onOneSide)
    {
      return true;
    }
  }
  return false;
}
}

std::vector<double> CasterSignature(const SceneCapture& scene)
{
  std::vector<double> signature;
  for (vtkProp* prop : scene.Casters())
  {
    signature.push_back(static_cast<double>(CasterTime(prop)));
    signature.push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop)));
  }
  return signature;
}

double CellsOfCasters(const SceneCapture& scene)
{
  double cells = 0.0;
  for (vtkProp* prop : scene.Casters())
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      auto* actor = vtkActor::SafeDownCast(path->GetLastNode()->GetViewProp());
      vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
      if (!mapper || mapper->GetNumberOfInputPorts() == 0)
      {
        continue;
      }
      auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
      vtkPolyData* glyph = glyphs ? glyphs->GetSource(0) : nullptr;
      vtkDataObject* data = mapper->GetInputDataObject(0, 0);
      cells += glyph
        ? static_cast<double>(Elements(data, vtkDataObject::POINT)) * glyph->GetNumberOfCells()
        : static_cast<double>(Elements(data, vtkDataObject::CELL));
    }
  }
  return cells;
}

CasterBounds BoundsOfCasters(const SceneCapture& scene)
{
  std::vector<Bounds> parts;
  for (vtkProp* prop : scene.Casters())
  {
    const double* b = prop->GetBounds();
    if (b && b[0] <= b[1] && b[2] <= b[3] && b[4] <= b[5])
    {
      parts.push_back({ { b[0], b[1], b[2], b[3], b[4], b[5] } });
    }
  }
  CasterBounds result;
  result.Empty = parts.empty();
  result.All = Union(parts, parts.size());
  result.Effective = result.All;
  for (std::size_t i = 0; i < parts.size() && parts.size() > 1; ++i)
  {
    const Bounds others = Union(parts, i);
    if (Diagonal(others) < Diagonal(result.Effective) && Borders(parts[i], others))
    {
      result.Effective = others;
    }
  }
  return result;
}

void DrawShadowMap(FrameContext& context, SceneCapture& scene, const Texture& atlas,
  const ShadowView& view, const AtlasTile& tile, const glm::ivec2& anchor)
{
  ScopedState scope(context.State());
  context.BindTarget({}, { &atlas, -1 });
  scope.Viewport(tile.X, tile.Y, tile.Size, tile.Size);
  scope.Set(GL_SCISSOR_TEST, true);
  scope.Set(GL_DEPTH_TEST, true);
  scope.DepthFunc(GL_LEQUAL);
  scope.DepthMask(true);
  const GLfloat far = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &far);
  // The depth range covers all casters. Clamping keeps those that rounding puts just outside of it.
  glEnable(GL_DEPTH_CLAMP); // VTK's state cache does not track it
  const ScopeExit unclamp([] { glDisable(GL_DEPTH_CLAMP); });
  scene.DrawCasters(context.Renderer(), view.WorldToView, view.ViewToClip, view.Parallel, anchor);
}
}
