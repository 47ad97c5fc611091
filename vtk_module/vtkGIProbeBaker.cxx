// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIProbeBaker.h"

#include "vtkGILightGatherer.h"

#include "private/BakedScene.h"
#include "private/GatherStage.h"
#include "private/ProbePlacement.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <stdexcept>

vtkStandardNewMacro(vtkGIProbeBaker);

using namespace penumbra;

namespace
{
constexpr int MostProbes = 1 << 20;
constexpr int BrightnessSamples = 32; // to tell a lit place from one that is not

std::string SceneText(vtkRenderer* renderer)
{
  BakedSceneCache cache;
  return BakedScene::Of(renderer, cache).ToText();
}

void RequireSameScene(const ProbeField& field, vtkRenderer* renderer)
{
  BakedSceneCache cache;
  const BakedScene now = BakedScene::Of(renderer, cache);
  if (now.ToText() != field.Scene)
  {
    const std::string difference = BakedScene::FromText(field.Scene).DifferenceTo(now);
    throw std::invalid_argument("the probes were placed in another scene: " +
      (difference.empty() ? std::string("a prop came") : difference));
  }
}
}

struct vtkGIProbeBaker::Internals
{
  vtkNew<vtkGILightGatherer> Gatherer;
  std::string Error;

  /// Light at points, by the gatherer's settings; empty where it was ended. Throws where it failed.
  bool Gather(vtkRenderer* renderer, const std::vector<glm::dvec3>& points, vtkFloatArray* light)
  {
    vtkNew<vtkDoubleArray> places;
    places->SetNumberOfComponents(3);
    for (const glm::dvec3& point : points)
    {
      places->InsertNextTuple3(point.x, point.y, point.z);
    }
    const bool done = this->Gatherer->Gather(renderer, places, nullptr, light);
    if (!done && this->Gatherer->GetLastError()[0] != '\0')
    {
      throw std::runtime_error(this->Gatherer->GetLastError());
    }
    return done;
  }

  template <typename Work>
  bool Try(const Work& work)
  {
    this->Error.clear();
    try
    {
      return work();
    }
    catch (const std::exception& error)
    {
      this->Error = error.what();
    }
    return false;
  }
};

vtkGIProbeBaker::vtkGIProbeBaker()
  : Impl(new Internals)
{
}

vtkGIProbeBaker::~vtkGIProbeBaker() = default;

void vtkGIProbeBaker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Probes: " << this->Probes << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Adaptive: " << this->Adaptive << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "Bounces: " << this->Bounces << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}

bool vtkGIProbeBaker::Tell(double progress)
{
  this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  return !this->Abort;
}

bool vtkGIProbeBaker::Place(vtkRenderer* renderer, vtkImageData* image)
{
  this->Abort = false;
  return this->Impl->Try([&] {
    GatherStage stage;
    stage.Prepare(renderer);
    std::array<double, 6> bounds{};
    renderer->ComputeVisiblePropBounds(bounds.data());
    if (!image || bounds[0] > bounds[1])
    {
      throw std::runtime_error(image ? "there is nothing visible to put probes around."
                                     : "there is no image to put the probes into.");
    }
    const ProbeGrid grid = this->Spacing > 0.0
      ? ProbeGrid::Spaced(bounds, this->Spacing, MostProbes)
      : ProbeGrid::Around(bounds, this->Probes);
    if (grid.IsEmpty())
    {
      throw std::runtime_error("a spacing that small would take over a million probes.");
    }
    ProbeField field(grid);
    field.Scene = SceneText(renderer);
    const auto brightness = [&](const std::vector<glm::dvec3>& points) {
      vtkGILightGatherer* gatherer = this->Impl->Gatherer;
      gatherer->SetSamples(BrightnessSamples);
      gatherer->SetFirstSample(0);
      gatherer->SetBounces(this->Bounces);
      gatherer->SetSeed(this->Seed);
      vtkNew<vtkFloatArray> light;
      std::vector<double> sums;
      const bool done = this->Impl->Gather(renderer, points, light);
      for (std::size_t i = 0; done && i < points.size(); ++i)
      {
        const double* first = light->GetTuple(static_cast<vtkIdType>(i));
        sums.push_back(first[0] + first[1] + first[2]);
      }
      renderer->GetRenderWindow()->MakeCurrent();
      return sums;
    };
    constexpr double placing = 0.5; // of the work, roughly
    bool done = !this->Adaptive || PlaceProbes(stage, field, brightness, [&](double part) {
      return this->Tell(placing * part);
    });
    done = done && LookAround(stage, field, [&](double part) {
      return this->Tell(placing + (1.0 - placing) * part);
    });
    if (done)
    {
      field.ToImage(image, false);
    }
    return done;
  });
}

bool vtkGIProbeBaker::AddSamples(vtkRenderer* renderer, vtkImageData* image, int samples)
{
  this->Abort = false;
  return this->Impl->Try([&] {
    ProbeField field = ProbeField::FromImage(image);
    vtkGILightGatherer* gatherer = this->Impl->Gatherer;
    gatherer->SetSamples(samples);
    gatherer->SetFirstSample(field.Samples);
    gatherer->SetBounces(this->Bounces);
    gatherer->SetSeed(this->Seed);
    if (!renderer)
    {
      throw std::runtime_error("there is no renderer to gather light in.");
    }
    RequireSameScene(field, renderer);
    std::vector<glm::dvec3> points;
    for (int probe = 0; probe < field.Grid.Size(); ++probe)
    {
      points.push_back(field.Position(probe));
    }
    const unsigned long watch =
      gatherer->AddObserver(vtkCommand::ProgressEvent, this, &vtkGIProbeBaker::Forward);
    vtkNew<vtkFloatArray> light;
    const bool done = this->Impl->Gather(renderer, points, light);
    gatherer->RemoveObserver(watch);
    if (!done)
    {
      return false;
    }
    const double share = static_cast<double>(gatherer->GetSamples()) /
      (static_cast<double>(field.Samples) + gatherer->GetSamples());
    const float* found = light->GetPointer(0);
    for (std::size_t i = 0; i < field.Light.size(); ++i)
    {
      field.Light[i] = static_cast<float>((1.0 - share) * field.Light[i] + share * found[i]);
    }
    field.Samples += gatherer->GetSamples();
    field.ToImage(image, false);
    return true;
  });
}

void vtkGIProbeBaker::Forward(vtkObject*, unsigned long, void* progress)
{
  if (!this->Tell(*static_cast<double*>(progress)))
  {
    this->Impl->Gatherer->AbortOn();
  }
}

bool vtkGIProbeBaker::Bake(vtkRenderer* renderer, vtkImageData* image)
{
  vtkNew<vtkImageData> field;
  const bool done = this->Place(renderer, field) &&
    this->AddSamples(renderer, field, this->Samples) && this->Compact(field, field);
  if (done && image)
  {
    image->ShallowCopy(field);
  }
  return done && image;
}

bool vtkGIProbeBaker::Compact(vtkImageData* field, vtkImageData* compact)
{
  return this->Impl->Try([&] {
    ProbeField::FromImage(field).ToImage(compact, true);
    return true;
  });
}

int vtkGIProbeBaker::CountSamples(vtkImageData* field)
{
  int samples = -1;
  this->Impl->Try([&] {
    samples = ProbeField::FromImage(field).Samples;
    return true;
  });
  return samples;
}

int vtkGIProbeBaker::GetNumberOfLampsLeftOut()
{
  return this->Impl->Gatherer->GetNumberOfLampsLeftOut();
}

int vtkGIProbeBaker::GetNumberOfPropsLeftOut()
{
  return this->Impl->Gatherer->GetNumberOfPropsLeftOut();
}

const char* vtkGIProbeBaker::GetLastError()
{
  return this->Impl->Error.c_str();
}

void vtkGIProbeBaker::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->Gatherer->ReleaseGraphicsResources(window);
}
