// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGISoftBox.h"

#include "sky/CheckedValues.h"
#include "sky/SkyImage.h"

#include "vtkObjectFactory.h"

using namespace penumbra;

vtkStandardNewMacro(vtkGISoftBox);

void vtkGISoftBox::SetElevation(double degrees)
{
  SetChecked(this, "Elevation", this->Elevation, degrees, -90.0, 90.0);
}

void vtkGISoftBox::SetAzimuth(double degrees)
{
  SetChecked(this, "Azimuth", this->Azimuth, degrees, -1e6, 1e6);
}

void vtkGISoftBox::SetWidth(double degrees)
{
  SetChecked(this, "Width", this->Width, degrees, 0.1, 170.0);
}

void vtkGISoftBox::SetHeight(double degrees)
{
  SetChecked(this, "Height", this->Height, degrees, 0.1, 170.0);
}

void vtkGISoftBox::SetRadius(double degrees)
{
  // A smaller disc could fall between the samples of a pixel.
  constexpr double least = 0.05;
  const bool rectangle = degrees <= 0.0;
  SetChecked(this, "Radius", this->Radius, degrees, rectangle ? 0.0 : least, 180.0);
}

void vtkGISoftBox::SetRadiance(double radiance)
{
  SetChecked(this, "Radiance", this->Radiance, radiance, 0.0, 1e6);
}

void vtkGISoftBox::SetColor(double r, double g, double b)
{
  SetCheckedColor(this, "Color", this->Color, r, g, b);
}

void vtkGISoftBox::SetSoftness(double share)
{
  SetChecked(this, "Softness", this->Softness, share, 0.0, 1.0);
}

double vtkGISoftBox::GetSolidAngle()
{
  SkyBox box;
  box.Width = this->Width;
  box.Height = this->Height;
  box.Radius = this->Radius;
  return box.SolidAngle();
}

void vtkGISoftBox::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Direction: elevation " << this->Elevation << ", azimuth " << this->Azimuth
     << "\n"
     << indent << "Size: width " << this->Width << ", height " << this->Height << ", radius "
     << this->Radius << "\n"
     << indent << "Radiance: " << this->Radiance << "\n"
     << indent << "Softness: " << this->Softness << "\n";
}
