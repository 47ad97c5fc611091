# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Global illumination in ParaView's render views, for pvpython and pvbatch.

    from penumbra.paraview import enable
    enable(view, preset="balanced")

Importing it loads ParaView's plugin. Views that are created afterwards have all switches and parameters as properties
(GlobalIllumination, GIShadowMaps, GIShadowMapsResolution...). enable() and disable() also work with older views.
"""
import pathlib

import penumbra  # first, so that windows can be created without a display
from paraview import servermanager, simple

from .passes import _apply, _load_look, _names, presets
from .vtkRenderingGI import vtkGIPass

__all__ = ["enable", "disable", "bake_probes", "load", "settings", "shape_light"]

_GROUP = "global_illumination"


def _plugin():
    try:
        from ._plugin_path import PLUGIN
    except ImportError:
        raise ImportError("this build of Penumbra has no plugin for ParaView: ParaView's development files "
                          "(paraview-dev) were not there when it was built") from None
    path = (pathlib.Path(__file__).parent / PLUGIN).resolve()
    if not path.exists():
        raise ImportError(f"ParaView's plugin is missing: there is no {path}; build or install Penumbra again")
    return str(path)


def _is_loaded():
    manager = servermanager.ProxyManager()
    return manager is not None and manager.SMProxyManager.GetPrototypeProxy(_GROUP, "Settings") is not None


def load(remote_plugin=None):
    """Load the plugin here, and on the server that ParaView is connected to, if any.

    remote_plugin: path of the plugin on the server, if it differs from the local path. Importing this module and
    enable() call this function. Call it again only if the server's path differs.
    """
    connection = servermanager.ActiveConnection
    simple.LoadPlugin(_plugin(), remote=False)
    if connection is not None and connection.IsRemote():
        simple.LoadPlugin(remote_plugin or _plugin(), remote=True)
    _forget_class(connection)
    if connection is not None and not _is_loaded():
        raise RuntimeError("ParaView did not take the plugin: see its message above")


def _forget_class(connection):
    """Let ParaView create the Python classes of render views and lights again, with the new properties."""
    kinds = getattr(connection, "ProxiesNS", None)
    for namespace in kinds.getNamespaces().values() if kinds is not None else ():
        for name in ("RenderView", "Light"):
            vars(namespace).pop(name, None)


def _render_view(view):
    view = view or simple.GetActiveView()
    if view is None:
        raise ValueError("there is no active view: make one with GetActiveViewOrCreate('RenderView')")
    if not view.SMProxy.IsA("vtkSMRenderViewProxy"):
        raise TypeError(f"global illumination needs a render view, not a {view.GetXMLLabel()}")
    return view


def settings(view=None):
    """Return the proxy that holds a render view's settings. Its properties are listed in docs/paraview.md.

    It is the view itself, or a separate proxy if the view is older than the plugin.
    """
    view = _render_view(view)
    if view.SMProxy.GetProperty("GlobalIllumination"):
        return view
    if not _is_loaded():
        load()
    manager = servermanager.ProxyManager()
    name = f"GlobalIllumination{view.GetGlobalID()}"
    found = manager.SMProxyManager.GetProxy(_GROUP, name)
    if found is None:
        found = manager.SMProxyManager.NewProxy(_GROUP, "Settings")
        found.GetProperty("GIView").AddProxy(view.SMProxy)
        found.UpdateVTKObjects()
        manager.SMProxyManager.RegisterProxy(_GROUP, name, found)
    return servermanager._getPyProxy(found)


def enable(view=None, preset="balanced", on=(), off=(), look="as-is", frames=1, budget=0.0, **parameters):
    """Light a render view, the active one by default, with Penumbra. Returns the proxy with its settings.

    on, off: techniques to switch on or off, in addition to the preset's. look: the name or the file of a look, which
    replaces the view's lights and background; its settings come after all others. frames: number of frames drawn for one still
    picture; techniques that accumulate light need several. budget: milliseconds that a frame may take while the camera moves,
    from 1 to 10000, or 0 for no limit. Parameters are named technique.parameter or, with
    underscores, technique__parameter, as in penumbra.enable():

        enable(view, "high", off="ambient-occlusion", shadow_maps__resolution=1024)

    An unknown name or a value out of range raises ValueError and changes nothing.
    """
    view = _render_view(view)
    if preset not in presets():
        raise ValueError(f"there is no preset '{preset}': there are {', '.join(presets())}")
    if frames < 1:
        raise ValueError(f"frames is {frames}: at least one frame must be drawn")
    if budget != 0 and not 1 <= budget <= 10000:
        raise ValueError(f"a frame budget of {budget} ms is not possible: it must be from 1 to 10000, or 0 for none")
    _load_look(look)
    requested = vtkGIPass()
    requested.SetPreset(preset)
    _apply(requested, _names(on), _names(off), parameters)
    proxy = settings(view)
    for name, value in _values(requested, proxy):
        _set(proxy, name, value)
    _set(proxy, "GILook", str(look))
    _set(proxy, "GIStillFrames", frames)
    _set(proxy, "GIFrameBudget", float(budget))
    _set(proxy, "GlobalIllumination", 1)
    proxy.SMProxy.UpdateVTKObjects()
    return proxy


def disable(view=None):
    """Let ParaView draw a render view, the active one by default, without Penumbra."""
    proxy = settings(view)
    _set(proxy, "GlobalIllumination", 0)
    proxy.SMProxy.UpdateVTKObjects()


def bake_probes(view=None, file="", probes=1024, samples=256):
    """Bake probes of the light in a render view's current scene, and light the view with them (sh-probes).

    file: a file (.vti) to write them to, for later sessions and state files. Without one they are deleted with the
    view. probes: maximum number. samples: number of paths from each. Lights that follow the camera, such as ParaView's
    light kit, are left out. Raises RuntimeError, with a sentence, if baking fails.
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


def shape_light(light, angle=None, radius=None, disc=None, rectangle=None, turn=0.0):
    """Give one of ParaView's lights a size, for soft shadows and broad light: see vtkGILightShape.

    angle: angular diameter of a directional light in degrees. radius, disc: radius of a positional light that is a
    sphere or a disc, in world units. rectangle: its width and height. turn: rotation of the rectangle in degrees.
    Without any of them the light has no shape of its own again. Returns the proxy that holds the shape in the
    properties GIShape, GIAngle, GIRadius, GISize and GITurn: the light, or a separate proxy if it is older than the plugin.

        lamp = AddLight(view=view)
        shape_light(lamp, rectangle=(2, 1))

    A size that is negative or not finite raises ValueError and changes nothing.
    """
    if light.SMProxy.GetXMLName() != "Light":
        raise TypeError(f"only lights that AddLight() makes have a shape, not a {light.SMProxy.GetXMLLabel()}")
    sizes = [("angle", angle), ("radius", radius), ("disc", disc), ("rectangle", rectangle)]
    given = [(name, value) for name, value in sizes if value is not None]
    if len(given) > 1:
        raise ValueError(f"a light has one shape, not {' and '.join(name for name, _ in given)}")
    values = [float(value) for _, size in given for value in (size if hasattr(size, "__len__") else [size])]
    if len(values) != (2 if rectangle is not None else len(given)):
        raise ValueError("a rectangle has a width and a height, and other shapes have one number")
    if not all(0.0 <= value < 1e15 for value in values) or not abs(turn) < float("inf") or (angle or 0) > 90:
        raise ValueError("the size of a light must be positive and finite, and an angle at most 90 degrees")
    proxy = _shape_proxy(light)
    shape = {"angle": 2, "radius": 3, "disc": 4, "rectangle": 5}[given[0][0]] if given else 0
    target = {"angle": "GIAngle", "rectangle": "GISize"}.get(given[0][0], "GIRadius") if given else None
    for index, value in enumerate(values):
        proxy.SMProxy.GetProperty(target).SetElement(index, value)
    _set(proxy, "GITurn", float(turn))
    _set(proxy, "GIShape", shape)
    proxy.SMProxy.UpdateVTKObjects()
    return proxy


def _shape_proxy(light):
    """The proxy that holds a light's shape: the light itself, or a separate one if it is older than the plugin."""
    if light.SMProxy.GetProperty("GIShape"):
        return light
    if not _is_loaded():
        load()
    manager = servermanager.ProxyManager().SMProxyManager
    names = [manager.GetProxyName(_GROUP, i) for i in range(manager.GetNumberOfProxies(_GROUP))]
    shapes = [proxy for proxy in (manager.GetProxy(_GROUP, name) for name in names) if proxy.GetXMLName() == "LightShape"]
    found = next((proxy for proxy in shapes if proxy.GetProperty("Light").GetProxy(0) == light.SMProxy), None)
    if found is None:
        found = manager.NewProxy(_GROUP, "LightShape")
        found.GetProperty("Light").AddProxy(light.SMProxy)
        manager.RegisterProxy(_GROUP, f"LightShape{light.GetGlobalID()}", found)
    return servermanager._getPyProxy(found)


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
    """Yield (property, value) of every switch and parameter of a pass."""
    properties = {name.lower(): name for name in _property_names(proxy)}
    for i in range(gi.GetNumberOfTechniques()):
        technique = gi.GetTechnique(i)
        stem = technique.GetClassName()[len("vtk"):]
        yield stem, int(technique.GetEnabled())
        for j in range(technique.GetNumberOfParameters()):
            name = technique.GetParameterName(j)
            value = technique.GetParameter(name)
            whole = technique.GetParameterType(j) != "double"
            yield properties[(stem + name.replace("-", "")).lower()], int(value) if whole else value


load()
