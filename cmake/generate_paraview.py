#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Generate the ParaView plugin's description of the techniques from vtk_module/techniques/*/*.json.

GlobalIllumination.xml: a property for each parameter (documentation, unit, range, default), and an extension that adds the
properties to ParaView's render view in a group for each technique. vtkPVGIParameters.h and .cxx: the methods that the
properties call, and a table of property, technique and parameter.

The defaults are the values of the preset "balanced", so switching global illumination on applies that preset.

usage: generate_paraview.py OUTPUT_FOLDER FILE.json...
"""
import pathlib
import re
from xml.sax.saxutils import escape, quoteattr

from generate_parameters import NOTICE, arguments, kebab, number, quote, write

START_PRESET = "balanced"
SWITCH = "GlobalIllumination"
PROBES = "SHProbes"  # the technique whose light can be baked in a view
BAKES = {PROBES: "File of baked probes, valid for the scene that they were baked in. Baking writes this file if one is named; "
                 "otherwise the probes are lost with the view.",
         "Lightmap": "A lightmap that penumbra bake lightmap wrote, baked from the data that the view shows."}
BAKER = pathlib.Path(__file__).parent.parent / "vtk_module/techniques/sh_probes/vtkGIProbeBaker.h"
MOST_PROBES = int(re.search(r"MostProbes = (\d+)", BAKER.read_text()).group(1))
LOOKS = sorted(path.stem for path in (pathlib.Path(__file__).parent.parent / "looks").glob("*.json"))
LONGEST_UNIT = 12  # characters, so that the panel stays narrow; the tooltip contains every unit


def words(camel):
    """A name as a label: SlopeBias as Slope bias. Names in capitals are not changed."""
    text = kebab(camel).replace("-", " ") if not camel.isupper() else camel
    return text[0].upper() + text[1:]


def label(parameter):
    """The label in the panel, with the unit if it is short and not part of the name."""
    text, unit = words(parameter["name"]), parameter.get("unit", "")
    return f"{text} ({unit})" if 0 < len(unit) <= LONGEST_UNIT and unit not in text.lower() else text


def visible_where(switches, indent, more=""):
    """Hints that show a property only if all of these switches are on. more: further hints."""
    return f"{indent}<Hints>\n" + "".join(
        f'{indent}  <PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="{prop}" value="1"/>\n'
        for prop in switches) + f"{indent}{more}</Hints>\n"


def domain(parameter):
    if parameter["type"] == "bool":
        return '<BooleanDomain name="bool"/>'
    if parameter["type"] == "enum":
        entries = "".join(f'<Entry text={quoteattr(value)} value="{i}"/>'
                          for i, value in enumerate(parameter["values"]))
        return f'<EnumerationDomain name="enum">{entries}</EnumerationDomain>'
    kind = "Double" if parameter["type"] == "double" else "Int"
    low, high = parameter["range"]
    most = "" if high >= 1e30 else f' max="{high}"'
    return f'<{kind}RangeDomain name="range" min="{low}"{most}/>'


def tooltip(parameter):
    text = parameter["doc"]
    if parameter.get("unit"):
        text += f" Unit: {parameter['unit']}."
    low, high = parameter["range"]
    if parameter["type"] in ("int", "double"):
        text += f" Range: {low} and more." if high >= 1e30 else f" Range: {low} to {high}."
    return text


def sm_property(name, title, command, kind, default, inner, doc, shown_with=(), advanced=False):
    tag = "DoubleVectorProperty" if kind == "double" else "IntVectorProperty"
    visibility = "advanced" if advanced else "default"
    call = f' command="{command}"' if command else ""
    return (f'      <{tag} name="{name}" label={quoteattr(title)}{call} number_of_elements="1" '
            f'default_values="{default}" panel_visibility="{visibility}">\n        {inner}\n'
            f'        <Documentation>{escape(doc)}</Documentation>\n' +
            (visible_where(shown_with, "        ") if shown_with else "") + f'      </{tag}>\n')


def rows(techniques):
    """(property, technique, parameter or None for a switch, declaration, default) in the order of the panel."""
    for stem, technique in techniques:
        preset = technique["presets"][START_PRESET]
        yield f"GI{stem}", technique["name"], None, technique, int(preset["enabled"])
        for p in technique["parameters"]:
            yield (f"GI{stem}{p['name']}", technique["name"], kebab(p["name"]), p,
                   number(p, preset.get(p["name"], p["default"])))


def general_properties(presets):
    names = "".join(f'<Entry text="{name}" value="{i}"/>' for i, name in enumerate(presets))
    yield sm_property(SWITCH, "Global illumination", "SetEnabled", "int", 0, '<BooleanDomain name="bool"/>',
                      "Light this view with Penumbra: shadows, occlusion, reflections, indirect light. Off shows "
                      "ParaView's own picture.")
    yield sm_property("GIPreset", "Apply preset", None, "int", -1,
                      f'<EnumerationDomain name="enum"><Entry text="choose" value="-1"/>{names}</EnumerationDomain>',
                      "Set all techniques and parameters below to the values of a preset. Only these values are used "
                      "and saved; this box returns to \"choose\".", [SWITCH])
    yield look_property()
    yield sm_property("GIStillFrames", "Frames of a still picture", "SetStillFrames", "int", 1,
                      '<IntRangeDomain name="range" min="1"/>',
                      "Number of frames drawn for one still picture, such as a screenshot. Techniques that accumulate "
                      "over frames need several. While the camera moves, one frame is drawn.", [SWITCH])
    yield sm_property("GIFrameBudget", "Frame budget (ms)", "SetFrameBudget", "double", 0,
                      '<DoubleRangeDomain name="range" min="0" max="10000"/>',
                      "Milliseconds that a frame may take while the camera moves; 0 for no limit. Techniques then use lower "
                      "settings than those below, as far as that is needed. Still pictures and screenshots use those below. "
                      "Values below 1 count as 1. Range: 0 to 10000.", [SWITCH])
    yield sm_property("GIFrameChart", "Show what a frame costs", "SetFrameChart", "int", 0, '<BooleanDomain name="bool"/>',
                      "Draw a chart over the view: the milliseconds of each part of the last frame, and with a frame budget "
                      "also earlier frames and what the budget has lowered. Screenshots leave it out.", [SWITCH])
    yield statistics_property()


def statistics_property():
    """The property for scripts that read what a frame costs."""
    return ('      <StringVectorProperty name="GIStatistics" command="GetStatistics" information_only="1" '
            'panel_visibility="never">\n        <Documentation>What the last frame cost, as JSON, while there is a frame budget '
            'or its chart is shown.</Documentation>\n      </StringVectorProperty>\n')


def look_property():
    """The property of the view's look, and of the reason why it could not be read."""
    listed = "".join(f'<String value="{name}"/>' for name in LOOKS)
    return ('      <StringVectorProperty name="GILook" label="Look" command="SetLook" animateable="0" number_of_elements="1" '
            f'default_values="as-is" panel_visibility="default">\n        <StringListDomain name="looks">{listed}'
            '</StringListDomain>\n        <Documentation>A set-up of light and background, which replaces the view\'s own '
            'lights and background and sets some of the techniques and parameters below for as long as it is chosen. '
            '&quot;as-is&quot; brings everything back. Scripts may also set the path of a look\'s file.</Documentation>\n' +
            visible_where([SWITCH], "        ") + '      </StringVectorProperty>\n'
            '      <StringVectorProperty name="GILookProblem" command="GetLookProblem" information_only="1" '
            'panel_visibility="never">\n        <Documentation>Why the look could not be read; empty if all is well.'
            '</Documentation>\n      </StringVectorProperty>\n')


def bake_properties(stem, what):
    """Properties of the file of a technique's baked light, and of the last error."""
    yield (f'      <StringVectorProperty name="GI{stem}File" label="File" command="Set{stem}File" animateable="0" '
           'number_of_elements="1" default_values="" panel_visibility="default">\n        <FileListDomain name="files"/>\n'
           f'        <Documentation>{what}</Documentation>\n' +
           visible_where([SWITCH, f"GI{stem}"], "        ", '<FileChooser extensions="vti" file_description="Baked light"/>'
                         '<AcceptAnyFile/>') + "      </StringVectorProperty>\n")
    yield (f'      <StringVectorProperty name="GI{stem}Problem" command="Get{stem}Problem" information_only="1" '
           'panel_visibility="never">\n        <Documentation>Why light could not be baked, read or written; empty if all is well.'
           '</Documentation>\n      </StringVectorProperty>\n')


def probe_properties():
    """Properties for baking probes in a view."""
    shown = [SWITCH, f"GI{PROBES}"]
    for name, title, command, bounds, default, doc in (
            ("Count", "Probes to bake", "SetProbesToBake", [27, MOST_PROBES], 1024,
             "Maximum number of probes in the bounds of the visible props."),
            ("Samples", "Samples to bake", "SetSamplesToBake", [1, 1 << 24], 256,
             "Number of paths from each probe. Four times as many take four times as long and halve the noise.")):
        parameter = {"type": "int", "range": bounds, "doc": doc}
        yield sm_property(f"GI{PROBES}{name}", title, command, "int", default, domain(parameter), tooltip(parameter),
                          shown, True)
    yield (f'      <Property name="GI{PROBES}Bake" label="Bake probes" command="BakeProbes" '
           'panel_widget="command_button" panel_visibility="default">\n'
           '        <Documentation>Bake the indirect light of the scene as the view shows it now. This takes seconds to '
           'minutes. Lights that follow the camera are left out.</Documentation>\n' +
           visible_where(shown, "        ") + "      </Property>\n")


def settings_proxy(techniques):
    out = ['    <GISettingsProxy name="Settings" class="vtkPVGISettings" label="Global illumination"\n'
           '        processes="client|renderserver">\n'
           '      <Documentation>Global illumination of one render view.</Documentation>\n']
    out += general_properties(techniques[0][1]["presets"])
    for name, technique, parameter, declaration, default in rows(techniques):
        if parameter is None:
            out.append(sm_property(
                name, declaration["title"], f"Set{name}", "int", default, '<BooleanDomain name="bool"/>',
                f"Computes: {declaration['term']}. Method: {declaration['verb']}. Dynamic scenes: "
                f"{declaration['dynamic']}.", [SWITCH]))
            switch = name
        else:
            out.append(sm_property(name, label(declaration), f"Set{name}", declaration["type"], default,
                                   domain(declaration), tooltip(declaration), [SWITCH, switch], advanced=True))
    for stem, what in BAKES.items():
        out += bake_properties(stem, what)
    out += probe_properties()
    out.append('      <ProxyProperty name="GIView" command="SetView" panel_visibility="never">\n'
               '        <ProxyGroupDomain name="groups"><Group name="views"/></ProxyGroupDomain>\n'
               '        <Documentation>The render view that these settings apply to, if they are not '
               'part of it.</Documentation>\n      </ProxyProperty>\n    </GISettingsProxy>\n')
    return "".join(out)


def group(title, names):
    listed = "".join(f'            <Property name="{name}"/>\n' for name in names)
    return f'          <PropertyGroup label={quoteattr(title)}>\n{listed}          </PropertyGroup>\n'


def extension(techniques):
    table = list(rows(techniques))
    switches = [SWITCH, "GIPreset", "GILook", "GIStillFrames", "GIFrameBudget", "GIFrameChart", "GIStatistics"] + [
        name for name, _, parameter, _, _ in table if parameter is None]
    groups = group("Global illumination", switches)
    for stem, technique in techniques:
        names = [f"GI{stem}{name}" for name in ("File", "Problem") if stem in BAKES]
        names += [f"GI{stem}{name}" for name in ("Bake", "Count", "Samples") if stem == PROBES]
        names += [name for name, owner, parameter, _, _ in table if owner == technique["name"] and parameter]
        if names:
            groups += group(f"GI: {technique['title']}", names)
    return ('    <Extension name="RenderView">\n      <SubProxy command="AddRepresentation">\n'
            '        <Proxy name="GlobalIllumination" proxygroup="global_illumination" proxyname="Settings"/>\n'
            f'        <ExposedProperties>\n{groups}        </ExposedProperties>\n'
            '      </SubProxy>\n    </Extension>\n')


def xml(techniques):
    return ("<!-- Generated from vtk_module/techniques/*/*.json: edit those files instead. -->\n"
            "<ServerManagerConfiguration>\n  <ProxyGroup name=\"global_illumination\">\n" + settings_proxy(techniques) +
            "  </ProxyGroup>\n  <ProxyGroup name=\"views\">\n" + extension(techniques) +
            "  </ProxyGroup>\n</ServerManagerConfiguration>\n")


def header(techniques):
    setters = []
    for name, technique, parameter, declaration, _ in rows(techniques):
        kind = "double" if declaration.get("type") == "double" else "int"
        setters += ["  /**", f"   * {declaration['doc'] if parameter else 'Switch: ' + declaration['title'] + '.'}", "   */",
                    f"  void Set{name}({kind} value) {{ this->SetSetting({quote(name)}, value); }}"]
    return "\n".join([
        NOTICE.format(stem="*") + "/**\n * @class   vtkPVGIParameters\n * @brief   methods of the properties of "
        "ParaView's settings of global illumination\n */",
        "#ifndef vtkPVGIParameters_h", "#define vtkPVGIParameters_h", "", '#include "vtkDataRepresentation.h"',
        '#include "vtkPenumbraParaViewModule.h" // for the export macro', "", "#include <vector> // for the table", "",
        "class VTKPENUMBRAPARAVIEW_EXPORT vtkPVGIParameters : public vtkDataRepresentation", "{", "public:",
        "  vtkTypeMacro(vtkPVGIParameters, vtkDataRepresentation);", ""] + setters + ["",
        "#ifndef __VTK_WRAP__",
        "  /// A property, its technique, and its parameter, or nullptr if it is the technique's switch.",
        "  struct Row", "  {", "    const char* Property;", "    const char* Technique;", "    const char* Parameter;", "  };",
        "  static const std::vector<Row>& Table();", "#endif", "",
        "protected:", "  vtkPVGIParameters() = default;", "  ~vtkPVGIParameters() override = default;", "",
        "  virtual void SetSetting(const char* property, double value) = 0;", "",
        "private:", "  vtkPVGIParameters(const vtkPVGIParameters&) = delete;",
        "  void operator=(const vtkPVGIParameters&) = delete;", "};", "", "#endif", ""])


def source(techniques):
    table = [f"    {{ {quote(name)}, {quote(technique)}, {quote(parameter) if parameter else 'nullptr'} }},"
             for name, technique, parameter, _, _ in rows(techniques)]
    return "\n".join([NOTICE.format(stem="*") + '#include "vtkPVGIParameters.h"', "",
                      "const std::vector<vtkPVGIParameters::Row>& vtkPVGIParameters::Table()", "{",
                      "  static const std::vector<Row> table = {"] + table + ["  };", "  return table;", "}", ""])


def main():
    folder, techniques = arguments(__doc__)
    write(folder / "GlobalIllumination.xml", xml(techniques))
    write(folder / "vtkPVGIParameters.h", header(techniques))
    write(folder / "vtkPVGIParameters.cxx", source(techniques))


if __name__ == "__main__":
    main()
