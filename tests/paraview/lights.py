# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: give a light a shape and save the state, or load it in a new process.

usage: lights.py save|load FOLDER
"""
import sys

import scenes
from paraview import simple
from PIL import Image
from penumbra.paraview import enable, shape_light

action, folder = sys.argv[1], sys.argv[2]
simple._DisableFirstRenderCameraReset()
if action == "save":
    view = scenes.make_view()
    scenes.show(view, scenes.sources())
    enable(view, "off", on="shadow-maps")
    lamp = simple.AddLight(view=view)
    lamp.Type, lamp.Position, lamp.FocalPoint, lamp.ConeAngle = "Positional", [-20, -10, 40], [0, 0, 0], 180
    point = scenes.picture(view)
    for bad in ({"disc": -1}, {"disc": 1, "radius": 1}, {"rectangle": 1}, {"angle": 91}):
        try:
            shape_light(lamp, **bad)
            print("accepted", bad)
        except ValueError:
            pass
    shape_light(lamp, disc=5)
    shape_light(lamp)
    print(f"removed: {scenes.within(point, scenes.picture(view), 0):.4f}")
    shape_light(lamp, rectangle=(60, 20))
    image = scenes.picture(view)
    print(f"shape changes: {1 - scenes.within(point, image):.4f}")
    simple.SaveState(f"{folder}/lights.pvsm")
else:
    simple.LoadState(f"{folder}/lights.pvsm")
    image = scenes.picture(simple.GetActiveView())
Image.fromarray(image).save(f"{folder}/lights-{action}.png")
