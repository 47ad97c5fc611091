# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Switches global illumination on and off, and lists presets and techniques."""
import contextlib
import json
from dataclasses import dataclass

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from .vtkRenderingGI import vtkGIBakeFile, vtkGIPass


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

    term: what it computes; verb: its method; dynamic: whether it supports dynamic scenes; source: the literature.
    """
    name: str
    title: str
    term: str
    verb: str
    dynamic: str
    source: str
    parameters: tuple


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


def enable(target, preset="balanced", on=(), off=(), **parameters):
    """Light a renderer, or every renderer in layer 0 of a window, with Penumbra. Returns the pass.

    on, off: techniques to switch on or off, in addition to the preset's. Parameters are named technique.parameter,
    either as on the command line or with underscores:

        enable(renderer, "high", off="ambient-occlusion", shadow_maps__resolution=1024)
        enable(renderer, **{"shadow-maps.resolution": 1024})

    An unknown name or a value out of range raises ValueError and changes nothing. An existing pass is changed, not
    replaced, so that it keeps its GPU resources.
    """
    renderers = _renderers(target)
    if preset not in presets():
        raise ValueError(f"there is no preset '{preset}': there are {', '.join(presets())}")
    # Try the settings on a new pass first, so that a mistake does not change the renderers.
    new = vtkGIPass()
    _apply(new, preset, _names(on), _names(off), parameters)
    current = renderers[0].GetPass()
    if not isinstance(current, vtkGIPass):
        gi = new
    else:
        gi = current
        _apply(gi, preset, _names(on), _names(off), parameters)
    for renderer in renderers:
        renderer.SetPass(gi)
    return gi


def _apply(gi, preset, on, off, parameters):
    gi.SetPreset(preset)
    for name in on:
        _technique(gi, name).EnabledOn()
    for name in off:
        _technique(gi, name).EnabledOff()
    for name, value in parameters.items():
        _set(gi, name.replace("__", ".").replace("_", "-"), value)


def disable(target):
    """Let stock VTK draw a renderer, or every renderer in layer 0 of a window."""
    for renderer in _renderers(target):
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


def techniques():
    """Return a list of all techniques, each a Technique with its parameters."""
    gi = vtkGIPass()
    return [_describe(gi.GetTechnique(i)) for i in range(gi.GetNumberOfTechniques())]


def _describe(t):
    return Technique(
        t.GetName(), t.GetTitle(), t.GetTerm(), t.GetVerb(), t.GetDynamic(), t.GetSource(),
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


def statistics(gi):
    """Return the statistics of a pass's last frame as a dictionary. Needs gi.CollectStatisticsOn()."""
    return json.loads(gi.GetStatistics() or "{}")
