// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGITechnique
 * @brief   one way of buying a term of the rendering equation
 *
 * A technique states which term it buys, by which verb (precompute, approximate, amortise), and
 * whether it follows a moving scene. It adds its work to a frame by declaring what it reads and
 * writes; vtkGIPass orders the techniques by these declarations and knows none of them by name.
 *
 * Its parameters are declared once, in vtk_module/parameters/<Name>.json, from which the typed
 * accessors of each subclass and the table behind SetParameter() are generated.
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
class ViewDirectory;
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
   * The row of the technique table: the name used in scripts and on the command line
   * ("shadow-maps"), a title for people, the term it buys, the verb it buys it by, whether it
   * follows a moving scene, and the publication it comes from.
   */
  virtual const char* GetName() = 0;
  virtual const char* GetTitle() = 0;
  virtual const char* GetTerm() = 0;
  virtual const char* GetVerb() = 0;
  virtual const char* GetDynamic() = 0;
  virtual const char* GetSource() = 0;
  ///@}

  ///@{
  /**
   * The parameters, by index: name ("slope-bias"), type ("bool", "int", "double" or "enum"), unit,
   * one line of documentation, default, range (bounds included), and for an enum its values.
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
   * remedy, where the technique has no such parameter or the value is outside its range; the
   * typed setters (SetSlopeBias...) clamp instead, as VTK's do.
   */
  bool SetParameter(const char* name, double value);
  bool SetParameterFromText(const char* name, const char* text);
  double GetParameter(const char* name);
  ///@}

  /**
   * The text of the last error of SetParameter() or SetParameterFromText(), or "" where the last
   * call succeeded.
   */
  vtkGetStringMacro(LastError);

  ///@{
  /**
   * Give every parameter its default, or the values of a preset ("off", "fast", "balanced",
   * "high"); a preset also switches the technique on or off. Returns false for an unknown preset.
   */
  void SetDefaults();
  bool ApplyPreset(const char* preset);
  ///@}

  ///@{
  /**
   * The resource, by its name in the frame graph, that this technique writes and only one may write in a frame;
   * nullptr for none. Of several that are enabled and offer the same, the one of the highest rank takes part, and of
   * equal rank the first by name; a note names those that stand back. Ranks rise with what a technique can see: 0 what
   * is on the screen, 1 what maps hold, 2 what rays find.
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
   * Say how the technique will light a frame that it takes part in. All of them are asked before any contributes.
   */
  virtual void Plan(penumbra::LightingPlan&, penumbra::FrameBuilder&) {}

  /**
   * Whether the technique takes part in a frame though it is not enabled, in place of others that know less than
   * they should.
   */
  virtual bool StandsIn(const penumbra::LightingPlan&) { return false; }

  ///@{
  /**
   * Whether the technique took part in the last frame of its pass, enabled or standing in. Set by the pass; no change
   * of the technique.
   */
  void SetTookPart(bool yes) { this->TookPart = yes; }
  vtkGetMacro(TookPart, bool);
  ///@}

  /**
   * Whether the technique changes how surfaces are lit. Where none does, the picture is VTK's own.
   */
  virtual bool ChangesLight() { return true; }

  /**
   * The parameters as the technique's shaders may have them: uniforms named like the parameters, in camel case
   * ("slopeBias"), enums by the number of their value.
   */
  penumbra::Arguments GetShaderParameters();

  /**
   * Add this technique's work to a frame: declare passes with what they read and write.
   */
  virtual void Contribute(penumbra::FrameBuilder& frame) = 0;

  /**
   * How many frames of a still scene the technique's picture needs; 1 where every frame is complete.
   */
  virtual int GetRequiredFrames() { return 1; }

  /**
   * Whether further frames of a renderer that stands still would change its picture no more, or by
   * less than was asked for.
   */
  virtual bool IsFinished(vtkRenderer*) { return true; }

  /**
   * Where the technique finds what it remembers of views, between frames. Set by the pass.
   */
  void SetViews(const penumbra::ViewDirectory* views) { this->Views = views; }

  /**
   * Free what the technique holds on the GPU outside the frame graph's pool.
   */
  virtual void ReleaseGraphicsResources(vtkWindow*) {}

protected:
  vtkGITechnique();
  ~vtkGITechnique() override;

  virtual const std::vector<penumbra::ParameterInfo>& ParameterTable() = 0;
  virtual const std::vector<penumbra::PresetValue>& PresetTable() = 0;

  const penumbra::ViewDirectory* Views = nullptr;
  bool Enabled = false;
  bool TookPart = false;
  char* LastError = nullptr;
  vtkSetStringMacro(LastError);

private:
  const penumbra::ParameterInfo* FindParameter(const char* name);

  vtkGITechnique(const vtkGITechnique&) = delete;
  void operator=(const vtkGITechnique&) = delete;
};

#endif
