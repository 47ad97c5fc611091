// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVGILightShape.h"

#include "vtkGILightShape.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVGILightShape);

vtkPVGILightShape::vtkPVGILightShape() = default;

vtkPVGILightShape::~vtkPVGILightShape()
{
  this->Clear();
}

void vtkPVGILightShape::SetLight(vtkLight* light)
{
  if (light != this->Light)
  {
    this->Clear();
    this->Light = light;
    this->Apply();
  }
}

// While it has no shape, it leaves the light alone: another object may shape it.
void vtkPVGILightShape::SetShape(int shape)
{
  if (shape != this->Shape)
  {
    this->Clear();
    this->Shape = shape;
    this->Apply();
  }
}

void vtkPVGILightShape::SetAngle(double degrees)
{
  this->Angle = degrees;
  this->Apply();
}

void vtkPVGILightShape::SetRadius(double radius)
{
  this->Radius = radius;
  this->Apply();
}

void vtkPVGILightShape::SetSize(double width, double height)
{
  this->Size[0] = width;
  this->Size[1] = height;
  this->Apply();
}

void vtkPVGILightShape::SetTurn(double degrees)
{
  this->Turn = degrees;
  this->Apply();
}

void vtkPVGILightShape::Apply()
{
  switch (this->Shape)
  {
    case vtkGILightShape::POINT:
      vtkGILightShape::SetPoint(this->Light);
      break;
    case vtkGILightShape::ANGLE:
      vtkGILightShape::SetAngle(this->Light, this->Angle);
      break;
    case vtkGILightShape::SPHERE:
      vtkGILightShape::SetSphere(this->Light, this->Radius);
      break;
    case vtkGILightShape::DISC:
      vtkGILightShape::SetDisc(this->Light, this->Radius);
      break;
    case vtkGILightShape::RECTANGLE:
      vtkGILightShape::SetRectangle(this->Light, this->Size[0], this->Size[1], this->Turn);
      break;
    default:
      break;
  }
}

void vtkPVGILightShape::Clear()
{
  if (this->Shape != vtkGILightShape::NONE)
  {
    vtkGILightShape::Remove(this->Light);
  }
}
