// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGITechnique
 * @brief   base class of techniques, each of which computes a term of the rendering equation
 *
 * A technique states which term it computes, by which method, and whether it supports dynamic scenes. It adds passes to
 * a frame and declares what they read and write. vtkGIPass orders the passes by these declarations, and knows no
 * technique by name.
 *
 * Parameters are declared once, in vtk_module/techniques/<name>/<Name>.json, from which the typed accessors of each
 * subclass and the table behind SetParameter() are generated.
 *
 * @sa vtkGIPass
 */
#ifndef vtkGITechnique_h
#define vtkGITechnique_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

#include <vector> // for the parameter table

namespace penumbra
{
class Arguments;
class FrameBuilder;
class LightingPlan;
class TechniqueKnob;
class ViewDirectory;
struct BudgetInfo;
struct ParameterInfo;
struct PresetValue;
}
class vtkImageData;
class vtkRenderer;
class vtkWindow;

class VTKRENDERINGGI_EXPORT vtkGITechnique : public vtkObject
{
public:
  vtkTypeMacro(vtkGITechnique, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the technique takes part in a frame. Off by default.
   */
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  ///@{
  /**
   * The description of the technique: the name used in scripts and on the command line ("shadow-maps"), a title for
   * people, what it computes (GetTerm()), its method (GetVerb()), how it keeps a frame cheap (GetApproach():
   * "precompute", "approximate" or "amortise"; "none" if it computes no term of light), whether it supports dynamic
   * scenes, and its source in the literature.
   */
  virtual const char* GetName() = 0;
  virtual const char* GetTitle() = 0;
  virtual const char* GetTerm() = 0;
  virtual const char* GetVerb() = 0;
  virtual const char* GetApproach() = 0;
  virtual const char* GetDynamic() = 0;
  virtual const char* GetSource() = 0;
  ///@}

  ///@{
  /**
   * The parameters, by index: name ("slope-bias"), type ("bool", "int", "double" or "enum"), unit,
   * one line of documentation, default, range (inclusive), and the values of an enum.
   * An index out of range gives nullptr or 0.
   */
  int GetNumberOfParameters();
  const char* GetParameterName(int index);
  const char* GetParameterType(int index);
  const char* GetParameterUnit(int index);
  const char* GetParameterDocumentation(int index);
  double GetParameterDefault(int index);
  double GetParameterMinimum(int index);
  double GetParameterMaximum(int index);
  int GetNumberOfParameterValues(int index);
  const char* GetParameterValueName(int index, int value);
  ///@}

  ///@{
  /**
   * Set or get a parameter by name. Setting fails, with an error that names the parameter and the
   * remedy, if the technique has no such parameter or the value is outside its range. The typed
   * setters (SetSlopeBias...) clamp instead, as VTK's do.
   */
  bool SetParameter(const char* name, double value);
  bool SetParameterFromText(const char* name, const char* text);
  double GetParameter(const char* name);
  ///@}

  /**
   * The error of the last SetParameter(), SetParameterFromText() or GetParameter(), or "" if it succeeded.
   */
  vtkGetStringMacro(LastError);

  ///@{
  /**
   * Set every parameter to its default or to the value of a preset ("off", "fast", "balanced", "high", "reference").
   * A preset also switches the technique on or off. Returns false for an unknown preset.
   */
  void SetDefaults();
  bool ApplyPreset(const char* preset);
  ///@}

  ///@{
  /**
   * The name of a resource of the frame graph that this technique writes and that only one technique may write in a
   * frame; nullptr for none. If several enabled techniques offer the same resource, the one with the highest rank takes
   * part, or the first by name if ranks are equal; a note names the others. The rank tells what a technique sees: 0 the
   * screen, 1 maps, 2 everything that rays find.
   */
  virtual const char* GetOfferedResource() { return nullptr; }
  virtual int GetRank() { return 0; }
  ///@}

  ///@{
  /**
   * Light that was baked beforehand. SetBake() copies a bake, fresh or read from a file by vtkGIBakeFile; nullptr
   * removes it. Where the image is no bake for this technique, SetBake() returns false, keeps the former bake, and
   * GetBakeError() gives the reason. GetBakeFormat() is how the text "format" in the field data of its bakes begins,
   * or nullptr for a technique without bakes.
   */
  virtual const char* GetBakeFormat() { return nullptr; }
  virtual bool SetBake(vtkImageData*) { return false; }
  virtual const char* GetBakeError() { return "the technique takes no baked light"; }
  ///@}

  /**
   * Tell the plan how the technique will light a frame that it takes part in. Called for all techniques before any
   * contributes.
   */
  virtual void Plan(penumbra::LightingPlan&, penumbra::FrameBuilder&) {}

  /**
   * Whether the technique takes part in a frame although it is not enabled, in place of others that cannot supply
   * their light.
   */
  virtual bool StandsIn(const penumbra::LightingPlan&) { return false; }

  ///@{
  /**
   * Whether the technique took part in the last frame of its pass, enabled or standing in. Set by the pass, without a
   * modified event.
   */
  void SetTookPart(bool yes) { this->TookPart = yes; }
  vtkGetMacro(TookPart, bool);
  ///@}

  /**
   * Whether the technique changes how surfaces are lit. If none does, the picture is VTK's own.
   */
  virtual bool ChangesLight() { return true; }

  /**
   * The parameters as uniforms for the technique's shaders, with their names in camel case ("slopeBias"), and enums as
   * numbers.
   */
  penumbra::Arguments GetShaderParameters();

  /**
   * Add the technique's passes to a frame, and declare what they read and write.
   */
  virtual void Contribute(penumbra::FrameBuilder& frame) = 0;

  /**
   * Number of frames of a still scene that the picture needs; 1 if every frame is complete.
   */
  virtual int GetRequiredFrames() { return 1; }

  /**
   * Whether further frames of a still scene would not change a renderer's picture, or only by less than the requested
   * error.
   */
  virtual bool IsFinished(vtkRenderer*) { return true; }

  /**
   * The directory where the technique finds its state of a view between frames. Set by the pass.
   */
  void SetViews(const penumbra::ViewDirectory* views) { this->Views = views; }

  /**
   * Free the technique's GPU resources outside the frame graph's pool.
   */
  virtual void ReleaseGraphicsResources(vtkWindow*) {}

protected:
  vtkGITechnique();
  ~vtkGITechnique() override;

  virtual const std::vector<penumbra::ParameterInfo>& ParameterTable() = 0;
  virtual const std::vector<penumbra::PresetValue>& PresetTable() = 0;
  virtual const penumbra::BudgetInfo* BudgetTable() { return nullptr; }

  const penumbra::ViewDirectory* Views = nullptr;
  bool Enabled = false;
  bool TookPart = false;
  char* LastError = nullptr;
  vtkSetStringMacro(LastError);

private:
  friend class penumbra::TechniqueKnob;
  const penumbra::ParameterInfo* FindParameter(const char* name);

  vtkGITechnique(const vtkGITechnique&) = delete;
  void operator=(const vtkGITechnique&) = delete;
};

#endif
