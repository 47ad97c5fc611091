# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvbatch --sym on several ranks: a flight with a frame budget, during which parts of the data leave the view, so that
not every rank draws every frame. Each rank prints the levels of all its frames, and writes them to a file of its own.

usage: budget_ranks.py FOLDER FRAMES
"""
import json
import sys

import scenes
from paraview import servermanager, simple
from penumbra.paraview import enable

rank = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId()
simple._DisableFirstRenderCameraReset()
view = scenes.make_view()
view.ViewSize = [160, 120]
scenes.show(view, scenes.sources()[1:2])  # each rank has one half of the isosurfaces
simple.Render(view)
enable(view, "balanced", budget=250)
frames = []
for i in range(int(sys.argv[2])):
    if i // 10 % 2:
        # From within the upper half, so that the lower one is behind the camera; then the other way round.
        up = 1 if i // 20 % 2 else -1
        view.CameraPosition, view.CameraFocalPoint = [0, 0.1 * (i % 10), 5 * up], [0, 0, 12 * up]
        view.CameraViewUp = [0, 1, 0]
    else:
        scenes.aim(view)
        view.CameraPosition = [34 - 0.3 * i, -42, 22]
    view.SMProxy.InteractiveRender()
    view.SMProxy.UpdatePropertyInformation()
    budget = json.loads(view.SMProxy.GetProperty("GIStatistics").GetElement(0) or "{}").get("budget") or {}
    frames.append({"state": budget.get("state"), "milliseconds": budget.get("frame"),
                   "levels": {knob["technique"]: knob["level"] for knob in budget.get("knobs", [])}})
    if i % 25 == 24:
        simple.Render(view)  # a still picture between them
with open(f"{sys.argv[1]}/rank{rank}.json", "w") as file:
    json.dump(frames, file)
print("rank", rank, "frames", len(frames), "first", frames[0], "last", frames[-1])
