// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "light/ForwardShaders.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <regex>

namespace penumbra
{
namespace
{
const char* const DeclarationTag = "//PENUMBRA::ForwardDec";
const char* const ShadingTag = "//PENUMBRA::ForwardImpl";
const char* const FinishTag = "//PENUMBRA::ForwardFinish"; // after VTK's textures

void Substitute(std::string& text, const std::string& tag, const std::string& replacement)
{
  vtkShaderProgram::Substitute(text, tag, replacement);
}

// Position where a volume's shader starts to loop over the lights; npos if it has none.
std::size_t LightLoop(const std::string& text)
{
  std::size_t loop = std::string::npos;
  const std::size_t lighting = text.find("vec4 computeLighting(");
  for (const char* head : { "for (int posNum", "for (int dirNum", "for (int lightNum" })
  {
    loop = std::min(loop, text.find(head, lighting));
  }
  return lighting == std::string::npos || !Contains(text, "g_dataPos") ? std::string::npos : loop;
}

// Expression for a sample's position in view coordinates. Names depend on VTK's version.
std::string SamplePosition(const std::string& text)
{
  return Contains(text, "g_texToView") ? "g_texToView * vec4(g_dataPos, 1.0)"
                                       : "in_modelViewMatrix * (in_volumeMatrix[0] * "
                                         "(in_textureDatasetMatrix[0] * vec4(g_dataPos, 1.0)))";
}
}

void ForwardShaders::MarkSurface(std::string& text)
{
  Substitute(text, "//VTK::Light::Dec", std::string("//VTK::Light::Dec\n") + DeclarationTag);
  Substitute(text, "//VTK::Light::Impl", std::string(ShadingTag) + "\n//VTK::Light::Impl");
  Substitute(text, "//VTK::TCoord::Impl", std::string("//VTK::TCoord::Impl\n") + FinishTag);
}

void ForwardShaders::MarkVolume(std::string& text)
{
  const std::string tag = "//VTK::ComputeLighting::Dec";
  Substitute(text, tag, std::string(DeclarationTag) + "\n" + tag);
  // VTK's functions use the variable above the lines that set it, and Mesa warns of that.
  Substitute(text, "vec3 g_dataPos;", "vec3 g_dataPos = vec3(0.0);");
}

std::string ForwardShaders::IndirectSource(bool volume) const
{
  std::string text;
  const std::size_t count = std::min(this->Light.Indirect.size(), MaximumParts);
  for (std::size_t i = 0; i < count; ++i)
  {
    const ForwardPart& part = this->Light.Indirect[i];
    const Defines& variant = volume ? part.InVolumes : part.OnSurfaces;
    // Two parts may declare the same names.
    text += std::regex_replace(this->Shaders.Source(part.Source, variant),
      std::regex("\\bfield([A-Z])"), ForwardProgram::FieldName(i) + "$1");
    for (const auto& define : variant)
    {
      text += "#undef " + define.first + "\n";
    }
  }
  text += this->Shaders.Source("forward/indirect.glsl", { { "GI_PARTS", std::to_string(count) } });
  return volume ? text + this->Shaders.Source("forward/volume.glsl") : text;
}

void ForwardShaders::Declare(std::string& text, bool volume, Defines visibility) const
{
  std::string declarations;
  if (this->Light.HasRules() || !this->Light.Indirect.empty())
  {
    const Defines rules{ { "GI_RULES", "1" } };
    declarations +=
      this->Shaders.Source("forward/needs.glsl", this->Light.HasRules() ? rules : Defines());
  }
  if (!this->Light.Display.IsEmpty())
  {
    declarations +=
      this->Shaders.Source(this->Light.Display.Source, this->Light.Display.OnSurfaces);
  }
  if (!this->Light.Visibility.IsEmpty())
  {
    declarations += this->Shaders.Source(this->Light.Visibility.Source, visibility) +
      this->Shaders.Source("forward/lights.glsl");
  }
  if (!this->Light.Indirect.empty())
  {
    declarations += this->IndirectSource(volume);
  }
  Substitute(text, "//VTK::System::Dec", this->Shaders.Source("forward/head.glsl"));
  Substitute(text, DeclarationTag, declarations);
}

void ForwardShaders::ApplyVisibility(std::string& text) const
{
  text = std::regex_replace(text, std::regex("uniform vec3 lightColor"), "uniform vec3 giColor");
  text = std::regex_replace(
    text, std::regex("\\blightColor([0-9]+)\\b"), "(giArrives[$1] * lightColor$1)");
  text = std::regex_replace(text, std::regex("uniform vec3 giColor"), "uniform vec3 lightColor");
}

void ForwardShaders::AddIndirect(std::string& text) const
{
  const std::string pbr = "  vec3 color = iblDiffuse + iblSpecular;";
  const std::string phong = "gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);";
  Defines variant = SurroundingVariant(text);
  if (Contains(text, "prefilterTex"))
  {
    variant["GI_ENVIRONMENT"] = "1";
  }
  if (this->Light.IsSpread())
  {
    variant["GI_SPREAD"] = "1";
  }
  Substitute(text, pbr, this->Shaders.Source("forward/pbr.glsl", variant) + pbr);
  Substitute(text, phong, phong + "\n" + this->Shaders.Source("forward/phong.glsl"));
}

void ForwardShaders::ApplyRules(std::string& text) const
{
  const std::string sum = "  vec3 color = iblDiffuse + iblSpecular;";
  const std::size_t fresnel = text.find("vec3 F90 = ");
  if (!Contains(text, sum.c_str()) || fresnel == std::string::npos)
  {
    return;
  }
  text.insert(text.find(';', fresnel) + 1, "\n" + this->Shaders.Source("forward/boost.glsl"));
  Substitute(
    text, sum, this->Shaders.Source("forward/compensate.glsl", SurroundingVariant(text)) + sum);
  Substitute(text, "(diffuse + specular)", "(diffuse + giBoost * specular)");
}

void ForwardShaders::LightSurface(const ShaderTexts& texts) const
{
  std::string& text = texts.Fragment;
  const bool lit = Contains(text, "lightColor0") && Contains(text, "vertexVC") &&
    Contains(text, "normalVCVSOutput") && Contains(text, ShadingTag) &&
    Contains(text, DeclarationTag);
  if (!lit)
  {
    return;
  }
  std::string code;
  Defines finish;
  if (Contains(text, "roughnessUniform"))
  {
    finish["GI_PBR"] = "1";
  }
  if (this->Light.HasRules())
  {
    finish["GI_RULES"] = "1";
    code += this->Shaders.Source("forward/reflectance.glsl");
    this->ApplyRules(text);
  }
  if (!this->Light.Display.IsEmpty())
  {
    finish["GI_DISPLAY"] = "1";
  }
  if (finish.count("GI_RULES") + finish.count("GI_DISPLAY") > 0)
  {
    Substitute(text, FinishTag, this->Shaders.Source("forward/finish.glsl", finish));
  }
  if (!this->Light.Visibility.IsEmpty())
  {
    code += this->Shaders.Source("forward/surface.glsl", PassShape(texts, this->Shaders));
    this->ApplyVisibility(text);
  }
  if (!this->Light.Indirect.empty())
  {
    code += this->Shaders.Source(
      "forward/around.glsl", this->Light.HasRules() ? Defines{ { "GI_RULES", "1" } } : Defines());
    this->AddIndirect(text);
  }
  Substitute(text, ShadingTag, code);
  this->Declare(text, false, this->Light.Visibility.OnSurfaces);
}

bool ForwardShaders::ApplyVolumeVisibility(std::string& text, Defines& variant) const
{
  const std::size_t loop = LightLoop(text);
  if (loop == std::string::npos)
  {
    return false;
  }
  if (Contains(text, "posNum") || Contains(text, "dirNum"))
  {
    variant["GI_POSITIONAL_FIRST"] = "1";
  }
  text.insert(loop, "giArriveAt(" + SamplePosition(text) + ");\n  ");
  text = std::regex_replace(text,
    std::regex("in_light(Diffuse|Specular)Color\\[(posNum|dirNum|lightNum)\\]"),
    "giArrives[$2] * $&");
  return true;
}

bool ForwardShaders::FinishVolume(std::string& text) const
{
  const std::string sample = "finalColor.a = color.a;";
  const std::string pixel = "gl_FragData[0] = g_fragColor;";
  const bool lit = LightLoop(text) != std::string::npos;
  const bool ruled = lit && this->Light.HasRules() && Contains(text, sample.c_str());
  const bool displayed = lit && !this->Light.Display.IsEmpty() && Contains(text, pixel.c_str());
  if (ruled)
  {
    Substitute(text, sample, this->Shaders.Source("forward/rule_sample.glsl") + sample);
  }
  if (displayed)
  {
    Substitute(text, pixel, pixel + "\n" + this->Shaders.Source("forward/finish_volume.glsl"));
  }
  return ruled || displayed;
}

bool ForwardShaders::AddScattered(std::string& text) const
{
  // Insert after the computation of a shaded sample's colour, before it is returned.
  const std::string ambientTerm = "finalColor.xyz = in_ambient[";
  const std::size_t begin = text.find(ambientTerm);
  const std::size_t end =
    begin == std::string::npos ? begin : text.find("finalColor.a = color.a;", begin);
  if (end == std::string::npos)
  {
    return false;
  }
  const std::size_t name = begin + ambientTerm.size();
  const std::string component = text.substr(name, text.find(']', name) - name);
  const bool several = Contains(text, "const int volIdx");
  const std::string gradient =
    Contains(text, "vec4 shading_gradient") ? "shading_gradient" : "gradient";
  text.insert(end,
    "finalColor.xyz += in_diffuse[" + component + "] * color.rgb * " +
      (this->Light.HasRules() ? "giDataLight(" : "") + "giScattered(" + SamplePosition(text) +
      ", " + gradient +
      (several ? ", in_textureToEye[volIdx + 1], in_cellSpacing[volIdx]"
               : ", in_textureToEye[0], in_cellSpacing[0]") +
      (this->Light.HasRules() ? "));\n  " : ");\n  "));
  return true;
}

void ForwardShaders::LightVolume(std::string& text) const
{
  Defines variant = this->Light.Visibility.InVolumes;
  const bool dimmed =
    !this->Light.Visibility.IsEmpty() && this->ApplyVolumeVisibility(text, variant);
  const bool added = !this->Light.Indirect.empty() && this->AddScattered(text);
  const bool finished = this->FinishVolume(text);
  if (dimmed || added || finished)
  {
    this->Declare(text, true, variant);
  }
}

std::vector<std::pair<std::string, std::string>> ForwardShaders::Examples() const
{
  std::vector<std::pair<std::string, std::string>> examples;
  for (const char* kind : { "phong", "pbr", "volume" })
  {
    const std::string name = std::string("forward/like_") + kind + ".glsl";
    std::string vertex =
      "out vec3 normalVCVSOutput;\nvoid main()\n{\n  vertexVCVSOutput = vec4(0.0);\n}\n";
    std::string text = this->Shaders.Source(name);
    if (*kind == 'v')
    {
      MarkVolume(text);
      this->LightVolume(text);
    }
    else
    {
      MarkSurface(text);
      std::string geometry;
      this->LightSurface({ vertex, geometry, text });
    }
    // VTK makes the same replacement.
    Substitute(text, "gl_FragData[0]", "fragOutput0");
    examples.emplace_back(name, text);
  }
  return examples;
}

void ForwardShaders::Check() const
{
  for (const auto& example : this->Examples())
  {
    this->Shaders.Check(example.first, GL_FRAGMENT_SHADER, example.second);
  }
}
}
