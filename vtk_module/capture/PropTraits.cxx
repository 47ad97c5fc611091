// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/PropTraits.h"

#include "capture/ShaderHooks.h"
#include "rays/parts/MapperTable.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkProp3DCollection.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

namespace penumbra
{
namespace
{
/// Whether the predicate is true of the prop, or of any part of an assembly. other: the answer for a prop that is no
/// actor.
template <typename Predicate>
bool AnyActor(vtkProp* prop, bool other, const Predicate& predicate)
{
  if (vtkAssembly* assembly = vtkAssembly::SafeDownCast(prop))
  {
    vtkProp3DCollection* parts = assembly->GetParts();
    vtkCollectionSimpleIterator cookie;
    parts->InitTraversal(cookie);
    while (vtkProp3D* part = parts->GetNextProp3D(cookie))
    {
      if (AnyActor(part, other, predicate))
      {
        return true;
      }
    }
    return false;
  }
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  return actor ? predicate(actor) : other;
}

// Whether a user's own shader code writes the final colour, so that its light cannot be separated.
bool WritesItsOwnColor(vtkActor* actor)
{
  vtkShaderProperty* shader = actor->GetShaderProperty();
  if (shader->HasFragmentShaderCode())
  {
    const std::string code = shader->GetFragmentShaderCode();
    if (!Contains(code, "//VTK::Light::Impl") || !Contains(code, "//VTK::TCoord::Impl"))
    {
      return true;
    }
  }
  for (int i = 0; i < shader->GetNumberOfShaderReplacements(); ++i)
  {
    std::string tag;
    std::string code;
    bool first = false;
    bool all = false;
    shader->GetNthShaderReplacement(i, tag, first, code, all);
    if (Contains(code, "gl_FragData") || Contains(code, "fragOutput"))
    {
      return true;
    }
  }
  return false;
}

// Upper bound of the share of light from all around that a property's highlight reflects, facing the eye.
double HighlightOf(vtkProperty* property)
{
  if (!property || !property->GetLighting())
  {
    return 0.0;
  }
  if (property->GetInterpolation() == VTK_PBR)
  {
    const bool metal = property->GetMetallic() > 0.0 || property->GetNumberOfTextures() > 0;
    return metal || property->GetBaseIOR() > 1.0 ? 1.0 : 0.0;
  }
  const double* color = property->GetSpecularColor();
  return 2.0 * property->GetSpecular() * std::max(color[0], std::max(color[1], color[2])) /
    (property->GetSpecularPower() + 1.0);
}

// Whether all cells are drawn as faces. VTK does not light some lines and points.
bool IsAllFaces(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (!IsAllFaces(it->GetCurrentDataObject()))
      {
        return false;
      }
    }
    return true;
  }
  auto* surface = vtkPolyData::SafeDownCast(data);
  return surface && surface->GetNumberOfVerts() == 0 && surface->GetNumberOfLines() == 0;
}

bool MayHaveAmbient(vtkProperty* property, bool environment)
{
  if (!property)
  {
    return false;
  }
  // VTK draws edges with their own colour as the ambient term.
  const bool plain = property->GetLighting() && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetEdgeVisibility() && !property->GetVertexVisibility();
  // For clear coat and anisotropy only the total colour is known.
  const bool pbr = property->GetInterpolation() == VTK_PBR;
  const bool layered =
    pbr && (property->GetCoatStrength() > 0.0 || property->GetAnisotropy() > 0.0);
  return !plain || layered || (pbr ? environment : property->GetAmbient() > 0.0);
}
}

namespace
{
bool HasScalars(vtkMapper* mapper, vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (HasScalars(mapper, it->GetCurrentDataObject()))
      {
        return true;
      }
    }
    return false;
  }
  auto* set = vtkDataSet::SafeDownCast(data);
  int association = 0;
  // Other data, such as molecules, always have colours.
  return !set ||
    vtkAbstractMapper::GetAbstractScalars(set, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), association);
}
}

bool IsColoredByData(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkDataObject* data = mapper ? mapper->GetInputDataObject(0, 0) : nullptr;
  return data && mapper->GetScalarVisibility() && HasScalars(mapper, data);
}

bool CanCapture(vtkProp* prop)
{
  return !AnyActor(prop, true, [](vtkActor* actor) {
    const MapperKind* kind = actor->GetMapper() ? FindMapperKind(actor->GetMapper()) : nullptr;
    return !kind || !kind->Hooked || actor->IsA("vtkSkybox") || WritesItsOwnColor(actor);
  });
}

bool NeedsExtended(vtkProp* prop)
{
  return IsPBR(prop) || AnyActor(prop, false, [](vtkActor* actor) {
    return actor->GetTexture() || actor->GetProperty()->GetNumberOfTextures() > 0;
  });
}

bool IsPBR(vtkProp* prop)
{
  return AnyActor(prop, false,
    [](vtkActor* actor) { return actor->GetProperty()->GetInterpolation() == VTK_PBR; });
}

bool ReflectsShare(vtkProp* prop, double share)
{
  return AnyActor(prop, false, [share](vtkActor* actor) {
    return std::max(HighlightOf(actor->GetProperty()), HighlightOf(actor->GetBackfaceProperty())) >=
      std::max(share, 1e-6);
  });
}

bool MayHavePartialCoverage(vtkProp* prop)
{
  return AnyActor(prop, false, [](vtkActor* actor) {
    return actor->GetForceOpaque() || actor->GetProperty()->GetNumberOfTextures() > 0;
  });
}

bool MayHaveAmbient(vtkProp* prop, bool environment)
{
  return AnyActor(prop, true, [environment](vtkActor* actor) {
    vtkMapper* mapper = actor->GetMapper();
    vtkShaderProperty* shader = actor->GetShaderProperty();
    const MapperKind* kind = mapper ? FindMapperKind(mapper) : nullptr;
    return !kind || !kind->OfCells || !IsAllFaces(mapper->GetInputDataObject(0, 0)) ||
      shader->HasVertexShaderCode() || shader->HasGeometryShaderCode() ||
      shader->HasFragmentShaderCode() || shader->GetNumberOfShaderReplacements() > 0 ||
      MayHaveAmbient(actor->GetProperty(), environment) ||
      MayHaveAmbient(actor->GetBackfaceProperty(), environment);
  });
}
}
