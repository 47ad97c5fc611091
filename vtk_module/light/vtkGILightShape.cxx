// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGILightShape.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkGILightShape);
vtkInformationKeyMacro(vtkGILightShape, SHAPE, Integer);
vtkInformationKeyMacro(vtkGILightShape, SIZE, DoubleVector);

namespace
{
struct Extent
{
  const char* Name;
  double Value;
  double Most;
};

constexpr double AnySize = 1e15; // squares still fit into single precision
constexpr double WidestAngle = 90.0;

bool IsUsable(vtkLight* light, const Extent& extent)
{
  if (extent.Value >= 0.0 && extent.Value <= extent.Most)
  {
    return true;
  }
  vtkErrorWithObjectMacro(light,
    "The " << extent.Name << " of a light must be between 0 and " << extent.Most << ", not "
           << extent.Value << "; the light keeps the shape that it has.");
  return false;
}

void Store(vtkLight* light, int shape, const double* size, int count)
{
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> information;
    light->SetInformation(information);
  }
  vtkInformation* information = light->GetInformation();
  if (shape == vtkGILightShape::NONE)
  {
    information->Remove(vtkGILightShape::SHAPE());
    information->Remove(vtkGILightShape::SIZE());
  }
  else
  {
    information->Set(vtkGILightShape::SHAPE(), shape);
    information->Set(vtkGILightShape::SIZE(), size, count);
  }
  light->Modified();
}

void StoreOne(vtkLight* light, int shape, const Extent& extent)
{
  if (light && IsUsable(light, extent))
  {
    Store(light, extent.Value > 0.0 ? shape : vtkGILightShape::POINT, &extent.Value, 1);
  }
}

double Component(vtkLight* light, bool counts, int index)
{
  vtkInformation* information = light ? light->GetInformation() : nullptr;
  return counts && information && information->Length(vtkGILightShape::SIZE()) > index
    ? information->Get(vtkGILightShape::SIZE(), index)
    : 0.0;
}
}

void vtkGILightShape::Remove(vtkLight* light)
{
  if (light)
  {
    Store(light, NONE, nullptr, 0);
  }
}

void vtkGILightShape::SetPoint(vtkLight* light)
{
  const double none = 0.0;
  if (light)
  {
    Store(light, POINT, &none, 1);
  }
}

void vtkGILightShape::SetAngle(vtkLight* light, double degrees)
{
  StoreOne(light, ANGLE, { "angle", degrees, WidestAngle });
}

void vtkGILightShape::SetSphere(vtkLight* light, double radius)
{
  StoreOne(light, SPHERE, { "radius", radius, AnySize });
}

void vtkGILightShape::SetDisc(vtkLight* light, double radius)
{
  StoreOne(light, DISC, { "radius", radius, AnySize });
}

void vtkGILightShape::SetRectangle(vtkLight* light, double width, double height, double turn)
{
  if (!light || !IsUsable(light, { "width", width, AnySize }) ||
    !IsUsable(light, { "height", height, AnySize }))
  {
    return;
  }
  if (!std::isfinite(turn))
  {
    vtkErrorWithObjectMacro(light,
      "The turn of a light must be finite, not " << turn
                                                 << "; the light keeps the shape that it has.");
    return;
  }
  const double size[] = { width, height, turn };
  Store(light, width > 0.0 && height > 0.0 ? RECTANGLE : POINT, size, 3);
}

void vtkGILightShape::Copy(vtkLight* from, vtkLight* to)
{
  if (!from || !to || from == to)
  {
    return;
  }
  const int shape = GetShape(from);
  const double size[] = { Component(from, true, 0), Component(from, true, 1),
    Component(from, true, 2) };
  Store(to, shape, size, shape == RECTANGLE ? 3 : 1);
}

int vtkGILightShape::GetShape(vtkLight* light)
{
  vtkInformation* information = light ? light->GetInformation() : nullptr;
  return information && information->Has(SHAPE()) ? information->Get(SHAPE()) : NONE;
}

double vtkGILightShape::GetAngle(vtkLight* light)
{
  return Component(light, GetShape(light) == ANGLE, 0);
}

double vtkGILightShape::GetRadius(vtkLight* light)
{
  const int shape = GetShape(light);
  return Component(light, shape == SPHERE || shape == DISC, 0);
}

double vtkGILightShape::GetWidth(vtkLight* light)
{
  return Component(light, GetShape(light) == RECTANGLE, 0);
}

double vtkGILightShape::GetHeight(vtkLight* light)
{
  return Component(light, GetShape(light) == RECTANGLE, 1);
}

double vtkGILightShape::GetTurn(vtkLight* light)
{
  return Component(light, GetShape(light) == RECTANGLE, 2);
}
