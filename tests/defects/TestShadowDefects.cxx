// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Defects.h"

#include "vtkCubeSource.h"

namespace penumbra_test
{
namespace
{
constexpr double Height = 4.0; // of the picture, in world units

// A ball over a floor and a light at 45 degrees: its shadow falls at x = 1.
Picture BallOnFloor(By by, void (*setLights)(Stage&))
{
  Stage stage;
  AddFloor(stage);
  AddBall(stage);
  setLights(stage);
  LookDown(stage, Height);
  SwitchOnShadows(stage, by);
  return Shoot(stage.Window);
}

void Slanted(Stage& stage)
{
  AddLight(stage, -5.0, 0.0, 5.0);
}

bool HasShadow(const Picture& picture)
{
  return FloorGrey(picture, Height, 1.0, 0.0) < 0.3 * FloorGrey(picture, Height, 1.0, 1.2);
}

// Control: both draw shadows in a simple scene, so other tests fail for another reason.
TEST(ShadowDefects, BothDrawAShadow)
{
  EXPECT_TRUE(HasShadow(BallOnFloor(By::Stock, Slanted)));
  EXPECT_TRUE(HasShadow(BallOnFloor(By::Ours, Slanted)));
}

// With stock VTK, an omnidirectional light casts no shadow.
TEST(ShadowDefects, OmnidirectionalLight)
{
  const auto lamp = [](Stage& stage) {
    vtkLight* light = AddLight(stage, -1.0, 0.0, 2.0);
    light->PositionalOn();
    light->SetConeAngle(180.0);
  };
  if (StockIsDefective())
  {
    EXPECT_FALSE(HasShadow(BallOnFloor(By::Stock, lamp)));
  }
  EXPECT_TRUE(HasShadow(BallOnFloor(By::Ours, lamp)));
}

// Brightness of an empty floor with shadows, relative to that without.
double FloorBrightness(By by, int width, int height)
{
  const auto shoot = [&](By who) {
    Stage stage;
    stage.Window->SetSize(width, height);
    AddFloor(stage, 4.0);
    AddLight(stage, 1.0, 1.0, 3.0);
    LookDown(stage, 4.0);
    SwitchOnShadows(stage, who);
    return Shoot(stage.Window).MeanGrey(0, 0, width, height);
  };
  return shoot(by) / shoot(By::None);
}

// Stock VTK computes shadow coordinates as if the window were square.
TEST(ShadowDefects, NonSquareViewport)
{
  for (const auto& size : { std::pair(400, 400), std::pair(800, 400), std::pair(333, 617) })
  {
    const double stock = FloorBrightness(By::Stock, size.first, size.second);
    const double ours = FloorBrightness(By::Ours, size.first, size.second);
    std::printf(
      "%d x %d: stock keeps %.3f of the light, ours %.3f\n", size.first, size.second, stock, ours);
    if (size.first == 800 && StockIsDefective())
    {
      EXPECT_LT(stock, 0.9);
    }
    EXPECT_NEAR(ours, 1.0, 0.005);
  }
}

// Difference that a glass ball above the floor makes to the picture.
double GlassDifference(By by)
{
  const auto shoot = [by](bool glass) {
    Stage stage;
    AddFloor(stage);
    Slanted(stage);
    AddBall(stage);
    vtkActor* ball = stage.Renderer->GetActors()->GetLastActor();
    ball->GetProperty()->SetColor(0.2, 0.2, 0.9);
    ball->GetProperty()->SetOpacity(0.6);
    LookDown(stage, Height);
    ball->SetVisibility(glass);
    SwitchOnShadows(stage, by);
    return Shoot(stage.Window);
  };
  return std::abs(
    FloorGrey(shoot(true), Height, 0.0, 0.0) - FloorGrey(shoot(false), Height, 0.0, 0.0));
}

TEST(ShadowDefects, TranslucentPropsAreDrawn)
{
  if (StockIsDefective())
  {
    EXPECT_LT(GlassDifference(By::Stock), 1.0);
  }
  EXPECT_GT(GlassDifference(By::Ours), 20.0);
}

// Difference that occlusion makes to a picture with shadows.
double OcclusionWithShadows(By by)
{
  const auto shoot = [by](bool occlusion) {
    Stage stage;
    AddFloor(stage);
    AddBall(stage)->SetCenter(0.0, 0.0, 0.4);
    Slanted(stage);
    Stage::LookAround(stage.Renderer);
    if (occlusion)
    {
      SwitchOnOcclusion(stage, by, 0.5);
    }
    SwitchOnShadows(stage, by);
    if (by == By::Ours && occlusion)
    {
      // SwitchOnShadows() has replaced the pass with occlusion by a new one.
      auto* pass = static_cast<vtkGIPass*>(stage.Renderer->GetPass());
      pass->GetTechnique("ambient-occlusion")->EnabledOn();
    }
    return Shoot(stage.Window);
  };
  return Compare(shoot(true), shoot(false), 2).Mean;
}

TEST(ShadowDefects, OcclusionStaysOn)
{
  if (StockIsDefective())
  {
    EXPECT_EQ(OcclusionWithShadows(By::Stock), 0.0);
  }
  EXPECT_GT(OcclusionWithShadows(By::Ours), 0.5);
}

// Number of red pixels in a picture of an unlit red ball, which is white or grey elsewhere.
int RedPixels(By by)
{
  Stage stage;
  AddFloor(stage);
  AddBall(stage);
  vtkActor* ball = stage.Renderer->GetActors()->GetLastActor();
  ball->GetProperty()->SetColor(1.0, 0.0, 0.0);
  ball->GetProperty()->LightingOff();
  Slanted(stage);
  LookDown(stage, Height);
  SwitchOnShadows(stage, by);
  const Picture picture = Shoot(stage.Window);
  int red = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const auto pixel = picture.At(x, y);
      red += pixel[0] > 200 && pixel[1] < 10;
    }
  }
  return red;
}

// VTK's pass inserts code at a place that shaders of unlit actors do not have, and they do not compile.
TEST(ShadowDefects, UnlitActorsAreDrawn)
{
  if (StockIsDefective(9, 3))
  {
    EXPECT_EQ(RedPixels(By::Stock), 0);
    EXPECT_FALSE(TakeMessages().empty());
  }
  EXPECT_EQ(RedPixels(By::Ours), RedPixels(By::None));
}

// Some parts of VTK's pass count lights that are off, and others do not.
TEST(ShadowDefects, LightOffEarlierInTheList)
{
  const auto lights = [](Stage& stage) {
    AddLight(stage, 3.0, 3.0, 5.0)->SwitchOff();
    AddLight(stage, 0.0, 3.0, 5.0)->SwitchOff();
    Slanted(stage);
  };
  const bool stock = HasShadow(BallOnFloor(By::Stock, lights));
  TakeMessages();
  if (StockIsDefective())
  {
    EXPECT_FALSE(stock);
  }
  EXPECT_TRUE(HasShadow(BallOnFloor(By::Ours, lights)));
}

// Share of pixels that agree between a ball moved by its data after the first frame, and one that was there before.
double FollowsData(By by)
{
  const auto shoot = [by](double first, double second) {
    Stage stage;
    AddFloor(stage);
    auto ball = AddBall(stage, first);
    Slanted(stage);
    LookDown(stage, Height);
    SwitchOnShadows(stage, by);
    stage.Window->Render();
    ball->SetCenter(second, 0.5, 1.0);
    return Shoot(stage.Window);
  };
  return Compare(shoot(0.3, -0.8), shoot(-0.8, -0.8), 2).Within;
}

// VTK redraws its map if a prop changes, but not if only its data change.
TEST(ShadowDefects, ShadowsFollowTheData)
{
  if (StockIsDefective())
  {
    EXPECT_LT(FollowsData(By::Stock), 0.99);
  }
  EXPECT_GT(FollowsData(By::Ours), 0.999);
}

TEST(ShadowDefects, PhysicallyBasedMaterials)
{
  const auto lamp = [](Stage& stage) {
    vtkLight* light = AddLight(stage, -3.0, 0.0, 3.0);
    light->PositionalOn();
    light->SetConeAngle(40.0);
    light->SetIntensity(3.0);
    vtkActorCollection* actors = stage.Renderer->GetActors();
    for (int i = 0; i < actors->GetNumberOfItems(); ++i)
    {
      auto* actor = static_cast<vtkActor*>(actors->GetItemAsObject(i));
      actor->GetProperty()->SetInterpolationToPBR();
      actor->GetProperty()->SetRoughness(0.9);
    }
  };
  const bool stock = HasShadow(BallOnFloor(By::Stock, lamp));
  TakeMessages();
  if (StockIsDefective(9, 5))
  {
    EXPECT_FALSE(stock);
  }
  EXPECT_TRUE(HasShadow(BallOnFloor(By::Ours, lamp)));
}

// Brightness beside a low box. An exponential shadow map leaks light close to the occluder.
double ShadowOfALowBox(By by)
{
  Stage stage;
  AddFloor(stage);
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-0.5, 0.5, -0.5, 0.5, 0.0, 0.2);
  stage.Add(box);
  Slanted(stage);
  LookDown(stage, Height);
  SwitchOnShadows(stage, by);
  const Picture picture = Shoot(stage.Window);
  return FloorGrey(picture, Height, 0.58, 0.0) / FloorGrey(picture, Height, 1.5, 0.0);
}

TEST(ShadowDefects, NearOccluderLeaksNoLight)
{
  const double stock = ShadowOfALowBox(By::Stock);
  const double ours = ShadowOfALowBox(By::Ours);
  std::printf("light left beside a low box: stock %.3f, ours %.3f\n", stock, ours);
  if (StockIsDefective())
  {
    EXPECT_GT(stock, 0.02);
  }
  EXPECT_LT(ours, 0.02);
}
}
}
