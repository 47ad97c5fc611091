// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGITechnique.h"

#include "gpu/Arguments.h"
#include "technique/Parameters.h"

#include <cctype>
#include <cstring>

vtkGITechnique::vtkGITechnique() = default;

vtkGITechnique::~vtkGITechnique()
{
  this->SetLastError(nullptr);
}

void vtkGITechnique::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << this->GetTitle() << "\n";
  os << indent << "Computes: " << this->GetTerm() << "\n";
  os << indent << "Method: " << this->GetVerb() << "\n";
  os << indent << "Dynamic scenes: " << this->GetDynamic() << "\n";
  os << indent << "Source: " << this->GetSource() << "\n";
  os << indent << "Enabled: " << (this->Enabled ? "yes" : "no") << "\n";
  for (const auto& parameter : this->ParameterTable())
  {
    os << indent << parameter.Name << ": " << parameter.Get(this) << " " << parameter.Unit << "\n";
  }
}

namespace
{
const char* TypeName(penumbra::ParameterType type)
{
  switch (type)
  {
    case penumbra::ParameterType::Bool:
      return "bool";
    case penumbra::ParameterType::Int:
      return "int";
    case penumbra::ParameterType::Enum:
      return "enum";
    default:
      return "double";
  }
}

std::string RangeText(const penumbra::ParameterInfo& parameter)
{
  std::ostringstream text;
  if (parameter.Type == penumbra::ParameterType::Enum)
  {
    text << "one of";
    for (const char* value : parameter.Values)
    {
      text << " " << value;
    }
  }
  else if (parameter.Type == penumbra::ParameterType::Bool)
  {
    text << "on or off";
  }
  else
  {
    text << (parameter.Type == penumbra::ParameterType::Int ? "a whole number" : "a number")
         << " from " << parameter.Minimum << " to " << parameter.Maximum;
  }
  return text.str();
}
}

namespace
{
std::string CamelCase(const char* kebab)
{
  std::string camel;
  for (const char* c = kebab; *c; ++c)
  {
    const bool startsWord = *c == '-';
    c += startsWord ? 1 : 0;
    camel += startsWord ? static_cast<char>(std::toupper(static_cast<unsigned char>(*c))) : *c;
  }
  return camel;
}
}

penumbra::Arguments vtkGITechnique::GetShaderParameters()
{
  penumbra::Arguments arguments;
  for (const auto& parameter : this->ParameterTable())
  {
    const double value = parameter.Get(this);
    const std::string name = CamelCase(parameter.Name);
    parameter.Type == penumbra::ParameterType::Double
      ? arguments.Set(name, value)
      : arguments.Set(name, static_cast<int>(value));
  }
  return arguments;
}

int vtkGITechnique::GetNumberOfParameters()
{
  return static_cast<int>(this->ParameterTable().size());
}

// The accessors by index differ only in the member that they return.
#define PENUMBRA_PARAMETER(index, expression, otherwise)                                           \
  const auto& table = this->ParameterTable();                                                      \
  if ((index) < 0 || (index) >= static_cast<int>(table.size()))                                    \
  {                                                                                                \
    return otherwise;                                                                              \
  }                                                                                                \
  const auto& parameter = table[index];                                                            \
  return expression

const char* vtkGITechnique::GetParameterName(int index)
{
  PENUMBRA_PARAMETER(index, parameter.Name, nullptr);
}

const char* vtkGITechnique::GetParameterType(int index)
{
  PENUMBRA_PARAMETER(index, TypeName(parameter.Type), nullptr);
}

const char* vtkGITechnique::GetParameterUnit(int index)
{
  PENUMBRA_PARAMETER(index, parameter.Unit, nullptr);
}

const char* vtkGITechnique::GetParameterDocumentation(int index)
{
  PENUMBRA_PARAMETER(index, parameter.Documentation, nullptr);
}

double vtkGITechnique::GetParameterDefault(int index)
{
  PENUMBRA_PARAMETER(index, parameter.Default, 0.0);
}

double vtkGITechnique::GetParameterMinimum(int index)
{
  PENUMBRA_PARAMETER(index, parameter.Minimum, 0.0);
}

double vtkGITechnique::GetParameterMaximum(int index)
{
  PENUMBRA_PARAMETER(index, parameter.Maximum, 0.0);
}

int vtkGITechnique::GetNumberOfParameterValues(int index)
{
  PENUMBRA_PARAMETER(index, static_cast<int>(parameter.Values.size()), 0);
}

const char* vtkGITechnique::GetParameterValueName(int index, int value)
{
  if (value < 0 || value >= this->GetNumberOfParameterValues(index))
  {
    return nullptr;
  }
  return this->ParameterTable()[index].Values[value];
}
#undef PENUMBRA_PARAMETER

const penumbra::ParameterInfo* vtkGITechnique::FindParameter(const char* name)
{
  for (const auto& parameter : this->ParameterTable())
  {
    if (name && std::strcmp(parameter.Name, name) == 0)
    {
      return &parameter;
    }
  }
  std::string names;
  for (const auto& parameter : this->ParameterTable())
  {
    names += std::string(names.empty() ? "" : ", ") + parameter.Name;
  }
  this->SetLastError((std::string(this->GetName()) + " has no parameter '" + (name ? name : "") +
    "'; it has: " + names + ".")
                       .c_str());
  return nullptr;
}

bool vtkGITechnique::SetParameter(const char* name, double value)
{
  const auto* parameter = this->FindParameter(name);
  if (!parameter)
  {
    vtkErrorMacro(<< this->LastError);
    return false;
  }
  const bool whole = parameter->Type == penumbra::ParameterType::Double || value == std::floor(value);
  if (!whole || !(value >= parameter->Minimum && value <= parameter->Maximum))
  {
    std::ostringstream text;
    text << this->GetName() << "." << name << " cannot be " << value << ": it must be "
         << RangeText(*parameter) << ".";
    this->SetLastError(text.str().c_str());
    vtkErrorMacro(<< this->LastError);
    return false;
  }
  this->SetLastError("");
  parameter->Set(this, value);
  return true;
}

bool vtkGITechnique::SetParameterFromText(const char* name, const char* text)
{
  const auto* parameter = this->FindParameter(name);
  if (!parameter)
  {
    vtkErrorMacro(<< this->LastError);
    return false;
  }
  const std::string value = text ? text : "";
  for (std::size_t i = 0; i < parameter->Values.size(); ++i)
  {
    if (value == parameter->Values[i])
    {
      return this->SetParameter(name, static_cast<double>(i));
    }
  }
  if (parameter->Type == penumbra::ParameterType::Bool)
  {
    for (const char* on : { "on", "true", "yes", "1" })
    {
      if (value == on)
      {
        return this->SetParameter(name, 1.0);
      }
    }
    for (const char* off : { "off", "false", "no", "0" })
    {
      if (value == off)
      {
        return this->SetParameter(name, 0.0);
      }
    }
  }
  else if (parameter->Type != penumbra::ParameterType::Enum)
  {
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (!value.empty() && *end == '\0')
    {
      return this->SetParameter(name, number);
    }
  }
  this->SetLastError((std::string(this->GetName()) + "." + name + " cannot be '" + value +
    "': it must be " + RangeText(*parameter) + ".")
                       .c_str());
  vtkErrorMacro(<< this->LastError);
  return false;
}

double vtkGITechnique::GetParameter(const char* name)
{
  const auto* parameter = this->FindParameter(name);
  if (!parameter)
  {
    vtkErrorMacro(<< this->LastError);
    return 0.0;
  }
  this->SetLastError("");
  return parameter->Get(this);
}

void vtkGITechnique::SetDefaults()
{
  for (const auto& parameter : this->ParameterTable())
  {
    parameter.Set(this, parameter.Default);
  }
}

bool vtkGITechnique::ApplyPreset(const char* preset)
{
  bool exists = false;
  for (const auto& value : this->PresetTable())
  {
    exists |= preset && std::strcmp(value.Preset, preset) == 0;
  }
  if (!exists)
  {
    return false;
  }
  this->SetDefaults();
  for (const auto& value : this->PresetTable())
  {
    if (std::strcmp(value.Preset, preset) != 0)
    {
      continue;
    }
    if (value.Parameter)
    {
      this->SetParameter(value.Parameter, value.Value);
    }
    else
    {
      this->SetEnabled(value.Value != 0.0);
    }
  }
  return true;
}
