# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: the frame budget while the camera moves and in still pictures, and the chart of a frame's cost. Prints
shares of equal pixels.

usage: budget.py FOLDER
"""
import sys

import scenes
from paraview import simple
from penumbra.paraview import disable, enable

folder = sys.argv[1]
simple._DisableFirstRenderCameraReset()
# Their frames depend on earlier ones by design.
STEADY = ["temporal-accumulation", "anti-aliasing"]
CHART = (660, 260)  # pixels from the lower left corner that the chart may cover


def report(name, value):
    print(f"{name}: {value:.5f}", flush=True)


def turned(view):
    """The first frame while the camera moves, and the screenshot when it is back."""
    view.CameraPosition = [30, -45, 20]
    view.SMProxy.InteractiveRender()
    moved = scenes.capture(view)
    for i in range(6):
        view.CameraPosition = [30 + i, -45, 20]
        view.SMProxy.InteractiveRender()
    scenes.aim(view)
    return moved, scenes.picture(view), scenes.saved(view, f"{folder}/still.png")


def budgets(view):
    enable(view, frames=3, off=STEADY)
    free = turned(view)
    enable(view, frames=3, off=STEADY, budget=1.0)
    limited = turned(view)  # each budget starts with the lowest levels
    report("moving is lowered", 1 - scenes.within(free[0], limited[0], 0))
    report("still", scenes.within(free[1], limited[1], 0))
    report("screenshot", scenes.within(free[2], limited[2], 0))
    for value in (0.25, 10000, 0):  # the pass itself refuses the first
        view.GIFrameBudget = value
        simple.Render(view)
    for value in (0.5, -1, 1e9, float("nan")):
        try:
            enable(view, budget=value)
        except ValueError as error:
            print("refused:", error)


def charts_in(renderer):
    props = renderer.GetViewProps()
    return sum(props.GetItemAsObject(i).IsA("vtkContextActor") for i in range(props.GetNumberOfItems()))


def averaged(view, chart):
    """A mean of three frames. chart: show the chart from the third on."""
    view.CameraPosition = [50, -45, 20]
    simple.Render(view)
    scenes.aim(view)
    for _ in range(2):
        simple.Render(view)
    view.GIFrameChart = int(chart)
    return scenes.picture(view)


def chart():
    view = scenes.make_view()
    view.ViewSize = [700, 320]
    scenes.show(view, scenes.sources())
    enable(view, off="temporal-accumulation")
    layer = view.GetClientSideObject().GetNonCompositedRenderer()
    without = averaged(view, False)
    shot = scenes.saved(view, f"{folder}/without.png", view.ViewSize)
    shown = averaged(view, True)
    print("charts", charts_in(layer), end=" ")
    covered = shown[-CHART[1]:, :CHART[0]], without[-CHART[1]:, :CHART[0]]
    report("chart covers", 1 - scenes.within(*covered))
    report("beside it", min(scenes.within(shown[:-CHART[1]], without[:-CHART[1]], 0),
                            scenes.within(shown[:, CHART[0]:], without[:, CHART[0]:], 0)))
    report("screenshot has none", scenes.within(shot, scenes.saved(view, f"{folder}/with.png", view.ViewSize), 0))
    view.GIFrameBudget = 20
    for i in range(4):
        view.CameraPosition = [34 + i, -42, 22]
        view.SMProxy.InteractiveRender()
    scenes.Image.fromarray(scenes.capture(view)).save(f"{folder}/chart_moving.png")
    counts = []
    for change in (lambda: setattr(view, "GIFrameChart", 0), lambda: setattr(view, "GIFrameChart", 1),
                   lambda: disable(view), lambda: enable(view)):
        change()
        counts.append(charts_in(layer))
    simple.Delete(view)
    del view, change  # the last references
    counts.append(charts_in(layer))
    print("charts after off, on, without light, with light, deleted:", counts)


main = scenes.make_view()
scenes.show(main, scenes.sources())
budgets(main)
simple.Delete(main)
chart()
