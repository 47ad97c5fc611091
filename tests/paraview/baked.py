# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: bake probes in a view and write them to a file, or read the file in a new process.

usage: baked.py bake|load FOLDER
"""
import sys

import scenes
from paraview import simple
from PIL import Image
from penumbra.paraview import bake_probes, enable

action, folder = sys.argv[1], sys.argv[2]
probes = f"{folder}/probes.vti"
simple._DisableFirstRenderCameraReset()
view = scenes.make_view()
scenes.show(view, scenes.sources())
lamp = simple.AddLight(view=view)
lamp.Position, lamp.FocalPoint = [-20, -10, 40], [0, 0, 0]
enable(view, "off")
plain = scenes.picture(view)


def problem():
    simple.Render(view)
    view.UpdatePropertyInformation()
    return view.GetProperty("GISHProbesProblem").GetData()


if action == "bake":
    try:
        bake_probes(view, folder, probes=27, samples=1)
    except RuntimeError as error:
        print("to a folder:", error)
    with open(f"{probes}.part", "w") as part:
        part.write("a bake that the command can resume")
    bake_probes(view, probes, probes=100, samples=64)
    with open(f"{probes}.part") as part:
        print("partial bake:", part.read())
    image = scenes.picture(view)
    print(f"changed {1 - scenes.within(image, plain):.5f}")
else:
    view.GISHProbes = 1
    view.GISHProbesFile = probes
    image = scenes.picture(view)
    print("problem with it:", problem() or "none")
    with open(f"{folder}/cut.vti", "wb") as cut, open(probes, "rb") as whole:
        cut.write(whole.read()[:20000])
    for name in ("nothing.vti", "bake.png", "cut.vti"):
        view.GISHProbesFile = f"{folder}/{name}"
        print("problem:", problem())
        print(f"unlit {scenes.within(scenes.picture(view), plain, 0):.5f}")
    view.GISHProbesFile = probes
    print(f"again {scenes.within(scenes.picture(view), image, 0):.5f}")
    simple.SaveState(f"{folder}/baked.pvsm")
    simple.ResetSession()
    simple.LoadState(f"{folder}/baked.pvsm")
    view = simple.GetActiveView()
    print(f"from a state {scenes.within(scenes.picture(view), image, 0):.5f}")
    lamp = simple.GetLight(0, view)
    lamp.Intensity = 0.5
    simple.Render(view)
Image.fromarray(image).save(f"{folder}/{action}.png")
