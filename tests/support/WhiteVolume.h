// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A matte white, shaded volume of 33 x 33 x 33 points around the origin. Sample distance and opacity scale with its
 * size.
 */
#pragma once

#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cmath>

namespace penumbra_test
{
/// Create a cube of width 2 * radius. value: function of the distance from the origin in units of the radius.
template <typename Value>
vtkSmartPointer<vtkVolume> WhiteVolume(
  double radius, const Value& value, vtkPiecewiseFunction* opacity)
{
  constexpr int n = 33;
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  const double spacing = 2.0 * radius / (n - 1);
  image->SetOrigin(-radius, -radius, -radius);
  image->SetSpacing(spacing, spacing, spacing);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const double distance = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / radius;
    image->GetPointData()->GetScalars()->SetTuple1(i, value(distance));
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(0.02 * radius));
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(0.01 * radius);
  property->SetColor(white);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(0.9);
  property->SetSpecular(0.0);
  return volume;
}
}
