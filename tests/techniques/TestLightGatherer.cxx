// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light gathered at points, in scenes whose light is known.
 */
#include "Messages.h"
#include "SceneParts.h"
#include "Stage.h"

#include "vtkGILightGatherer.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCubeSource.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace penumbra_test;

namespace
{
const double Root4Pi = std::sqrt(4.0 * glm::pi<double>());

class LightGatherer : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Scene.Renderer->AutomaticLightCreationOff();
    for (vtkDoubleArray* array : { this->Points.Get(), this->Normals.Get() })
    {
      array->SetNumberOfComponents(3);
    }
  }

  vtkActor* AddBox(double half, double albedo, double emission)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(-half, half, -half, half, -half, half);
    return this->Paint(this->Scene.Add(cube), albedo, emission);
  }
  static vtkActor* Paint(vtkActor* actor, double albedo, double emission)
  {
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    actor->GetProperty()->SetDiffuse(albedo);
    actor->GetProperty()->SetAmbient(emission);
    actor->GetProperty()->SetInterpolationToFlat();
    return actor;
  }
  void AddPoint(const glm::dvec3& point, const glm::dvec3& normal = glm::dvec3(0.0, 0.0, 1.0))
  {
    this->Points->InsertNextTuple3(point.x, point.y, point.z);
    this->Normals->InsertNextTuple3(normal.x, normal.y, normal.z);
  }
  void Gather(bool normals)
  {
    ASSERT_TRUE(this->Gatherer->Gather(this->Scene.Renderer, this->Points,
      normals ? this->Normals.Get() : nullptr, this->Light, this->Surroundings))
      << this->Gatherer->GetLastError();
  }
  double Value(vtkIdType point, int component)
  {
    return this->Light->GetTypedComponent(point, component);
  }
  void SetEnvironment(double radiance)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(8, 4, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    auto* pixels = static_cast<float*>(image->GetScalarPointer());
    std::fill(pixels, pixels + 8 * 4 * 3, static_cast<float>(radiance));
    this->Scene.Renderer->SetEnvironmentTexture(EnvironmentTexture(image));
    this->Scene.Renderer->UseImageBasedLightingOn();
  }

  Stage Scene;
  vtkNew<vtkGILightGatherer> Gatherer;
  vtkNew<vtkDoubleArray> Points;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkFloatArray> Light;
  vtkNew<vtkFloatArray> Surroundings;
};
}

TEST_F(LightGatherer, ClosedEnclosureKeepsItsEnergy)
{
  constexpr double emission = 0.25;
  constexpr double reflectance = 0.8;
  this->AddBox(1.0, reflectance, emission);
  for (const double x : { -0.9, -0.3, 0.2, 0.7 })
  {
    this->AddPoint({ x, 0.5 * x, -0.4 }, { 0.6, 0.0, 0.8 });
  }
  this->Gatherer->SetSamples(65536);
  const double expected = emission / (1.0 - reflectance);
  std::vector<double> errors;
  this->Gather(false);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    errors.push_back(this->Value(i, 0) / (expected * Root4Pi) - 1.0);
    EXPECT_NEAR(this->Surroundings->GetComponent(i, 0), 1.0, 1e-6); // the box from inside
    EXPECT_NEAR(this->Surroundings->GetComponent(i, 1), 1.0, 1e-6);
  }
  this->Gather(true);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    errors.push_back(this->Value(i, 1) / expected - 1.0);
  }
  double mean = 0.0;
  double squares = 0.0;
  for (const double error : errors)
  {
    mean += error / static_cast<double>(errors.size());
    squares += error * error / static_cast<double>(errors.size());
  }
  // Each value has noise; the mean error is the bias.
  std::printf("closed box: mean error %.3f %%, root mean square %.3f %%\n", 100.0 * mean,
    100.0 * std::sqrt(squares));
  EXPECT_LT(std::abs(mean), 0.0003);
  EXPECT_LT(std::sqrt(squares), 0.01);
}

// With a lamp at the centre of a ball, every point of the wall receives the same light, directly and indirectly.
TEST_F(LightGatherer, ABallAroundALampIsLitEvenly)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(2.0);
  ball->SetPhiResolution(128);
  ball->SetThetaResolution(256);
  this->Paint(this->Scene.Add(ball), 0.5, 0.0);
  vtkLight* lamp = AddLight(this->Scene, 0.0, 0.0, 0.0);
  ShineAllRound(lamp);
  lamp->SetColor(0.3, 0.6, 0.9);
  vtkNew<vtkLight> head; // left out
  head->SetLightTypeToHeadlight();
  this->Scene.Renderer->AddLight(head);
  this->AddPoint({ 0.0, 0.0, 1.99 }, { 0.0, 0.0, -1.0 });
  this->Gatherer->SetSamples(4096);
  this->Gather(true);
  EXPECT_EQ(this->Gatherer->GetNumberOfLampsLeftOut(), 1);
  const double share = 0.5 / (1.0 - 0.5);
  std::printf("ball: %.5f of %.5f", this->Value(0, 2), 0.9 * share);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(this->Value(0, k), 0.3 * (k + 1) * share, 0.00075 * 0.3 * (k + 1));
  }
  this->Gatherer->IncludeLampsOn();
  this->Gather(true);
  std::printf(", with the lamp %.5f of %.5f\n", this->Value(0, 2), 0.9 * (1.0 + share));
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(this->Value(0, k), 0.3 * (k + 1) * (1.0 + share), 0.00075 * 0.3 * (k + 1));
  }
  this->Gatherer->IncludeIndirectOff();
  this->Gatherer->SetSamples(1);
  this->Gather(true);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(this->Value(0, k), 0.3 * (k + 1), 1e-5) << "the lamp alone, without noise";
  }
}

TEST_F(LightGatherer, AConstantEnvironmentHasOnlyTheFirstHarmonic)
{
  this->SetEnvironment(0.7);
  this->AddBox(0.1, 0.0, 0.0)->SetPosition(50.0, 0.0, 0.0);
  this->AddPoint({ 0.0, 0.0, 0.0 }, { 0.48, 0.6, 0.64 });
  this->Gatherer->SetSamples(4096);
  this->Gatherer->DirectionalOn();
  this->Gather(false);
  ASSERT_EQ(this->Light->GetNumberOfComponents(), 27);
  EXPECT_NEAR(this->Value(0, 0), 0.7 * Root4Pi, 0.001 * 0.7 * Root4Pi);
  double most = 0.0;
  for (int k = 3; k < 27; ++k)
  {
    most = std::max(most, std::abs(this->Value(0, k)));
  }
  std::printf("environment: first harmonic %.6f of %.6f, others at most %.6f\n", this->Value(0, 0),
    0.7 * Root4Pi, most);
  EXPECT_LT(most, 0.005 * 0.7 * Root4Pi);
  EXPECT_NEAR(this->Surroundings->GetComponent(0, 1), 0.0, 1e-3);
  this->Gather(true);
  ASSERT_EQ(this->Light->GetNumberOfComponents(), 15);
  const double expected[5] = { 1.0, 1.0, 0.24, 0.3, 0.32 };
  for (int k = 0; k < 15; ++k)
  {
    EXPECT_NEAR(this->Value(0, k), 0.7 * expected[k / 3], 0.002) << k;
  }
}

TEST_F(LightGatherer, AnEmitterLightsByItsFormFactor)
{
  vtkActor* square = AddFloor(this->Scene, -0.5, 0.5, -0.5, 0.5, 1.0);
  this->Paint(square, 0.0, 1.0)->GetProperty()->SetAmbientColor(2.0, 2.0, 2.0);
  this->AddPoint({ 0.0, 0.0, 0.0 });
  this->Gatherer->SetSamples(4096);
  this->Gather(true);
  std::printf("point below a square: %.6f of 0.239456\n", this->Value(0, 0) / 2.0);
  EXPECT_NEAR(this->Value(0, 0) / 2.0, 0.239456, 0.00015 * 0.239456);
}

TEST_F(LightGatherer, PartsOfTheSamplesAverageToTheWhole)
{
  this->AddBox(1.0, 0.5, 0.3);
  this->AddPoint({ 0.3, 0.2, -0.1 });
  this->AddPoint({ -0.3, 0.6, 0.4 });
  this->Gatherer->SetSamples(512);
  this->Gather(false);
  vtkNew<vtkFloatArray> whole;
  whole->DeepCopy(this->Light);
  this->Gatherer->SetSamples(128);
  double sums[2][27] = {};
  for (int part = 0; part < 4; ++part)
  {
    this->Gatherer->SetFirstSample(128 * part);
    this->Gather(false);
    for (int k = 0; k < 2 * 27; ++k)
    {
      sums[k / 27][k % 27] += 0.25 * this->Value(k / 27, k % 27);
    }
  }
  for (int k = 0; k < 2 * 27; ++k)
  {
    EXPECT_NEAR(sums[k / 27][k % 27], whole->GetTypedComponent(k / 27, k % 27), 1e-5);
  }
  // Other points make no difference; another seed does.
  this->Gatherer->SetFirstSample(0);
  this->Gatherer->SetSamples(512);
  this->Points->SetNumberOfTuples(0);
  this->Points->InsertNextTuple3(-0.3, 0.6, 0.4);
  this->Gather(false);
  EXPECT_NEAR(this->Value(0, 5), whole->GetTypedComponent(1, 5), 1e-6);
  this->Gatherer->SetSeed(1);
  this->Gather(false);
  EXPECT_NE(this->Value(0, 5), whole->GetTypedComponent(1, 5));
}

TEST_F(LightGatherer, ReportsBadInput)
{
  this->AddBox(1.0, 0.5, 0.3);
  const auto expectError = [this](
                             vtkRenderer* renderer, vtkDataArray* normals, const char* reason) {
    EXPECT_FALSE(this->Gatherer->Gather(renderer, this->Points, normals, this->Light));
    EXPECT_NE(std::string(this->Gatherer->GetLastError()).find(reason), std::string::npos)
      << this->Gatherer->GetLastError();
  };
  this->AddPoint({ 0.0, 0.0, 0.0 });
  expectError(nullptr, nullptr, "render window");
  vtkNew<vtkDoubleArray> normals;
  expectError(this->Scene.Renderer, normals, "three components");
  normals->SetNumberOfComponents(3);
  expectError(this->Scene.Renderer, normals, "as many normals");
  this->Points->InsertNextTuple3(std::nan(""), 0.0, 0.0);
  expectError(this->Scene.Renderer, nullptr, "number 1 is not");
}

TEST_F(LightGatherer, ReportsProgressAndCanBeAborted)
{
  this->AddBox(1.0, 0.5, 0.3);
  this->AddPoint({ 0.0, 0.0, 0.0 });
  vtkNew<vtkCallbackCommand> observer;
  std::vector<double> progress;
  observer->SetClientData(&progress);
  observer->SetCallback([](vtkObject* caller, unsigned long, void* data, void* value) {
    auto& all = *static_cast<std::vector<double>*>(data);
    all.push_back(*static_cast<double*>(value));
    if (all.size() == 3)
    {
      static_cast<vtkGILightGatherer*>(caller)->AbortOn();
    }
  });
  this->Gatherer->AddObserver(vtkCommand::ProgressEvent, observer);
  this->Gatherer->SetSamples(1 << 24);
  EXPECT_FALSE(this->Gatherer->Gather(this->Scene.Renderer, this->Points, nullptr, this->Light));
  EXPECT_EQ(this->Light->GetNumberOfTuples(), 0);
  ASSERT_EQ(progress.size(), 3u);
  EXPECT_LT(progress[0], progress[1]);
  EXPECT_STREQ(this->Gatherer->GetLastError(), "");
}
