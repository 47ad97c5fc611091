// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGIProbeBaker.h"

#include "vtkGILightGatherer.h"

#include "bake/BakedScene.h"
#include "bake/GatherStage.h"
#include "techniques/sh_probes/AdaptivePlacement.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <stdexcept>

vtkStandardNewMacro(vtkGIProbeBaker);

using namespace penumbra;

namespace
{
void RequireImage(vtkImageData* image)
{
  if (!image)
  {
    throw std::runtime_error("there is no image to put the probes into.");
  }
}

std::string SceneText(vtkRenderer* renderer)
{
  BakedSceneCache cache;
  return BakedScene::Of(renderer, cache).ToText();
}

void RequireSameScene(const ProbeField& field, vtkRenderer* renderer)
{
  BakedSceneCache cache;
  const BakedScene current = BakedScene::Of(renderer, cache);
  if (current.ToText() != field.Scene)
  {
    const std::string difference = BakedScene::FromText(field.Scene).DifferenceTo(current);
    throw std::invalid_argument("the probes were placed in another scene: " +
      (difference.empty() ? std::string("a prop came") : difference));
  }
}
}

struct vtkGIProbeBaker::Internals
{
  static vtkSmartPointer<vtkDoubleArray> Vectors(const std::vector<glm::dvec3>& vectors)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetNumberOfComponents(3);
    for (const glm::dvec3& vector : vectors)
    {
      array->InsertNextTuple3(vector.x, vector.y, vector.z);
    }
    return array;
  }
  static std::vector<float> Numbers(vtkFloatArray* array)
  {
    return { array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues() };
  }

  vtkNew<vtkGILightGatherer> Gatherer;
  std::string Error;
  TriedGrids Tried;
  /// Range of a call's progress that the gatherer's progress covers.
  double GatherBegin = 0.0;
  double GatherEnd = 1.0;
  /// Range of Bake()'s progress that a call covers.
  double CallBegin = 0.0;
  double CallEnd = 1.0;

  /// Gather light at points, with normals or without (empty). The result is empty if aborted. Throws if it failed.
  std::vector<float> Gather(vtkRenderer* renderer, const vtkGIProbeBaker& settings,
    const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& normals, int firstSample,
    int samples, std::vector<float>* surroundings)
  {
    this->Gatherer->SetSamples(samples);
    this->Gatherer->SetFirstSample(firstSample);
    this->Gatherer->SetBounces(settings.Bounces);
    this->Gatherer->SetSeed(settings.Seed);
    this->Gatherer->SetMaximumAlbedo(settings.MaximumAlbedo);
    this->Gatherer->SetEnergyCompensation(settings.EnergyCompensation);
    const auto places = Vectors(points);
    const auto directions = Vectors(normals);
    vtkNew<vtkFloatArray> light;
    vtkNew<vtkFloatArray> around;
    const bool done = this->Gatherer->Gather(renderer, places,
      normals.empty() ? nullptr : directions.Get(), light, surroundings ? around.Get() : nullptr);
    if (!done && this->Gatherer->GetLastError()[0] != '\0')
    {
      throw std::runtime_error(this->Gatherer->GetLastError());
    }
    renderer->GetRenderWindow()->MakeCurrent();
    if (surroundings)
    {
      *surroundings = Numbers(around);
    }
    return done ? Numbers(light) : std::vector<float>();
  }

  template <typename Function>
  bool CatchErrors(const Function& function)
  {
    this->Error.clear();
    try
    {
      return function();
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
  this->Impl->Gatherer->AddObserver(
    vtkCommand::ProgressEvent, this, &vtkGIProbeBaker::ForwardProgress);
}

vtkGIProbeBaker::~vtkGIProbeBaker() = default;

void vtkGIProbeBaker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Probes: " << this->Probes << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Adaptive: " << this->Adaptive << "\n";
  os << indent << "Relocate: " << this->Relocate << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "Bounces: " << this->Bounces << "\n";
  os << indent << "MaximumAlbedo: " << this->MaximumAlbedo << "\n";
  os << indent << "EnergyCompensation: " << this->EnergyCompensation << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}

bool vtkGIProbeBaker::ReportProgress(double progress)
{
  progress = this->Impl->CallBegin + (this->Impl->CallEnd - this->Impl->CallBegin) * progress;
  this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  return !this->Abort;
}

bool vtkGIProbeBaker::Place(vtkRenderer* renderer, vtkImageData* image)
{
  this->Abort = false;
  return this->Impl->CatchErrors([&] {
    this->Impl->Tried = {};
    RequireImage(image);
    GatherStage stage;
    stage.Prepare(renderer);
    std::array<double, 6> bounds{};
    renderer->ComputeVisiblePropBounds(bounds.data());
    if (bounds[0] > bounds[1])
    {
      throw std::runtime_error("there is nothing visible to put probes around.");
    }
    const AdaptivePlacement placement{ stage,
      [&](const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& normals, int first,
        int samples, std::vector<float>* surroundings) {
        return this->Impl->Gather(renderer, *this, points, normals, first, samples, surroundings);
      },
      [this](double done) {
        this->Impl->GatherBegin = this->Impl->GatherEnd = done;
        return this->ReportProgress(done);
      },
      this->Relocate };
    std::optional<ProbeField> field;
    if (this->Adaptive && this->Spacing <= 0.0)
    {
      field = placement.PlaceBest(bounds, this->Probes, this->Impl->Tried);
    }
    else
    {
      const ProbeGrid grid = this->Spacing > 0.0
        ? ProbeGrid::Spaced(bounds, this->Spacing, MostProbes)
        : ProbeGrid::Around(bounds, this->Probes);
      if (grid.IsEmpty())
      {
        throw std::runtime_error("a spacing that small would take more than " +
          std::to_string(MostProbes) + " probes, which is all that can be shown.");
      }
      field = placement.Place(grid);
    }
    if (field)
    {
      field->Scene = SceneText(renderer);
      field->ToImage(image, false);
    }
    return field.has_value();
  });
}

bool vtkGIProbeBaker::AddSamples(vtkRenderer* renderer, vtkImageData* image, int samples)
{
  this->Abort = false;
  return this->Impl->CatchErrors([&] {
    ProbeField field = ProbeField::FromImage(image);
    if (!renderer)
    {
      throw std::runtime_error("there is no renderer to gather light in.");
    }
    RequireSameScene(field, renderer);
    vtkGILightGatherer* gatherer = this->Impl->Gatherer;
    this->Impl->GatherBegin = 0.0;
    this->Impl->GatherEnd = 1.0;
    const std::vector<float> found = this->Impl->Gather(
      renderer, *this, field.Positions(0, field.Grids.Size()), {}, field.Samples, samples, nullptr);
    if (found.empty())
    {
      return false;
    }
    const double share = static_cast<double>(gatherer->GetSamples()) /
      (static_cast<double>(field.Samples) + gatherer->GetSamples());
    for (std::size_t i = 0; i < field.Light.size(); ++i)
    {
      field.Light[i] = static_cast<float>((1.0 - share) * field.Light[i] + share * found[i]);
    }
    field.Samples += gatherer->GetSamples();
    field.ToImage(image, false);
    return true;
  });
}

void vtkGIProbeBaker::ForwardProgress(vtkObject*, unsigned long, void* progress)
{
  const double done = *static_cast<double*>(progress);
  if (!this->ReportProgress(
        this->Impl->GatherBegin + (this->Impl->GatherEnd - this->Impl->GatherBegin) * done))
  {
    this->Impl->Gatherer->AbortOn();
  }
}

bool vtkGIProbeBaker::Bake(vtkRenderer* renderer, vtkImageData* image)
{
  const auto setRange = [this](double begin, double end) {
    this->Impl->CallBegin = begin;
    this->Impl->CallEnd = end;
  };
  const bool hasImage = this->Impl->CatchErrors([image] {
    RequireImage(image);
    return true;
  });
  vtkNew<vtkImageData> field;
  setRange(0.0, this->Adaptive ? 0.5 : 0.2);
  bool done = hasImage && this->Place(renderer, field);
  setRange(this->Impl->CallEnd, 1.0);
  done = done && this->AddSamples(renderer, field, this->Samples) && this->Compact(field, field);
  setRange(0.0, 1.0);
  if (done)
  {
    image->ShallowCopy(field);
  }
  return done;
}

bool vtkGIProbeBaker::Compact(vtkImageData* field, vtkImageData* compact)
{
  return this->Impl->CatchErrors([&] {
    RequireImage(compact);
    ProbeField::FromImage(field).ToImage(compact, true);
    return true;
  });
}

bool vtkGIProbeBaker::Fits(vtkRenderer* renderer, vtkImageData* field)
{
  return this->Impl->CatchErrors([&] {
    if (!renderer)
    {
      throw std::runtime_error("there is no renderer to gather light in.");
    }
    RequireSameScene(ProbeField::FromImage(field), renderer);
    return true;
  });
}

int vtkGIProbeBaker::CountGrids(vtkImageData* field)
{
  int grids = 0;
  this->Impl->CatchErrors([&] {
    grids = ProbeField::FromImage(field).Grids.Count();
    return true;
  });
  return grids;
}

bool vtkGIProbeBaker::GetGrid(vtkImageData* field, int number, int counts[3], double bounds[6])
{
  return this->Impl->CatchErrors([&] {
    const ProbeGrids grids = ProbeField::FromImage(field).Grids;
    if (number < 0 || number >= grids.Count())
    {
      throw std::invalid_argument(
        "the field has no grid of number " + std::to_string(number) + ".");
    }
    const ProbeGrid& grid = grids.Get(number);
    const glm::dvec3 last = grid.Last();
    for (int axis = 0; axis < 3; ++axis)
    {
      counts[axis] = grid.Counts[axis];
      bounds[2 * axis] = grid.First[axis];
      bounds[2 * axis + 1] = last[axis];
    }
    return true;
  });
}

int vtkGIProbeBaker::GetNumberOfTriedGrids()
{
  return this->Impl->Tried.Count;
}

double vtkGIProbeBaker::GetErrorOfTriedGrids()
{
  return this->Impl->Tried.Error;
}

int vtkGIProbeBaker::CountSamples(vtkImageData* field)
{
  int samples = -1;
  this->Impl->CatchErrors([&] {
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
