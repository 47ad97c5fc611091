// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rooms lit by baked probes.
 */
#pragma once

#include "RoomStage.h"

#include "vtkGIPathTracing.h"
#include "vtkGIProbeBaker.h"
#include "vtkGISHProbes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace penumbra_test
{
class BakedStage : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("sh-probes", 48, 36);
    this->Probes = vtkGISHProbes::SafeDownCast(this->Pass->GetTechnique("sh-probes"));
    ASSERT_NE(this->Probes, nullptr);
  }

  vtkActor* AddBall(double x, double y, double z, double radius)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(radius);
    ball->SetPhiResolution(48);
    ball->SetThetaResolution(96);
    vtkActor* actor = Paint(this->Scene.Add(ball), 0.8);
    actor->SetPosition(x, y, z);
    return actor;
  }

  /// Winding of a surface's triangles: the original one, all reversed together with their normals, or every second one
  /// reversed.
  enum class Winding
  {
    Original,
    Reversed,
    Mixed
  };
  static void SetWinding(vtkActor* actor, Winding winding)
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(actor->GetMapper()->GetInputConnection(0, 0));
    triangles->Update();
    vtkPolyData* data = triangles->GetOutput();
    for (vtkIdType i = 0; i < data->GetNumberOfCells() && winding != Winding::Original; ++i)
    {
      if (winding == Winding::Reversed || i % 2 == 1)
      {
        data->ReverseCell(i);
      }
    }
    vtkDataArray* normals = data->GetPointData()->GetNormals();
    for (vtkIdType i = 0;
         normals && winding == Winding::Reversed && i < normals->GetNumberOfTuples(); ++i)
    {
      const double* normal = normals->GetTuple3(i);
      normals->SetTuple3(i, -normal[0], -normal[1], -normal[2]);
    }
    vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(data);
  }

  /// Bake the scene and light it by the result.
  void Bake(int probes, int samples, bool adaptive = false)
  {
    this->Baker->SetProbes(probes);
    this->Baker->SetSamples(samples);
    this->Baker->SetAdaptive(adaptive);
    ASSERT_TRUE(this->Baker->Bake(this->Scene.Renderer, this->Field))
      << this->Baker->GetLastError();
    ASSERT_TRUE(this->Probes->SetBake(this->Field)) << this->Probes->GetBakeError();
  }

  /// Picture of the path tracer.
  Values Traced(int bounces, int samples)
  {
    auto* tracer = vtkGIPathTracing::SafeDownCast(this->Pass->GetTechnique("path-tracing"));
    tracer->EnabledOn();
    tracer->SetBounces(bounces);
    tracer->SetSamples(samples);
    const Values values = this->After(samples);
    tracer->EnabledOff();
    return values;
  }

  /// Expect the same radiosity at every pixel. The relative error of the mean shows the bias; that of one pixel
  /// includes the noise of single probes.
  void ExpectRadiosity(double radiosity, double meanLimit, double pixelLimit)
  {
    const Values values = this->After(1);
    const double largest = LargestError(values, radiosity);
    std::printf(
      "radiosity %.5f of %.5f, largest error %.2f %%\n", Mean(values), radiosity, 100.0 * largest);
    EXPECT_LT(std::abs(Mean(values) / radiosity - 1.0), meanLimit);
    EXPECT_LT(largest, pixelLimit);
  }

  bool HasNote(const std::string& words) const
  {
    return std::string(this->Pass->GetNotes()).find(words) != std::string::npos;
  }

  vtkNew<vtkGIProbeBaker> Baker;
  vtkNew<vtkImageData> Field;
  vtkGISHProbes* Probes = nullptr;
};
}
