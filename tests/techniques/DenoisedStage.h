// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Path-traced pictures, with and without denoising.
 */
#pragma once

#include "RoomStage.h"

#include "vtkGIPathTracing.h"

#include <string>

namespace penumbra_test
{
class DenoisedStage : public RoomStage
{
protected:
  void SetUp() override
  {
    this->Prepare("path-tracing", Width, Height);
    this->Paths = vtkGIPathTracing::SafeDownCast(this->Pass->GetTechnique("path-tracing"));
    this->Paths->SetSamples(Most);
    this->Filter = this->Pass->GetTechnique("denoising");
  }

  /// method: "" for no filter.
  void Denoise(const std::string& method)
  {
    this->Filter->SetEnabled(!method.empty());
    if (!method.empty())
    {
      this->Filter->SetParameterFromText("method", method.c_str());
    }
  }

  /// The picture of some paths.
  Values Draw(const std::string& method, int paths, int seed = 0)
  {
    this->Denoise(method);
    this->Paths->SetSeed(seed);
    this->Pass->Restart();
    return this->After(paths);
  }

  static constexpr int Width = 60;
  static constexpr int Height = 45;
  static constexpr int Most = 10000;
  static constexpr int Few = 16;
  static constexpr int Many = 700;
  vtkGIPathTracing* Paths = nullptr;
  vtkGITechnique* Filter = nullptr;
};
}
