// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capture/CaptureHooks.h"

#include "base/Matrices.h"
#include "capture/MaterialTable.h"
#include "capture/MotionTable.h"
#include "capture/PropTraits.h"
#include "gpu/ShaderLibrary.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <regex>

vtkStandardNewMacro(vtkGICaptureHooks);

using penumbra::Contains;

namespace
{
// VTK's template is filled in the order Color, Edges, Normal, Light, TCoord. A texture multiplies
// the lit colour at TCoord, so the capture comes after TCoord.
const char* const Marker = "//PENUMBRA::Capture";
const char* const ColorMarker = "//PENUMBRA::Color";   // before VTK's code for the light
const char* const NormalMarker = "//PENUMBRA::Normal"; // after VTK's code for the normal

// Impostors compute the position of each pixel, and their normal is the surface's own. VTK's template mentions the
// variable in a comment, and for coincident topology it adds an offset to the rasterized depth; neither counts.
bool WritesFragmentDepth(const std::string& fragment)
{
  static const std::regex assigned("gl_FragDepth\\s*=(?!\\s*gl_Frag)");
  return std::regex_search(fragment, assigned);
}
}

penumbra::Defines penumbra::SurroundingVariant(const std::string& fragment)
{
  const bool known = Contains(fragment, "iblSpecular = prefilteredSpecularColor * specularBrdf;") &&
    Contains(fragment, "vec2 brdf = texture(");
  return known                     ? Defines{ { "GI_LOBE_KNOWN", "1" } }
    : Contains(fragment, "FmsEms") ? Defines{ { "GI_SCATTERS", "1" } }
                                   : Defines();
}

penumbra::Defines penumbra::PassShape(const ShaderTexts& texts, const ShaderLibrary& shaders)
{
  if (!Contains(texts.Fragment, "vertexVC") || WritesFragmentDepth(texts.Fragment))
  {
    return {};
  }
  // With a geometry shader, VTK replaces VSOut by GSOut in the fragment shader's names.
  const std::string normal = " vec3 normalVCVSOutput;\n";
  const std::string round = " vec4 giRoundVSOutput;\n";
  const std::string declared = "out vec3 normalVCGSOutput;\n";
  const std::string passed = "normalVCGSOutput = normalVCVSOutput[i];";
  const std::size_t end = texts.Vertex.rfind('}');
  const bool replaceable = texts.Geometry.empty() ||
    (Contains(texts.Geometry, declared.c_str()) && Contains(texts.Geometry, passed.c_str()));
  if (!replaceable || !Contains(texts.Vertex, "vertexVCVSOutput =") ||
    !Contains(texts.Vertex, ("out" + normal).c_str()) ||
    !Contains(texts.Fragment, ("in" + normal).c_str()))
  {
    return { { "GI_FLAT", "1" } };
  }
  texts.Vertex.insert(end, shaders.Source("capture/round.glsl"));
  vtkShaderProgram::Substitute(texts.Vertex, "out" + normal, "out" + normal + "out" + round);
  vtkShaderProgram::Substitute(
    texts.Geometry, declared, declared + "in vec4 giRoundVSOutput[];\nout vec4 giRoundGSOutput;\n");
  vtkShaderProgram::Substitute(
    texts.Geometry, passed, passed + "\ngiRoundGSOutput = giRoundVSOutput[i];");
  vtkShaderProgram::Substitute(texts.Fragment, "in" + normal, "in" + normal + "in" + round);
  return { { "GI_FLAT", "1" }, { "GI_ROUND", "1" } };
}

void vtkGICaptureHooks::SetTables(
  penumbra::MaterialTable* materials, const penumbra::ShaderLibrary* shaders)
{
  this->Materials = materials;
  this->Shaders = shaders;
}

void vtkGICaptureHooks::SetOutputs(const penumbra::CaptureOutputs& outputs)
{
  if (!(this->Outputs == outputs))
  {
    this->Outputs = outputs;
    this->RebuildShaders();
  }
}

std::string vtkGICaptureHooks::Snippet(
  const char* name, const penumbra::CaptureOutputs& outputs, penumbra::Defines variant) const
{
  variant.merge(outputs.SnippetDefines());
  std::string text = this->Shaders->Source(std::string("capture/") + name, variant);
  outputs.NumberTargets(text);
  return text;
}

void vtkGICaptureHooks::CheckSnippets() const
{
  penumbra::CaptureOutputs all;
  all.Extended = true;
  for (const auto& optional : penumbra::CaptureOutputs::All)
  {
    all.Request(optional.Resource);
  }
  for (const char* name : { "phong.glsl", "pbr.glsl", "as_drawn.glsl" })
  {
    std::string text = this->Shaders->Source("capture/check.frag", all.SnippetDefines());
    vtkShaderProgram::Substitute(text, Marker, this->Snippet(name, all), false);
    // Declare outputs as VTK does.
    std::string outputs;
    for (std::size_t i = 0; i < all.Resources().size(); ++i)
    {
      const std::string number = std::to_string(i);
      vtkShaderProgram::Substitute(text, "gl_FragData[" + number + "]", "fragOutput" + number);
      outputs += "out vec4 fragOutput" + number + ";\n";
    }
    text.insert(text.find('\n', text.find("#version")) + 1, outputs);
    this->Shaders->Check(std::string("capture/") + name, GL_FRAGMENT_SHADER, text);
  }
}

void vtkGICaptureHooks::BeforeMapper(
  const penumbra::ShaderTexts& texts, vtkAbstractMapper* mapper, vtkProp*)
{
  penumbra::Defines variant;
  // A geometry shader would have to pass the displacement on.
  if (this->Outputs.Has(penumbra::resource::Displacement) && texts.Geometry.empty() &&
    std::string(mapper->GetClassName()) == "vtkOpenGLPolyDataMapper")
  {
    variant["GI_DEFORMS"] = "1";
    for (const char* part : { "Dec", "Impl" })
    {
      const std::string tag = std::string("//VTK::PositionVC::") + part;
      const char* text = *part == 'D' ? "displacement_declarations.glsl" : "displacement.glsl";
      vtkShaderProgram::Substitute(
        texts.Vertex, tag, tag + "\n" + this->Snippet(text, this->Outputs), false);
    }
  }
  vtkShaderProgram::Substitute(texts.Fragment, "//VTK::Output::Dec",
    "//VTK::Output::Dec\n" + this->Snippet("declarations.glsl", this->Outputs, variant), false);
  vtkShaderProgram::Substitute(texts.Fragment, "//VTK::Normal::Impl",
    std::string("//VTK::Normal::Impl\n") + NormalMarker + "\n", false);
  vtkShaderProgram::Substitute(
    texts.Fragment, "//VTK::Light::Impl", std::string(ColorMarker) + "\n//VTK::Light::Impl", false);
  vtkShaderProgram::Substitute(texts.Fragment, "//VTK::TCoord::Impl",
    this->Snippet("before_texture.glsl", this->Outputs) + "//VTK::TCoord::Impl\n" + Marker + "\n",
    false);
}

void vtkGICaptureHooks::AfterMapper(const penumbra::ShaderTexts& texts, vtkProp* prop)
{
  std::string& fragment = texts.Fragment;
  // Mappers take the kind of projection from the camera object, after the hook that sets uniforms.
  // A shadow map's projection may be of the other kind, so the shaders use our own uniform.
  for (std::string* source : { &texts.Vertex, &texts.Geometry, &fragment })
  {
    vtkShaderProgram::Substitute(*source, "cameraParallel", "giParallel");
  }
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  const bool unlit = !Contains(fragment, "normalVCVSOutput") ||
    Contains(fragment, "vec4(ambientColor + diffuseColor, opacity)");
  const bool pbr = Contains(fragment, "roughnessUniform");
  const bool layered =
    Contains(fragment, "#define ANISOTROPY") || Contains(fragment, "#define CLEAR_COAT");
  const std::string directLight = "  color += Lo;\n";
  const char* snippet = "as_drawn.glsl";
  if (!unlit && pbr && !layered && actor && Contains(fragment, directLight.c_str()))
  {
    // Before direct light VTK has added only the light of the surroundings.
    vtkShaderProgram::Substitute(fragment, directLight,
      this->Snippet("surrounding.glsl", this->Outputs, penumbra::SurroundingVariant(fragment)) +
        directLight,
      false);
    snippet = "pbr.glsl";
  }
  else if (!unlit && !pbr && actor)
  {
    snippet = "phong.glsl";
  }
  if (std::string(snippet) != "as_drawn.glsl")
  {
    vtkShaderProgram::Substitute(
      fragment, ColorMarker, this->Snippet("reflectance.glsl", this->Outputs), false);
  }
  // Only where VTK uses point normals, and does not compute normals itself.
  if (!unlit && Contains(fragment, "vertexVC") && Contains(fragment, "in vec3 normalVCVSOutput;"))
  {
    vtkShaderProgram::Substitute(
      fragment, NormalMarker, this->Snippet("mend_normal.glsl", this->Outputs), false);
  }
  const penumbra::Defines variant = penumbra::PassShape(texts, *this->Shaders);
  vtkShaderProgram::Substitute(
    fragment, Marker, this->Snippet(snippet, this->Outputs, variant), false);
}

void vtkGICaptureHooks::SetTextureUnit(int unit, vtkOpenGLRenderer* renderer)
{
  this->TextureUnit = unit;
  this->Renderer = renderer;
}

void vtkGICaptureHooks::SetCasting(bool casting, const glm::ivec2& anchor)
{
  this->Casting = casting;
  this->Anchor = anchor;
}

void vtkGICaptureHooks::SetDisplacement(vtkShaderProgram* program, vtkActor* actor)
{
  const penumbra::Deformations* shapes = this->Motion ? &this->Motion->Shapes() : nullptr;
  const GLuint texture = shapes ? shapes->TextureOf(actor) : 0;
  program->SetUniformi("giDeforms", texture != 0);
  // Even if the sampler is not read, its unit must not hold a texture of another kind.
  program->SetUniformi("giPointDisplacements", this->TextureUnit);
  if (texture == 0)
  {
    return;
  }
  const glm::mat3 toView(this->Motion->WorldToView() * penumbra::ToMatrix(actor->GetMatrix()));
  program->SetUniformMatrix3x3("giPropToView", const_cast<float*>(&toView[0][0]));
  auto* window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(this->TextureUnit));
  glBindTexture(GL_TEXTURE_BUFFER, texture);
}

void vtkGICaptureHooks::SetUniforms(vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop)
{
  if (program->IsUniformUsed("giParallel"))
  {
    program->SetUniformi("giParallel", this->Parallel ? 1 : 0);
  }
  if (program->IsUniformUsed("giDepthWindow"))
  {
    program->SetUniform2f("giDepthWindow", &this->DepthWindow[0]);
  }
  if (program->IsUniformUsed("giCasts"))
  {
    program->SetUniformi("giCasts", this->Casting ? 1 : 0);
    program->SetUniform2i("giAnchor", &this->Anchor[0]);
    program->SetUniformi("giLayer", this->Layer);
  }
  if (program->IsUniformUsed("giReflectance"))
  {
    program->SetUniformf("giReflectance", static_cast<float>(this->Rules.Reflectance));
  }
  if (program->IsUniformUsed("giCompensates"))
  {
    program->SetUniformi("giCompensates", this->Rules.Compensates ? 1 : 0);
  }
  if (program->IsUniformUsed("giMendsNormals"))
  {
    program->SetUniformi("giMendsNormals", this->MendsNormals ? 1 : 0);
  }
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  if (actor && program->IsUniformUsed("giDeforms"))
  {
    this->SetDisplacement(program, actor);
  }
  if (actor && program->IsUniformUsed("giMaterial"))
  {
    penumbra::MaterialTable::Owner owner =
      this->Motion ? this->Motion->Find(actor) : penumbra::MaterialTable::Owner();
    owner.ColoredByData = this->Rules.ChangesData() && penumbra::IsColoredByData(actor);
    const int front = this->Materials->Find(actor->GetProperty(), owner);
    program->SetUniformi("giMaterial", front);
    if (program->IsUniformUsed("giBackMaterial"))
    {
      vtkProperty* back = actor->GetBackfaceProperty();
      program->SetUniformi("giBackMaterial", back ? this->Materials->Find(back, owner) : front);
    }
  }
}
