# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: save a state with global illumination, or load it in a new process.

usage: states.py save|load|run FOLDER      run: load the state's Python script
"""
import sys

import scenes
from paraview import simple, smstate
from PIL import Image
from penumbra.paraview import enable

action, folder = sys.argv[1], sys.argv[2]
simple._DisableFirstRenderCameraReset()
if action == "save":
    view = scenes.make_view()
    scenes.show(view, scenes.sources())
    # Values that differ from the start preset, a value that equals it but not the chosen preset, and a number.
    enable(view, "fast", look="studio", on="screen-space-reflections", off="temporal-accumulation",
           ambient_occlusion__samples=28, shadow_maps__resolution=1024, ambient_occlusion__radius=1.25)
    image = scenes.picture(view)
    simple.SaveState(f"{folder}/state.pvsm")
    with open(f"{folder}/state.py", "w") as file:
        file.write(smstate.get_state())
else:
    if action == "load":
        simple.LoadState(f"{folder}/state.pvsm")
    else:
        exec(compile(open(f"{folder}/state.py").read(), "state.py", "exec"), {"__name__": "__main__"})
    view = simple.GetActiveView()
    image = scenes.picture(view)
    print("samples", view.GIAmbientOcclusionSamples, "radius", view.GIAmbientOcclusionRadius,
          "temporal", view.GITemporalAccumulation, "look", view.GILook.GetData())
Image.fromarray(image).save(f"{folder}/{action}.png")
