# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvbatch on one or more ranks: draw the scene with direct light only, then frames with a moving camera and the
preset balanced.

usage: ranks.py PICTURE FRAMES
"""
import sys

import scenes
from paraview import servermanager, simple
from penumbra.paraview import disable, enable

simple._DisableFirstRenderCameraReset()
view = scenes.make_view()
scenes.show(view, scenes.sources())
picture = sys.argv[1]
size = list(scenes.SIZE)


def save(name):
    simple.SaveScreenshot(f"{picture}_{name}.png", view, ImageResolution=size)


simple.Render(view)
save("plain")
enable(view, "off")
save("direct")
enable(view, "balanced")
view.ViewSize = [160, 120]
for i in range(int(sys.argv[2])):
    view.CameraPosition = [34 - 0.3 * i, -42, 22]
    simple.Render(view)
view.ViewSize = size
scenes.aim(view)
save("balanced")
disable(view)
save("after")
if servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() > 1:
    scenes.refuse_to_bake(view, f"{picture}.vti")
print("rank", servermanager.vtkProcessModule.GetProcessModule().GetPartitionId(), "done")
