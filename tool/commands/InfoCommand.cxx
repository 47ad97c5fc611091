// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// penumbra info: versions, OpenGL, techniques.
#include "commands/Commands.h"

#include "common/Failure.h"
#include "common/Windows.h"

#include <vtkGILook.h>
#include <vtkGIPass.h>
#include <vtkGITechnique.h>
#include <vtkNew.h>
#include <vtkVersion.h>

#include <fmt/ranges.h>

#include <array>

namespace penumbra::tool
{
namespace
{
using nlohmann::ordered_json;
using Row = std::array<std::string, 4>;

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

/// All looks. One of the user's folder that has a mistake is described by it.
ordered_json DescribeLooks()
{
  ordered_json looks = ordered_json::array();
  const int count = vtkGILook::GetNumberOfLooks();
  for (int i = 0; i < count; ++i)
  {
    const char* name = vtkGILook::GetLookName(i);
    vtkNew<vtkGILook> look;
    const bool read = look->Load(name);
    looks.push_back({ { "name", name }, { "title", read ? look->GetTitle() : "" },
      { "description", read ? look->GetDescription() : look->GetLastError() } });
  }
  return looks;
}

std::string Text(const ordered_json& object, const char* key)
{
  return object[key].get<std::string>();
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

void PrintTable(const std::vector<Row>& rows, bool markdown)
{
  std::array<std::size_t, 4> longest{};
  for (const Row& row : rows)
  {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
    {
      longest[i] = std::max(longest[i], row[i].size() + 2);
    }
  }
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    const Row& row = rows[r];
    if (markdown)
    {
      fmt::print("| {} |\n{}", fmt::join(row, " | "), r == 0 ? "|---|---|---|---|\n" : "");
    }
    else
    {
      fmt::print("{:<{}}{:<{}}{:<{}}{}\n", row[0], longest[0], row[1], longest[1], row[2],
        longest[2], row[3]);
    }
  }
}

void PrintParameters(const ordered_json& technique, bool markdown)
{
  const std::string name = Text(technique, "name"), source = Text(technique, "source");
  if (markdown)
  {
    fmt::print("\n## {} (`{}`)\n\n{}.\n\n| parameter | default | range | unit | meaning |\n"
               "|---|---|---|---|---|\n",
      Text(technique, "title"), name, source);
  }
  else
  {
    fmt::print("\n{}: {}\n", name, source);
  }
  for (const auto& parameter : technique["parameters"])
  {
    const std::string unit = Text(parameter, "unit");
    if (markdown)
    {
      fmt::print("| `{}` | {} | {} | {} | {} |\n", Text(parameter, "name"), DefaultText(parameter),
        RangeText(parameter), unit, Text(parameter, "doc"));
    }
    else
    {
      fmt::print("  {}.{} = {} ({}{}{})\n      {}\n", name, Text(parameter, "name"),
        DefaultText(parameter), RangeText(parameter), unit.empty() ? "" : "; ", unit,
        Text(parameter, "doc"));
    }
  }
}

void PrintTechniques(const ordered_json& techniques, bool parameters, bool markdown)
{
  std::vector<Row> rows = { { "technique", "computes", "method", "dynamic scenes" } };
  for (const auto& technique : techniques)
  {
    rows.push_back({ Text(technique, "name"), Text(technique, "term"), Text(technique, "verb"),
      Text(technique, "dynamic") });
  }
  PrintTable(rows, markdown);
  for (const auto& technique : techniques)
  {
    if (parameters)
    {
      PrintParameters(technique, markdown);
    }
  }
}

class InfoCommand
{
public:
  CLI::App* Declare(CLI::App& app)
  {
    CLI::App* command =
      app.add_subcommand("info", "show OpenGL, VTK, the table of techniques, and the looks");
    command->add_flag("--parameters", this->Parameters, "include each technique's parameters");
    auto* json = command->add_flag("--json", this->Json, "print JSON");
    command
      ->add_flag("--markdown", this->Markdown, "print tables for the documentation, without OpenGL")
      ->excludes(json);
    command->add_option("--backend", this->Backend, "egl, osmesa, x11 or auto")
      ->capture_default_str();
    command->footer("Examples:\n"
                    "  penumbra info\n"
                    "  penumbra info --parameters --backend osmesa\n"
                    "  penumbra info --json");
    return command;
  }

  int Run(Console& console)
  {
    const ordered_json techniques = DescribeTechniques();
    const ordered_json looks = DescribeLooks();
    if (this->Markdown)
    {
      PrintTechniques(techniques, this->Parameters, true);
      return 0;
    }
    ordered_json info = { { "penumbra", PENUMBRA_VERSION }, { "vtk", vtkVersion::GetVTKVersion() },
      { "opengl", nullptr }, { "techniques", techniques }, { "looks", looks } };
    int status = 0;
    try
    {
      vtkSmartPointer<vtkRenderWindow> window = MakeWindow(this->Backend);
      Step step(console, "opening an OpenGL window");
      info["opengl"] = OpenWindow(window);
      window->Finalize();
    }
    catch (const Failure& failure)
    {
      // The other information is valid without OpenGL.
      console.Error(failure.what());
      status = failure.GetExitStatus();
      if (status == Failure::Usage)
      {
        return status;
      }
    }
    if (this->Json)
    {
      Print(info.dump(2) + "\n");
      return status;
    }
    const auto print = [](const char* name, const std::string& value) {
      fmt::print("{:<16}{}\n", name, value);
    };
    print("Penumbra", PENUMBRA_VERSION);
    print("VTK", Text(info, "vtk"));
    for (const auto& [key, value] : info["opengl"].items())
    {
      print(key == "vendor" ? "OpenGL vendor" : key.c_str(), value);
    }
    fmt::print("\n");
    PrintTechniques(techniques, this->Parameters, false);
    fmt::print("\n");
    for (const auto& look : looks)
    {
      print(("look " + Text(look, "name")).c_str(), Text(look, "description"));
    }
    return status;
  }

private:
  bool Parameters = false;
  bool Json = false;
  bool Markdown = false;
  std::string Backend = "auto";
};
}

void AddInfoCommand(CLI::App& app, Console& console, int& status)
{
  AddCommand<InfoCommand>(app, console, status);
}
}
