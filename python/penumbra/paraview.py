# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Global illumination in ParaView's render views, for pvpython and pvbatch.

    from penumbra.paraview import enable
    enable(view, preset="balanced")

Importing it loads ParaView's plugin. A view made afterwards has every switch and parameter among its own
properties (GlobalIllumination, GIShadowMaps, GIShadowMapsResolution...); enable() and disable() work with views
made before, too.
"""
import pathlib

import penumbra  # first: it lets windows be made where there is no display
from paraview import servermanager, simple

from .passes import _apply, _names, presets
from .vtkRenderingGI import vtkGIPass

__all__ = ["enable", "disable", "bake_probes", "load", "settings"]

_GROUP = "global_illumination"


def _plugin():
    try:
        from ._plugin_path import PLUGIN
    except ImportError:
        raise ImportError("this build of Penumbra has no plugin for ParaView: ParaView's development files "
                          "(paraview-dev) were not there when it was built") from None
    path = (pathlib.Path(__file__).parent / PLUGIN).resolve()
    if not path.exists():
        raise ImportError(f"ParaView's plugin is missing: there is no {path}; build or install Penumbra anew")
    return str(path)


def _is_loaded():
    manager = servermanager.ProxyManager()
    return manager is not None and manager.SMProxyManager.GetPrototypeProxy(_GROUP, "Settings") is not None


def load(remote_plugin=None):
    """Load the plugin here, and on the server that ParaView is connected to, if any.

    remote_plugin: where the plugin lies on the server, if not at the same path as here. Called when this module is
    imported and by enable(); to be called again only where the server's path differs.
    """
    connection = servermanager.ActiveConnection
    simple.LoadPlugin(_plugin(), remote=False)
    if connection is not None and connection.IsRemote():
        simple.LoadPlugin(remote_plugin or _plugin(), remote=True)
    _forget_class(connection)
    if connection is not None and not _is_loaded():
        raise RuntimeError("ParaView did not take the plugin: see its message above")


def _forget_class(connection):
    """ParaView keeps the Python class of a kind of view that was made before: let it make one with the new properties."""
    kinds = getattr(connection, "ProxiesNS", None)
    for namespace in kinds.getNamespaces().values() if kinds is not None else ():
        vars(namespace).pop("RenderView", None)


def _render_view(view):
    view = view or simple.GetActiveView()
    if view is None:
        raise ValueError("there is no active view: make one with GetActiveViewOrCreate('RenderView')")
    if not view.SMProxy.IsA("vtkSMRenderViewProxy"):
        raise TypeError(f"global illumination needs a render view, not a {view.GetXMLLabel()}")
    return view


def settings(view=None):
    """The proxy that holds a render view's settings: the view itself, or one beside it where the view is older than
    the plugin. Its properties are those that docs/paraview.md lists."""
    view = _render_view(view)
    if view.SMProxy.GetProperty("GlobalIllumination"):
        return view
    if not _is_loaded():
        load()
    manager = servermanager.ProxyManager()
    name = f"GlobalIllumination{view.GetGlobalID()}"
    held = manager.SMProxyManager.GetProxy(_GROUP, name)
    if held is None:
        held = manager.SMProxyManager.NewProxy(_GROUP, "Settings")
        held.GetProperty("GIView").AddProxy(view.SMProxy)
        held.UpdateVTKObjects()
        manager.SMProxyManager.RegisterProxy(_GROUP, name, held)
    return servermanager._getPyProxy(held)


def enable(view=None, preset="balanced", on=(), off=(), frames=1, **parameters):
    """Light a render view, the active one by default, by Penumbra; give the proxy with its settings.

    on, off: techniques to switch besides the preset's. frames: how many are drawn for one still picture; techniques
    that collect light over frames want several. Parameters are named technique.parameter or, with underscores,
    technique__parameter, as in penumbra.enable():

        enable(view, "high", off="ambient-occlusion", shadow_maps__resolution=1024)

    An unknown name or a value out of range raises ValueError and changes nothing.
    """
    view = _render_view(view)
    if preset not in presets():
        raise ValueError(f"there is no preset '{preset}': there are {', '.join(presets())}")
    if frames < 1:
        raise ValueError(f"frames is {frames}: at least one frame must be drawn")
    wanted = vtkGIPass()
    _apply(wanted, preset, _names(on), _names(off), parameters)
    proxy = settings(view)
    for name, value in _values(wanted, proxy):
        _set(proxy, name, value)
    _set(proxy, "GIStillFrames", frames)
    _set(proxy, "GlobalIllumination", 1)
    proxy.SMProxy.UpdateVTKObjects()
    return proxy


def disable(view=None):
    """Give a render view, the active one by default, back to ParaView."""
    proxy = settings(view)
    _set(proxy, "GlobalIllumination", 0)
    proxy.SMProxy.UpdateVTKObjects()


def bake_probes(view=None, file="", probes=1024, samples=256):
    """Bake probes of the light in a render view's scene as it is now, and light the view by them (sh-probes).

    file: where they are written (.vti), so that a later session or a state file has them; without, they are gone with
    the view. probes, samples: how many at most, and paths from each. Lamps that follow the camera, as ParaView's light
    kit does, are left out. Raises RuntimeError, with a sentence, where it cannot be done.
    """
    proxy = settings(view)
    for name, value in (("File", str(file)), ("Count", probes), ("Samples", samples)):
        _set(proxy, f"GISHProbes{name}", value)
    proxy.SMProxy.UpdateVTKObjects()
    proxy.SMProxy.InvokeCommand("GISHProbesBake")
    proxy.SMProxy.UpdatePropertyInformation()
    problem = proxy.SMProxy.GetProperty("GISHProbesProblem").GetElement(0)
    if problem:
        raise RuntimeError(problem)
    _set(proxy, "GISHProbes", 1)
    proxy.SMProxy.UpdateVTKObjects()


def _set(proxy, name, value):
    proxy.SMProxy.GetProperty(name).SetElement(0, value)


def _property_names(proxy):
    iterator = proxy.SMProxy.NewPropertyIterator()
    iterator.UnRegister(None)
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey()
        iterator.Next()


def _values(gi, proxy):
    """(property, value) of every switch and parameter of a pass."""
    known = {name.lower(): name for name in _property_names(proxy)}
    for i in range(gi.GetNumberOfTechniques()):
        technique = gi.GetTechnique(i)
        stem = technique.GetClassName()[len("vtk"):]
        yield stem, int(technique.GetEnabled())
        for j in range(technique.GetNumberOfParameters()):
            name = technique.GetParameterName(j)
            value = technique.GetParameter(name)
            whole = technique.GetParameterType(j) != "double"
            yield known[(stem + name.replace("-", "")).lower()], int(value) if whole else value


load()
