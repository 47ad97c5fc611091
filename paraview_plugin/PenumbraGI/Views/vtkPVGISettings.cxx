// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVGISettings.h"

#include "BakedLight.h"
#include "FrameOverlay.h"
#include "StillFramesPass.h"
#include "ViewAccess.h"
#include "ViewLook.h"

#include "vtkGIPass.h"
#include "vtkGISHProbes.h"
#include "vtkGITechnique.h"

#include "vtkCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPVRenderView.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>

vtkStandardNewMacro(vtkPVGISettings);

class vtkPVGISettings::Internals
{
public:
  vtkNew<vtkGIPass> Pass;
  vtkNew<penumbra::StillFramesPass> Frames;
  penumbra::BakedLight Lightmap;
  penumbra::BakedLight Probes;
  penumbra::ViewLook Look;
  penumbra::FrameOverlay Overlay;
  vtkWeakPointer<vtkPVRenderView> View;
  unsigned long StartOfFrame = 0;
  unsigned long EndOfFrame = 0;
  bool Enabled = false;
  bool ShowsChart = false;
};

namespace
{
// Each of several processes draws its own part of the data and does not know the others' parts.
void WarnOfDistributedData()
{
  static bool warned = false;
  if (warned || penumbra::IsSingleProcess())
  {
    return;
  }
  warned = true;
  if (vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0)
  {
    vtkOutputWindow::GetInstance()->DisplayText(
      "Penumbra: the data are distributed over several processes; shadows, occlusion and indirect "
      "light stop at the boundaries between them for now.\n");
  }
}
}

vtkPVGISettings::vtkPVGISettings()
  : Impl(new Internals)
{
  this->Impl->Pass->SetPreset("balanced");
  this->Impl->Frames->SetPass(this->Impl->Pass);
}

vtkPVGISettings::~vtkPVGISettings()
{
  this->SetView(nullptr);
}

void vtkPVGISettings::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << this->Impl->Enabled << "\n";
  this->Impl->Pass->PrintSelf(os, indent.GetNextIndent());
}

vtkGIPass* vtkPVGISettings::GetPass()
{
  return this->Impl->Pass;
}

bool vtkPVGISettings::GetEnabled() const
{
  return this->Impl->Enabled;
}

void vtkPVGISettings::SetEnabled(bool enabled)
{
  this->Impl->Enabled = enabled;
  this->UpdateRenderPass();
}

void vtkPVGISettings::SetStillFrames(int frames)
{
  this->Impl->Frames->SetFrames(frames);
}

void vtkPVGISettings::SetFrameBudget(double milliseconds)
{
  // False for no number, too. The panel offers values that the pass does not have.
  const bool limited = milliseconds > 0.0;
  this->Impl->Pass->SetFrameBudget(limited ? std::clamp(milliseconds, 1.0, 10000.0) : 0.0);
}

void vtkPVGISettings::SetFrameChart(bool shown)
{
  this->Impl->ShowsChart = shown;
  this->UpdateRenderPass();
}

const char* vtkPVGISettings::GetStatistics()
{
  return this->Impl->Pass->GetStatistics();
}

void vtkPVGISettings::SetLook(const char* nameOrPath)
{
  this->Impl->Look.Choose(nameOrPath ? nameOrPath : "");
}

const char* vtkPVGISettings::GetLookProblem()
{
  return this->Impl->Look.GetProblem().c_str();
}

void vtkPVGISettings::SetLightmapFile(const char* path)
{
  this->Impl->Lightmap.SetFile(path ? path : "");
}

void vtkPVGISettings::SetSHProbesFile(const char* path)
{
  this->Impl->Probes.SetFile(path ? path : "");
}

void vtkPVGISettings::BakeProbes()
{
  vtkPVRenderView* view = this->Impl->View;
  if (!view)
  {
    return;
  }
  if (penumbra::IsSingleProcess() && !penumbra::IsConnected(view))
  {
    this->Impl->Probes.Bake(
      vtkGISHProbes::SafeDownCast(this->Impl->Pass->GetTechnique("sh-probes")), view->GetRenderer(),
      this->ProbesToBake, this->SamplesToBake);
  }
  // Each of several processes would bake its own part of the data only.
  else if (penumbra::IsClient(view))
  {
    this->Impl->Probes.Report("the probes cannot be baked by several processes: bake them in "
                              "pvpython without a server, and choose their file here");
  }
}

const char* vtkPVGISettings::GetLightmapProblem()
{
  return this->Impl->Lightmap.GetProblem().c_str();
}

const char* vtkPVGISettings::GetSHProbesProblem()
{
  return this->Impl->Probes.GetProblem().c_str();
}

bool vtkPVGISettings::AddToView(vtkView* view)
{
  this->SetView(vtkPVRenderView::SafeDownCast(view));
  return false; // the view keeps no reference
}

void vtkPVGISettings::SetView(vtkPVRenderView* view)
{
  if (view == this->Impl->View)
  {
    return;
  }
  if (this->Impl->View)
  {
    this->Impl->View->GetRenderer()->RemoveObserver(this->Impl->StartOfFrame);
    this->Impl->View->GetRenderer()->RemoveObserver(this->Impl->EndOfFrame);
    const bool enabled = this->Impl->Enabled;
    this->SetEnabled(false);
    this->Impl->Enabled = enabled;
  }
  this->Impl->View = view;
  this->Impl->Frames->SetView(view);
  if (view)
  {
    penumbra::PrepareWindow(view->GetRenderWindow());
    this->Impl->StartOfFrame =
      view->GetRenderer()->AddObserver(vtkCommand::StartEvent, this, &vtkPVGISettings::BeginFrame);
    this->Impl->EndOfFrame =
      view->GetRenderer()->AddObserver(vtkCommand::EndEvent, this, &vtkPVGISettings::UpdateChart);
    this->UpdateRenderPass();
  }
}

void vtkPVGISettings::BeginFrame()
{
  this->UpdateRenderPass();
  vtkPVRenderView* view = this->Impl->View;
  auto* synchronized = view ? penumbra::SynchronizedRendererOf(view) : nullptr;
  // Enabled only while all ranks draw one picture together. Other pictures are drawn by one process alone, which must not
  // wait for the others.
  if (synchronized && synchronized->GetEnabled() && !penumbra::IsSingleProcess() &&
    synchronized->GetRenderPass() == this->Impl->Frames.Get())
  {
    this->Impl->Frames->ShareBudget(view->GetRenderer());
  }
}

void vtkPVGISettings::UpdateRenderPass()
{
  vtkPVRenderView* view = this->Impl->View;
  if (!view)
  {
    return;
  }
  vtkPVSynchronizedRenderer* synchronized = penumbra::SynchronizedRendererOf(view);
  vtkRenderPass* current = synchronized->GetRenderPass();
  if (this->Impl->Enabled)
  {
    this->Impl->Lightmap.Update(this->Impl->Pass->GetTechnique("lightmap"));
    this->Impl->Probes.Update(this->Impl->Pass->GetTechnique("sh-probes"));
    this->Impl->Look.Update(view->GetRenderer(), this->Impl->Pass);
  }
  else
  {
    this->Impl->Look.Remove(view->GetRenderer());
  }
  if (this->Impl->Enabled && !current)
  {
    WarnOfDistributedData();
    synchronized->SetRenderPass(this->Impl->Frames);
  }
  else if (!this->Impl->Enabled && current == this->Impl->Frames)
  {
    synchronized->SetRenderPass(nullptr);
    this->Impl->Pass->ReleaseGraphicsResources(view->GetRenderWindow());
  }
  const bool chart =
    this->Impl->ShowsChart && synchronized->GetRenderPass() == this->Impl->Frames.Get();
  this->Impl->Pass->SetCollectStatistics(chart);
  this->Impl->Overlay.SetRenderer(chart ? view->GetNonCompositedRenderer() : nullptr);
}

// The renderer of the chart's layer comes after this one in the same picture.
void vtkPVGISettings::UpdateChart()
{
  vtkPVRenderView* view = this->Impl->View;
  if (view && !view->GetRenderer()->GetSelector())
  {
    // A client has no times of pictures that a server drew. A rank may have nothing to draw for a moment.
    const bool known = this->Impl->Frames->TakeRendered() || !penumbra::IsSingleProcess();
    // A saved picture shall not contain the machine's times.
    this->Impl->Overlay.Update(this->Impl->Pass, known && !penumbra::IsCaptured(view));
  }
}

void vtkPVGISettings::SetSetting(const char* property, double value)
{
  for (const Row& row : Table())
  {
    if (std::strcmp(row.Property, property) != 0)
    {
      continue;
    }
    if (this->Impl->View)
    {
      this->Impl->Look.Remove(this->Impl->View->GetRenderer());
    }
    vtkGITechnique* technique = this->Impl->Pass->GetTechnique(row.Technique);
    if (row.Parameter)
    {
      technique->SetParameter(row.Parameter, value);
    }
    else
    {
      technique->SetEnabled(value != 0.0);
    }
    return;
  }
}
