# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Switches global illumination on and off, and lists presets and techniques."""
import contextlib
import json
from dataclasses import dataclass

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from .vtkRenderingGI import vtkGIBakeFile, vtkGIFrameChart, vtkGILook, vtkGIPass


@dataclass(frozen=True)
class Parameter:
    """One parameter of a technique, as declared in its parameter file."""
    name: str
    type: str
    unit: str
    doc: str
    default: object
    minimum: float
    maximum: float
    values: tuple


@dataclass(frozen=True)
class Technique:
    """The description of a technique.

    term: what it computes; verb: its method; approach: how it keeps a frame cheap ("precompute", "approximate",
    "amortise", or "none" if it is no term of light); dynamic: whether it supports dynamic scenes; source: the literature.
    """
    name: str
    title: str
    term: str
    verb: str
    approach: str
    dynamic: str
    source: str
    parameters: tuple


@dataclass(frozen=True)
class Look:
    """The description of a look: its name, a title, and what it is for."""
    name: str
    title: str
    description: str


@contextlib.contextmanager
def _quiet():
    """Suppress VTK's messages. Errors are raised as exceptions instead."""
    shown = vtkObject.GetGlobalWarningDisplay()
    vtkObject.SetGlobalWarningDisplay(0)
    try:
        yield
    finally:
        vtkObject.SetGlobalWarningDisplay(shown)


def _renderers(target):
    if isinstance(target, vtkRenderer):
        return [target]
    if isinstance(target, vtkRenderWindow):
        found = [r for r in target.GetRenderers() if r.GetLayer() == 0]
        if not found:
            raise ValueError("the window has no renderer in layer 0: add one before enabling")
        return found
    raise TypeError(f"expected a vtkRenderer or a vtkRenderWindow, not {type(target).__name__}")


def _technique(gi, name):
    with _quiet():
        technique = gi.GetTechnique(name)
    if technique is None:
        names = ", ".join(gi.GetTechnique(i).GetName() for i in range(gi.GetNumberOfTechniques()))
        raise ValueError(f"there is no technique '{name}': there are {names}")
    return technique


def _set(gi, name, value):
    technique_name, dot, parameter = name.partition(".")
    if not dot:
        raise ValueError(f"'{name}' is not a parameter: write technique.parameter, such as shadow-maps.resolution")
    technique = _technique(gi, technique_name)
    with _quiet():
        if isinstance(value, str):
            done = technique.SetParameterFromText(parameter, value)
        else:
            done = technique.SetParameter(parameter, float(value))
    if not done:
        raise ValueError(technique.GetLastError())


def _names(names):
    return [names] if isinstance(names, str) else names


def enable(target, preset="balanced", on=(), off=(), look="as-is", budget=0, **parameters):
    """Light a renderer, or every renderer in layer 0 of a window, with Penumbra. Returns the pass.

    on, off: techniques to switch on or off, in addition to the preset's. look: the name or the file of a look, which
    replaces lights and background (see looks()); the next enable() and disable() remove it. budget: milliseconds that a frame may
    take while anything moves (1 to 10000), "auto" for 1/DesiredUpdateRate of the window while the user turns the scene, 0
    for no limit. A window at rest must be drawn again to get the full settings back: see vtkGIRefinement and
    docs/frame-budget.md. Parameters are named
    technique.parameter, either as on the command line or with underscores:

        enable(renderer, "high", off="ambient-occlusion", shadow_maps__resolution=1024)
        enable(renderer, look="studio", **{"shadow-maps.resolution": 1024})

    What is given here comes after what the preset and the look say. An unknown name or a value out of range raises
    ValueError and changes nothing. An existing pass is changed, not replaced, so that it keeps its GPU resources.
    """
    renderers = _renderers(target)
    if preset not in presets():
        raise ValueError(f"there is no preset '{preset}': there are {', '.join(presets())}")
    loaded = _load_look(look)
    # Try the settings on a new pass first, so that a mistake does not change the renderers.
    new = vtkGIPass()
    new.SetPreset(preset)
    _apply(new, _names(on), _names(off), parameters)
    _limit(new, budget)
    for renderer in renderers:
        vtkGILook.RemoveFrom(renderer)
    current = renderers[0].GetPass()
    gi = current if isinstance(current, vtkGIPass) else new
    gi.SetPreset(preset)
    for renderer in renderers:
        loaded.ApplyTo(renderer, gi)
        renderer.SetPass(gi)
    _apply(gi, _names(on), _names(off), parameters)
    _limit(gi, budget)
    return gi


def _limit(gi, budget):
    gi.SetUseDesiredUpdateRate(budget == "auto")
    milliseconds = 0 if budget == "auto" else budget
    try:
        with _quiet():
            done = gi.SetFrameBudget(float(milliseconds))
    except (TypeError, ValueError):
        done = False
    if not done:
        raise ValueError(f"a frame budget cannot be {budget!r}: give milliseconds from 1 to 10000, 'auto', or 0 for none")


def _load_look(name):
    loaded = vtkGILook()
    if not loaded.Load(str(name)):
        raise ValueError(loaded.GetLastError())
    return loaded


def _apply(gi, on, off, parameters):
    for name in on:
        _technique(gi, name).EnabledOn()
    for name in off:
        _technique(gi, name).EnabledOff()
    for name, value in parameters.items():
        _set(gi, name.replace("__", ".").replace("_", "-"), value)


def disable(target):
    """Let stock VTK draw a renderer, or every renderer in layer 0 of a window, with its own lights and background."""
    for renderer in _renderers(target):
        vtkGILook.RemoveFrom(renderer)
        gi = renderer.GetPass()
        if isinstance(gi, vtkGIPass):
            if renderer.GetRenderWindow() is not None:
                gi.ReleaseGraphicsResources(renderer.GetRenderWindow())
            renderer.SetPass(None)


def load_bake(gi, path):
    """Give baked light to its technique of a pass, and switch that on. Returns the technique.

    Raises ValueError, with a sentence, for a file that holds no baked light, is damaged, or was altered.
    """
    open(path, "rb").close()  # FileNotFoundError and the like
    file = vtkGIBakeFile()
    technique = file.Load(str(path), gi)
    if technique is None:
        raise ValueError(file.GetLastError())
    return technique


def presets():
    """Return the names of the presets, from no techniques to the most expensive."""
    return [vtkGIPass.GetPresetName(i) for i in range(vtkGIPass.GetNumberOfPresets())]


def looks():
    """Return a list of all looks, each a Look, those of the folder PENUMBRA_LOOK_PATH included.

    Raises ValueError, with a sentence, if a file in that folder has a mistake.
    """
    names = [vtkGILook.GetLookName(i) for i in range(vtkGILook.GetNumberOfLooks())]
    loaded = [_load_look(name) for name in names]
    return [Look(look.GetName(), look.GetTitle(), look.GetDescription()) for look in loaded]


def techniques():
    """Return a list of all techniques, each a Technique with its parameters."""
    gi = vtkGIPass()
    return [_describe(gi.GetTechnique(i)) for i in range(gi.GetNumberOfTechniques())]


def _describe(t):
    return Technique(
        t.GetName(), t.GetTitle(), t.GetTerm(), t.GetVerb(), t.GetApproach(), t.GetDynamic(), t.GetSource(),
        tuple(_parameter(t, i) for i in range(t.GetNumberOfParameters())))


def _parameter(t, i):
    kind = t.GetParameterType(i)
    values = tuple(t.GetParameterValueName(i, v) for v in range(t.GetNumberOfParameterValues(i)))
    default = t.GetParameterDefault(i)
    if kind == "bool":
        default = bool(default)
    elif kind == "int":
        default = int(default)
    elif kind == "enum":
        default = values[int(default)]
    return Parameter(t.GetParameterName(i), kind, t.GetParameterUnit(i),
                     t.GetParameterDocumentation(i), default, t.GetParameterMinimum(i),
                     t.GetParameterMaximum(i), values)


def frame_chart(gi, path, size=(1200, 500), title=""):
    """Write a chart (.svg) of where the time of a pass's last frame went, and what more time would buy. Needs
    gi.CollectStatisticsOn(). Raises ValueError, with a sentence, if that is impossible."""
    chart = vtkGIFrameChart()
    chart.SetTitle(title)
    if not str(path).endswith(".svg"):
        raise ValueError(f"the chart cannot be written to '{path}': give a name that ends with .svg")
    if not statistics(gi):
        raise ValueError("no frame was measured: call CollectStatisticsOn() on the pass, and draw a frame")
    if not chart.SetStatistics(gi.GetStatistics()) or not chart.WriteSVG(str(path), *size):
        raise ValueError(chart.GetLastError())


def statistics(gi):
    """Return the statistics of a pass's last frame as a dictionary. Needs gi.CollectStatisticsOn()."""
    return json.loads(gi.GetStatistics() or "{}")
