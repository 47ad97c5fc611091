// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/TechniqueTable.h"

#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkNew.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace penumbra::tool
{
namespace
{
using nlohmann::ordered_json;

ordered_json DescribeParameter(vtkGITechnique* technique, int index)
{
  const auto text = [](const char* value) { return std::string(value ? value : ""); };
  ordered_json parameter = { { "name", text(technique->GetParameterName(index)) },
    { "type", text(technique->GetParameterType(index)) },
    { "default", technique->GetParameterDefault(index) },
    { "minimum", technique->GetParameterMinimum(index) },
    { "maximum", technique->GetParameterMaximum(index) },
    { "unit", text(technique->GetParameterUnit(index)) },
    { "doc", text(technique->GetParameterDocumentation(index)) } };
  for (int value = 0; value < technique->GetNumberOfParameterValues(index); ++value)
  {
    parameter["values"].push_back(text(technique->GetParameterValueName(index, value)));
  }
  return parameter;
}

std::string DefaultText(const ordered_json& parameter)
{
  const double value = parameter["default"];
  if (parameter.contains("values"))
  {
    return parameter["values"][static_cast<std::size_t>(value)];
  }
  return parameter["type"] == "bool" ? (value != 0 ? "on" : "off") : fmt::format("{:g}", value);
}

std::string RangeText(const ordered_json& parameter)
{
  if (parameter.contains("values"))
  {
    return fmt::format("{}", fmt::join(parameter["values"].get<std::vector<std::string>>(), ", "));
  }
  return parameter["type"] == "bool"
    ? "on, off"
    : fmt::format(
        "{:g} to {:g}", parameter["minimum"].get<double>(), parameter["maximum"].get<double>());
}

std::string Text(const ordered_json& object, const char* key)
{
  return object[key].get<std::string>();
}
}

ordered_json DescribeTechniques()
{
  ordered_json techniques = ordered_json::array();
  vtkNew<vtkGIPass> pass;
  for (int i = 0; i < pass->GetNumberOfTechniques(); ++i)
  {
    vtkGITechnique* technique = pass->GetTechnique(i);
    ordered_json row = { { "name", technique->GetName() }, { "title", technique->GetTitle() },
      { "term", technique->GetTerm() }, { "verb", technique->GetVerb() },
      { "dynamic", technique->GetDynamic() }, { "source", technique->GetSource() },
      { "parameters", ordered_json::array() } };
    for (int p = 0; p < technique->GetNumberOfParameters(); ++p)
    {
      row["parameters"].push_back(DescribeParameter(technique, p));
    }
    techniques.push_back(row);
  }
  return techniques;
}

std::string PlainTable(const ordered_json& techniques, bool parameters)
{
  const std::array<const char*, 4> keys = { "name", "term", "verb", "dynamic" };
  const std::array<const char*, 4> heads = { "technique", "computes", "method",
    "dynamic scenes" };
  std::array<std::size_t, 4> widths{};
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    widths[i] = std::string(heads[i]).size();
    for (const auto& row : techniques)
    {
      widths[i] = std::max(widths[i], Text(row, keys[i]).size());
    }
  }
  std::string table;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    table += fmt::format("{:<{}}", heads[i], i + 1 < keys.size() ? widths[i] + 2 : 0);
  }
  table += "\n";
  for (const auto& row : techniques)
  {
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      table += fmt::format("{:<{}}", Text(row, keys[i]), i + 1 < keys.size() ? widths[i] + 2 : 0);
    }
    table += "\n";
  }
  for (const auto& row : techniques)
  {
    if (!parameters)
    {
      break;
    }
    table += fmt::format("\n{}: {}\n", Text(row, "name"), Text(row, "source"));
    for (const auto& parameter : row["parameters"])
    {
      const std::string unit = Text(parameter, "unit");
      table += fmt::format("  {}.{} = {} ({}{}{})\n      {}\n", Text(row, "name"),
        Text(parameter, "name"), DefaultText(parameter), RangeText(parameter),
        unit.empty() ? "" : "; ", unit, Text(parameter, "doc"));
    }
  }
  return table;
}

std::string MarkdownTable(const ordered_json& techniques, bool parameters)
{
  std::string table =
    "| technique | computes | method | dynamic scenes |\n|---|---|---|---|\n";
  for (const auto& row : techniques)
  {
    table += fmt::format("| {} | {} | {} | {} |\n", Text(row, "name"), Text(row, "term"),
      Text(row, "verb"), Text(row, "dynamic"));
  }
  for (const auto& row : techniques)
  {
    if (!parameters)
    {
      break;
    }
    table += fmt::format(
      "\n## {} (`{}`)\n\n{}.\n\n", Text(row, "title"), Text(row, "name"), Text(row, "source"));
    table += "| parameter | default | range | unit | meaning |\n|---|---|---|---|---|\n";
    for (const auto& parameter : row["parameters"])
    {
      table += fmt::format("| `{}` | {} | {} | {} | {} |\n", Text(parameter, "name"),
        DefaultText(parameter), RangeText(parameter), Text(parameter, "unit"),
        Text(parameter, "doc"));
    }
  }
  return table;
}
}
