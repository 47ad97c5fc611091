#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Generate, from vtk_module/techniques/*/*.json, each technique's typed base class and the registry.

A parameter is declared once, in its technique's JSON file. The C++ and Python accessors, the command line's table and the
documentation are generated from it.

usage: generate_parameters.py OUTPUT_FOLDER FILE.json...
"""
import json
import pathlib
import re
import sys

NOTICE = ("// SPDX-FileCopyrightText: Penumbra authors\n// SPDX-License-Identifier: BSD-3-Clause\n"
          "// Generated from vtk_module/techniques/*/{stem}.json: edit that file instead.\n")
CXX_TYPES = {"bool": "bool", "int": "int", "double": "double", "enum": "int"}
TECHNIQUE_KEYS = {"name", "title", "term", "verb", "approach", "dynamic", "source", "parameters", "presets"}
OPTIONAL_KEYS = {"budget"}
APPROACHES = {"precompute", "approximate", "amortise", "none"}
BUDGET_KEYS = {"unit", "per-pixel", "work", "levels", "error"}
PARAMETER_KEYS = {"name", "type", "default", "range", "unit", "values", "doc"}


def fail(path, message):
    sys.exit(f"{path}: {message}")


def kebab(camel):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", camel).lower()


def quote(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def number(parameter, value):
    """A default or preset value as a number: an enum as its index, a bool as 0 or 1."""
    if parameter["type"] == "enum":
        return parameter["values"].index(value)
    return int(value) if parameter["type"] in ("bool", "int") else float(value)


def check(path, technique):
    unknown = set(technique) - TECHNIQUE_KEYS - OPTIONAL_KEYS
    missing = TECHNIQUE_KEYS - set(technique)
    if unknown or missing:
        fail(path, f"unknown keys {sorted(unknown)}, missing keys {sorted(missing)}")
    if technique["approach"] not in APPROACHES:
        fail(path, f"approach must be one of {', '.join(sorted(APPROACHES))}")
    for parameter in technique["parameters"]:
        if set(parameter) - PARAMETER_KEYS:
            fail(path, f"{parameter['name']}: unknown keys {sorted(set(parameter) - PARAMETER_KEYS)}")
        if parameter["type"] == "enum":
            parameter["range"] = [0, len(parameter["values"]) - 1]
        elif parameter["type"] == "bool":
            parameter["range"] = [0, 1]
        low, high = parameter["range"]
        if not low <= number(parameter, parameter["default"]) <= high:
            fail(path, f"{parameter['name']}: the default is outside the range")
    names = {parameter["name"] for parameter in technique["parameters"]} | {"enabled"}
    for preset, values in technique["presets"].items():
        if set(values) - names:
            fail(path, f"preset {preset}: unknown parameters {sorted(set(values) - names)}")
    check_budget(path, technique)


def check_budget(path, technique):
    """The levels that a frame budget chooses from, if there are any: see docs/frame-budget.md."""
    budget = technique.get("budget")
    if budget is None:
        return
    by_name = {parameter["name"]: parameter for parameter in technique["parameters"]}
    if set(budget) != BUDGET_KEYS:
        fail(path, f"budget: the keys must be {', '.join(sorted(BUDGET_KEYS))}")
    for name, work in budget["work"].items():
        needed = by_name[name] if name in by_name else fail(path, f"budget: there is no parameter {name}")
        if needed["type"] == "enum" and len(work) != len(needed["values"]):
            fail(path, f"budget: {name} needs a factor for each value")
    for level in budget["levels"]:
        if set(level) != set(budget["work"]):
            fail(path, f"budget: each level must set {', '.join(budget['work'])}")
    if len(budget["error"]) != len(budget["levels"]):
        fail(path, "budget: there must be an error for each level")


def accessors(parameter):
    kind, name = CXX_TYPES[parameter["type"]], parameter["name"]
    low, high = parameter["range"]
    unit = f" Unit: {parameter['unit']}." if parameter.get("unit") else ""
    span = "" if parameter["type"] in ("bool", "enum") else f" Range: {low} to {high}."
    lines = ["  ///@{", "  /**", f"   * {parameter['doc']}{unit}{span} Default: {parameter['default']}.",
             "   */"]
    if parameter["type"] == "bool":
        lines += [f"  vtkSetMacro({name}, bool);", f"  vtkGetMacro({name}, bool);",
                  f"  vtkBooleanMacro({name}, bool);"]
    else:
        lines += [f"  vtkSetClampMacro({name}, {kind}, {low}, {high});", f"  vtkGetMacro({name}, {kind});"]
    if parameter["type"] == "enum":
        for index, value in enumerate(parameter["values"]):
            camel = "".join(part.capitalize() for part in value.split("-"))
            lines.append(f"  void Set{name}To{camel}() {{ this->Set{name}({index}); }}")
    return lines + ["  ///@}", ""]


def header(stem, technique):
    cls = f"vtkGI{stem}Parameters"
    rows = [f"  const char* Get{key.capitalize()}() override {{ return {quote(technique[key])}; }}"
            for key in ("name", "title", "term", "verb", "approach", "dynamic", "source")]
    members = [f"  {CXX_TYPES[p['type']]} {p['name']} = {json.dumps(number(p, p['default']) if p['type'] != 'bool' else p['default'])};"
               for p in technique["parameters"]]
    body = [line for parameter in technique["parameters"] for line in accessors(parameter)]
    return "\n".join([
        NOTICE.format(stem=stem) + f"/**\n * @class   {cls}\n * @brief   the parameters of vtkGI{stem}\n */",
        f"#ifndef {cls}_h", f"#define {cls}_h", "", '#include "vtkGITechnique.h"', "",
        f"class VTKRENDERINGGI_EXPORT {cls} : public vtkGITechnique", "{", "public:",
        f"  vtkTypeMacro({cls}, vtkGITechnique);", ""] + rows + [""] + body + [
        "protected:", f"  {cls}();", f"  ~{cls}() override;", "",
        "  const std::vector<penumbra::ParameterInfo>& ParameterTable() override;",
        "  const std::vector<penumbra::PresetValue>& PresetTable() override;"] + (
            ["  const penumbra::BudgetInfo* BudgetTable() override;"] if "budget" in technique else []) + [""] + members + ["",
        "private:", f"  {cls}(const {cls}&) = delete;", f"  void operator=(const {cls}&) = delete;",
        "};", "", "#endif", ""])


def source(stem, technique):
    cls = f"vtkGI{stem}Parameters"
    table, presets = [], []
    for p in technique["parameters"]:
        kind = CXX_TYPES[p["type"]]
        value = "v != 0.0" if kind == "bool" else ("static_cast<int>(v)" if kind == "int" else "v")
        values = ", ".join(quote(v) for v in p.get("values", []))
        table.append(
            f"    {{ {quote(kebab(p['name']))}, penumbra::ParameterType::{p['type'].capitalize()}, "
            f"{quote(p.get('unit', ''))},\n      {quote(p['doc'])},\n"
            f"      {float(number(p, p['default']))!r}, {float(p['range'][0])!r}, {float(p['range'][1])!r}, "
            f"{{ {values} }},\n"
            f"      [](vtkGITechnique* t) {{ return static_cast<double>(static_cast<{cls}*>(t)->Get{p['name']}()); }},\n"
            f"      [](vtkGITechnique* t, double v) {{ static_cast<{cls}*>(t)->Set{p['name']}({value}); }},\n"
            f"      [](vtkGITechnique* t, double v) {{ static_cast<{cls}*>(t)->{p['name']} = {value}; }} }},")
    by_name = {p["name"]: p for p in technique["parameters"]}
    for preset, values in technique["presets"].items():
        for key, value in values.items():
            if key == "enabled":
                presets.append(f"    {{ {quote(preset)}, nullptr, {float(bool(value))!r} }},")
            else:
                presets.append(f"    {{ {quote(preset)}, {quote(kebab(key))}, {float(number(by_name[key], value))!r} }},")
    return "\n".join([
        NOTICE.format(stem=stem) + f'#include "{cls}.h"', "", '#include "technique/Parameters.h"', "",
        f"{cls}::{cls}() = default;", f"{cls}::~{cls}() = default;", "",
        f"const std::vector<penumbra::ParameterInfo>& {cls}::ParameterTable()", "{",
        "  static const std::vector<penumbra::ParameterInfo> table = {"] + table + ["  };", "  return table;", "}", "",
        f"const std::vector<penumbra::PresetValue>& {cls}::PresetTable()", "{",
        "  static const std::vector<penumbra::PresetValue> table = {"] + presets + ["  };", "  return table;", "}", ""] +
        budget_source(cls, technique))


def budget_source(cls, technique):
    if "budget" not in technique:
        return []
    budget = technique["budget"]
    by_name = {p["name"]: p for p in technique["parameters"]}
    work = []
    for name, value in budget["work"].items():
        exponent = 1.0 if isinstance(value, list) else float(value)
        factors = [float(v) for v in value if not isinstance(v, str)] if isinstance(value, list) else []
        zero = [quote(kebab(v)) for v in value if isinstance(v, str)] if isinstance(value, list) else []
        work.append(f"      {{ {quote(kebab(name))}, {exponent!r}, {{ {', '.join(map(repr, factors))} }}, "
                    f"{{ {', '.join(zero)} }} }},")
    levels = []
    for level, error in zip(budget["levels"], budget["error"]):
        values = ", ".join(repr(float(number(by_name[name], level[name]))) for name in budget["work"])
        levels.append(f"      {{ {{ {values} }}, {float(error)!r} }},")
    return [f"const penumbra::BudgetInfo* {cls}::BudgetTable()", "{",
            f"  static const penumbra::BudgetInfo table = {{ {quote(budget['unit'])}, {str(budget['per-pixel']).lower()},",
            "    {"] + work + ["    },", "    {"] + levels + ["    } };", "  return &table;", "}", ""]


def registry(stems):
    includes = "\n".join(f'#include "vtkGI{stem}.h"' for stem in stems)
    creates = "\n".join(f"    vtkSmartPointer<vtkGITechnique>::Take(vtkGI{stem}::New())," for stem in stems)
    return (NOTICE.format(stem="*") + '#include "technique/TechniqueRegistry.h"\n\n' + includes +
            "\n\nnamespace penumbra\n{\nstd::vector<vtkSmartPointer<vtkGITechnique>> CreateTechniques()\n{\n"
            "  return {\n" + creates + "\n  };\n}\n}\n")


def write(path, text):
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def arguments(usage):
    """Parse the command line FOLDER FILE..., and create the folder. Returns it, and (stem, technique) of each file."""
    if len(sys.argv) < 3:
        sys.exit(usage)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    techniques = []
    for path in map(pathlib.Path, sys.argv[2:]):
        technique = json.loads(path.read_text())
        check(path, technique)
        techniques.append((path.stem, technique))
    return folder, techniques


def main():
    folder, techniques = arguments(__doc__)
    for stem, technique in techniques:
        write(folder / f"vtkGI{stem}Parameters.h", header(stem, technique))
        write(folder / f"vtkGI{stem}Parameters.cxx", source(stem, technique))
    stems = [stem for stem, _ in techniques]
    write(folder / "TechniqueRegistry.cxx", registry(stems))


if __name__ == "__main__":
    main()
