# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: representations and settings of a view, drawn by ParaView, by the pass with all techniques off, and with
the preset balanced. Prints the share of pixels that are equal in the first two, and that the third changes.

usage: representations.py FOLDER [CASE]
"""
import sys

import scenes
from paraview import simple
from PIL import Image
from penumbra.paraview import disable, enable

simple._DisableFirstRenderCameraReset()
folder, chosen = sys.argv[1], sys.argv[2:]


def surface(view, kind="Surface", **properties):
    sources = scenes.sources()
    scenes.show(view, sources)
    shown = simple.GetRepresentation(sources[1][0], view)
    shown.SetRepresentationType(kind)
    for name, value in properties.items():
        setattr(shown, name, value)
    return sources[1][0], shown


def glyphs(view):
    ball = simple.Sphere(ThetaResolution=12, PhiResolution=12, Radius=8)
    shown = simple.Show(ball, view)
    shown.SetRepresentationType("3D Glyphs")
    shown.GlyphType = "Cone"
    shown.ScaleFactor = 3
    scenes.aim(view)


def volume(view):
    shown = simple.Show(simple.Wavelet(), view)
    shown.SetRepresentationType("Volume")
    simple.ColorBy(shown, ("POINTS", "RTData"))
    scenes.show(view, scenes.sources()[:1])


def scalar_bar(view):
    _, shown = surface(view)
    shown.SetScalarBarVisibility(view, True)
    view.OrientationAxesVisibility = 1


def axes(view):
    surface(view)
    view.AxesGrid.Visibility = 1


def selection(view):
    source, _ = surface(view)
    simple.SelectCells("(id > 1000) & (id < 3000)", source)


def composite(view):
    simple.Show(simple.GroupDatasets(Input=[row[0] for row in scenes.sources()]), view)
    scenes.aim(view)


def view_property(**properties):
    def case(view):
        surface(view)
        for name, value in properties.items():
            setattr(view, name, value)
    return case


CASES = {
    "edges": lambda view: surface(view, "Surface With Edges"),
    "wireframe": lambda view: surface(view, "Wireframe"),
    "points": lambda view: surface(view, "Points", PointSize=3),
    "gaussians": lambda view: surface(view, "Point Gaussian", GaussianRadius=0.2),
    "outline": lambda view: surface(view, "Outline"),
    "translucent": lambda view: surface(view, Opacity=0.5),
    "specular": lambda view: surface(view, Specular=0.8),
    "pbr": lambda view: surface(view, Interpolation="PBR", Roughness=0.4, Metallic=0.3),
    "glyphs": glyphs,
    "volume": volume,
    "scalar_bar": scalar_bar,
    "axes": axes,
    "selection": selection,
    "composite": composite,
    "parallel": view_property(CameraParallelProjection=1, CameraParallelScale=18),
    "gradient": view_property(BackgroundColorMode="Gradient"),
    "no_fxaa": view_property(UseFXAA=0),
    "tone_mapping": view_property(UseToneMapping=1),
    "hidden_lines": view_property(HiddenLineRemoval=1),
    "no_light_kit": view_property(UseLight=0),
}

# The pass rounds its picture to the window's eight bits before ParaView's tone mapping, which amplifies the rounding.
LIMITS = {"tone_mapping": 4}

for name, case in CASES.items():
    if chosen and name not in chosen:
        continue
    view = scenes.make_view()
    case(view)
    plain = scenes.picture(view)
    enable(view, "off")
    off = scenes.picture(view)
    enable(view, "balanced")
    lit = scenes.picture(view)
    disable(view)
    after = scenes.picture(view)
    for kind, image in (("plain", plain), ("off", off), ("lit", lit)):
        Image.fromarray(image).save(f"{folder}/{name}_{kind}.png")
    print(f"{name}: off {scenes.within(plain, off, LIMITS.get(name, 2)):.5f} balanced_changes {1 - scenes.within(plain, lit):.5f} "
          f"after {scenes.within(plain, after):.5f}", flush=True)
    simple.Delete(view)
    del view
    simple.ClearSelection()
