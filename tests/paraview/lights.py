# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: give a light a shape and save the state, or load it in a new process.

usage: lights.py save|save-older|load STATE PICTURE

save-older: the light is older than the plugin. The state is a .pvsm file, or a script, for lights that have properties.
"""
import pathlib
import sys

import penumbra  # noqa: F401 so that windows can be created without a display
from paraview import simple, smstate

action, state, file = sys.argv[1:]
simple._DisableFirstRenderCameraReset()
if action == "save-older":
    view = simple.CreateView("RenderView")
    lamp = simple.AddLight(view=view)

import scenes  # noqa: E402 loads the plugin
from penumbra.paraview import enable, shape_light  # noqa: E402
from PIL import Image  # noqa: E402

if action.startswith("save"):
    view = scenes.prepare_view(view) if action == "save-older" else scenes.make_view()
    lamp = lamp if action == "save-older" else simple.AddLight(view=view)
    scenes.show(view, scenes.sources())
    enable(view, "off", on="shadow-maps")
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
    shaped = shape_light(lamp, rectangle=(60, 20))
    image = scenes.picture(view)
    print(f"shape changes: {1 - scenes.within(point, image):.4f}")
    print(f"the light has properties: {shaped is lamp}")
    if shaped is lamp:
        lamp.GISize = [6, 2]
        small = scenes.picture(view)
        lamp.GISize = [60, 20]
        print(f"size changes: {1 - scenes.within(small, image):.4f}")
        print(f"size is restored: {scenes.within(scenes.picture(view), image, 0):.4f}")
    if state.endswith(".py"):
        pathlib.Path(state).write_text(smstate.get_state(), encoding="utf-8")
    else:
        simple.SaveState(state)
else:
    if state.endswith(".py"):
        exec(compile(pathlib.Path(state).read_text(encoding="utf-8"), state, "exec"), {"__name__": "__main__"})
    else:
        simple.LoadState(state)
    image = scenes.picture(simple.GetActiveView())
Image.fromarray(image).save(file)
