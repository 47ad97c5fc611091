// Shadow bias by hand: bias_laboratory SCENE.json [--headless OUT.png]
// Sliders set the biases of the shadow maps, in texels. The errors are measured against ray-traced shadows.
#include "lab/BiasReport.h"
#include "lab/BiasStudy.h"
#include "lab/ShadowBench.h"
#include "image/Capture.h"
#include "common/Failure.h"
#include "scene/build/SceneBuilder.h"
#include "scene/file/SceneFile.h"

#include <vtkCallbackCommand.h>
#include <vtkGITechnique.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorObserver.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <iostream>
#include <optional>

using namespace penumbra::tool;

namespace
{
// Limit of the sliders in texels. Larger biases detach shadows from their casters in every scene.
constexpr double MaximumBias = 5;

class Laboratory
{
public:
  Laboratory(vtkRenderWindow* window, vtkRenderer* renderer, vtkRenderWindowInteractor* interactor,
    const TechniqueSettings& settings)
    : Window(window)
    , Interactor(interactor)
    , Bench(window, renderer, settings)
  {
    this->Label->GetTextProperty()->SetFontSize(18);
    this->Label->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
    this->Label->GetTextProperty()->SetBackgroundColor(1, 1, 1);
    this->Label->GetTextProperty()->SetBackgroundOpacity(0.75);
    this->Label->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    this->Label->SetPosition(0.02, 0.84);
    renderer->AddViewProp(this->Label);
    const std::vector<std::string> kinds = BiasKinds(this->Bench.Maps());
    for (std::size_t i = 0; i < kinds.size(); ++i)
    {
      this->AddSlider(kinds[i] + "-bias", double(i) / kinds.size(), double(i + 1) / kinds.size());
    }
    this->CameraMoved->SetClientData(this);
    this->CameraMoved->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      static_cast<Laboratory*>(self)->MeasureView();
    });
    interactor->GetInteractorStyle()->AddObserver(
      vtkCommand::EndInteractionEvent, this->CameraMoved);
    this->MeasureView();
  }

  /// Measure from the current camera position: the true shadows first, then the map's errors.
  void MeasureView()
  {
    try
    {
      this->Hide(true);
      if (!this->Fitted)
      {
        FitResolution(this->Bench);
        this->Fitted = true;
      }
      this->Judge.emplace(JudgeShadows(this->Bench));
      this->Measure();
    }
    catch (const Failure& failure)
    {
      this->Judge.reset();
      this->ShowText(failure.what());
    }
  }

private:
  struct Slider
  {
    vtkSmartPointer<vtkSliderWidget> Widget;
    vtkSmartPointer<vtkCallbackCommand> Changed;
    std::string Parameter;
  };

  void AddSlider(const std::string& parameter, double left, double right)
  {
    vtkNew<vtkSliderRepresentation2D> representation;
    representation->SetMinimumValue(0);
    representation->SetMaximumValue(MaximumBias);
    representation->SetValue(this->Bench.Maps()->GetParameter(parameter.c_str()));
    representation->SetTitleText((parameter + ", texels").c_str());
    representation->SetLabelFormat("%.2f");
    representation->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    representation->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    representation->GetPoint1Coordinate()->SetValue(left + 0.03, 0.1);
    representation->GetPoint2Coordinate()->SetValue(right - 0.03, 0.1);
    for (vtkTextProperty* text :
      { representation->GetTitleProperty(), representation->GetLabelProperty() })
    {
      text->SetColor(0.1, 0.1, 0.1);
      text->ShadowOff();
      text->BoldOff();
    }
    representation->GetTubeProperty()->SetColor(0.5, 0.5, 0.5);
    Slider slider{ vtkSmartPointer<vtkSliderWidget>::New(),
      vtkSmartPointer<vtkCallbackCommand>::New(), parameter };
    slider.Widget->SetInteractor(this->Interactor);
    slider.Widget->SetRepresentation(representation);
    slider.Widget->EnabledOn();
    slider.Changed->SetClientData(this);
    slider.Changed->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      static_cast<Laboratory*>(self)->Measure();
    });
    slider.Widget->AddObserver(vtkCommand::InteractionEvent, slider.Changed);
    this->Sliders.push_back(slider);
  }

  void Measure()
  {
    if (!this->Judge)
    {
      return;
    }
    for (const Slider& slider : this->Sliders)
    {
      this->Bench.Maps()->SetParameter(
        slider.Parameter.c_str(), slider.Widget->GetSliderRepresentation()->GetValue());
    }
    this->Hide(true);
    const BiasErrors errors = this->Judge->Measure(this->Bench.DrawMask());
    const BiasLimits limits;
    this->ShowText(fmt::format("acne {}{}\ngap {:.2f} texels{}\nmap of {:g} texels a side",
      FormatPercent(errors.Acne), errors.Acne > limits.Acne ? ": too much" : "", errors.Gap(),
      errors.Gap() > limits.Gap ? ": too wide" : "",
      this->Bench.Maps()->GetParameter("resolution")));
  }

  void ShowText(const std::string& text)
  {
    this->Label->SetInput(text.c_str());
    this->Hide(false);
    this->Window->Render();
  }

  /// Hide sliders and text, which would write to the depth that positions are read from.
  void Hide(bool hidden)
  {
    hidden ? this->Window->SwapBuffersOff() : this->Window->SwapBuffersOn();
    this->Label->SetVisibility(!hidden);
    for (const Slider& slider : this->Sliders)
    {
      slider.Widget->GetRepresentation()->SetVisibility(!hidden);
    }
  }

  vtkRenderWindow* Window;
  vtkRenderWindowInteractor* Interactor;
  ShadowBench Bench;
  std::optional<BiasJudge> Judge; ///< none if the light reaches nothing in view
  bool Fitted = false;            ///< the map's resolution was fitted to the first view
  std::vector<Slider> Sliders;
  vtkNew<vtkTextActor> Label;
  vtkNew<vtkCallbackCommand> CameraMoved;
};

int Run(const char* sceneFile, const char* picture)
{
  const Scene scene = ReadSceneFile(sceneFile);
  Reporter silent;
  const BuiltScene built = BuildScene(scene, {}, silent);
  vtkNew<vtkRenderWindow> window;
  ConfigureWindow(scene, built, window);
  window->SetMultiSamples(0); // a mask has one value per pixel
  window->SetWindowName("Bias laboratory");
  vtkSmartPointer<vtkRenderWindowInteractor> interactor;
  if (picture)
  {
    window->SetOffScreenRendering(1);
    interactor = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
  }
  else
  {
    interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
  }
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  window->Render();
  Laboratory laboratory(window, built.Renderer, interactor, scene.Techniques);
  if (picture)
  {
    WritePicture(picture, CaptureWindow(window, false));
    return EXIT_SUCCESS;
  }
  interactor->Start();
  return EXIT_SUCCESS;
}
}

int main(int argc, char* argv[])
{
  const bool headless = argc == 4 && std::string(argv[2]) == "--headless";
  if (argc != 2 && !headless)
  {
    std::cerr << "usage: bias_laboratory SCENE.json [--headless OUT.png]\n";
    return 2;
  }
  try
  {
    return Run(argv[1], headless ? argv[3] : nullptr);
  }
  catch (const Failure& failure)
  {
    std::cerr << "bias_laboratory: " << failure.what() << '\n';
    return failure.GetExitStatus();
  }
}
