// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Base of render-pass hooks that change the shaders of VTK's mappers and draw nothing themselves.
 */
#pragma once

#include "gpu/ShaderLibrary.h"

#include "vtkOpenGLRenderPass.h"

#include <string>

namespace penumbra
{
inline bool Contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

/// Texts of a mapper's shaders, to be changed.
struct ShaderTexts
{
  std::string& Vertex;
  std::string& Geometry;
  std::string& Fragment;
};

/// Change a mapper's finished shaders to pass the inputs of capture/facet.glsl. Returns the variant of it to use.
Defines PassShape(const ShaderTexts& texts, const ShaderLibrary& shaders);

/// Variant of glsl/capture/surrounding.glsl and glsl/forward/pbr.glsl for a shader of VTK's: GI_LOBE_KNOWN if it
/// reflects the environment by the lobe's reflectance alone, GI_SCATTERS if it adds multiple scattering, as VTK does since
/// 9.6.1.
Defines SurroundingVariant(const std::string& fragment);
}

class vtkGIShaderHooks : public vtkOpenGLRenderPass
{
public:
  vtkAbstractTypeMacro(vtkGIShaderHooks, vtkOpenGLRenderPass);

  /// Have mappers rebuild their shaders.
  void RebuildShaders()
  {
    this->Modified();
    this->StageTime = this->GetMTime();
  }

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop) override
  {
    this->BeforeMapper({ vertex, geometry, fragment }, mapper, prop);
    return true;
  }
  bool PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper*, vtkProp* prop) override
  {
    this->AfterMapper({ vertex, geometry, fragment }, prop);
    return true;
  }
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* = nullptr) override
  {
    this->SetUniforms(program, mapper, prop);
    return true;
  }
  vtkMTimeType GetShaderStageMTime() override { return this->StageTime; }

protected:
  vtkGIShaderHooks() = default;
  ~vtkGIShaderHooks() override = default;

  /// Called before and after the mapper's own replacements in its template.
  virtual void BeforeMapper(
    const penumbra::ShaderTexts& texts, vtkAbstractMapper* mapper, vtkProp* prop) = 0;
  virtual void AfterMapper(const penumbra::ShaderTexts& texts, vtkProp* prop) = 0;
  /// Called at each draw, with the program in use.
  virtual void SetUniforms(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop) = 0;

private:
  vtkGIShaderHooks(const vtkGIShaderHooks&) = delete;
  void operator=(const vtkGIShaderHooks&) = delete;

  vtkMTimeType StageTime = 1;
};
