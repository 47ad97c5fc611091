# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: animation, layouts, interaction, selection, annotation and other settings of a view, with global
illumination on; prints shares of equal pixels.

usage: session.py FOLDER
"""
import sys

import numpy
import scenes
from paraview import simple
from PIL import Image
from penumbra.paraview import disable, enable

folder = sys.argv[1]
simple._DisableFirstRenderCameraReset()
width, height = scenes.SIZE


def saved(target, name, *size, **options):
    return scenes.saved(target, f"{folder}/{name}.png", *size, **options)


def tell(name, value):
    print(f"{name}: {value:.5f}", flush=True)


def animation(view, things):
    """A ball that moves and a lamp that is dimmed: each frame is that of its time, whatever came before."""
    ball = things[2][0]
    lamp = simple.AddLight(view=view)
    lamp.Position, lamp.FocalPoint, lamp.Intensity = [-20, -10, 40], [0, 0, 0], 0.8
    enable(view, frames=4)
    times = simple.GetAnimationScene()
    times.PlayMode, times.NumberOfFrames, times.StartTime, times.EndTime = "Sequence", 5, 0.0, 1.0
    for proxy, name, index, first, last in ((ball, "Center", 0, 9.0, -9.0), (lamp, "LightIntensity", 0, 0.8, 0.1)):
        track = simple.GetAnimationTrack(name, index, proxy)
        track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=time, KeyValues=[value])
                           for time, value in ((0.0, first), (1.0, last))]
    simple.SaveAnimation(f"{folder}/frame.png", view, ImageResolution=list(scenes.SIZE), FrameWindow=[0, 4])
    frames = [numpy.asarray(Image.open(f"{folder}/frame.{i:04d}.png"))[..., :3] for i in range(5)]
    equal = []
    for i in (4, 1, 3, 0, 2):
        times.AnimationTime = i / 4
        equal.append(scenes.within(frames[i], saved(view, f"time{i}"), 0))
    tell("animation", min(equal))
    tell("animation moves", min(1 - scenes.within(a, b) for a, b in zip(frames, frames[1:])))
    times.AnimationTime = 0
    simple.RemoveLight(lamp)


def layout(view, things):
    """Two views with settings of their own, in one picture and each by itself."""
    other = scenes.make_view()
    scenes.show(other, things)
    enable(view, "fast", frames=2)
    scenes.rest(other)
    shared = simple.CreateLayout("both")
    shared.SplitHorizontal(0, 0.5)
    shared.AssignView(1, view)
    shared.AssignView(2, other)
    shared.SetSize(2 * width, height)
    both = saved(shared, "both", (2 * width, height), SeparatorWidth=0)
    left, right = both[:, :view.ViewSize[0]], both[:, -other.ViewSize[0]:]
    tell("left view", scenes.within(left, saved(view, "left", view.ViewSize)))
    tell("right view", scenes.within(right, saved(other, "right", other.ViewSize)))
    narrow = min(left.shape[1], right.shape[1])
    tell("views differ", 1 - scenes.within(left[:, :narrow], right[:, :narrow]))
    simple.Delete(other)


def interaction(view):
    """Frames while the camera moves: of what is reduced, each drawn once however many a still picture wants."""
    view.LODThreshold = 0.0
    still, moved = {}, {}
    steady = ["temporal-accumulation", "anti-aliasing"]  # whose frames depend on those before, as they should
    for frames in (1, 8):
        enable(view, frames=frames, off=steady)
        still[frames] = saved(view, f"still{frames}")
        view.CameraPosition = [30, -45, 20]
        view.SMProxy.InteractiveRender()
        moved[frames] = scenes.capture(view)
        scenes.aim(view)
    plain_view = view.SMProxy
    disable(view)
    view.CameraPosition = [30, -45, 20]
    plain_view.InteractiveRender()
    plain = scenes.capture(view)
    scenes.aim(view)
    enable(view, frames=8, off=steady)
    tell("interactive frames", scenes.within(moved[1], moved[8], 0))
    tell("interactive is lit", 1 - scenes.within(moved[1], plain))
    tell("after interaction", scenes.within(saved(view, "after"), still[8], 0))


def selected(view, source):
    simple.SetActiveSource(source)
    simple.SetActiveView(view)
    simple.SelectSurfaceCells(Rectangle=[width // 4, height // 4, 3 * width // 4, 3 * height // 4], View=view)
    chosen = source.GetSelectionInput(source.Port)
    ids = [list(part.IDs) for part in chosen.Input] if chosen is not None else []
    simple.ClearSelection()
    return ids


def selection(view, things):
    """What is selected and picked is what it would be without."""
    disable(view)
    simple.Render(view)
    surface = things[1][0]
    without, picked = selected(view, surface), view.SMProxy.Pick(width // 2, height // 2)
    enable(view)
    simple.Render(view)
    lit, with_light = selected(view, surface), view.SMProxy.Pick(width // 2, height // 2)
    print("selected", [len(part) // 2 for part in lit])
    tell("selection", float(lit == without and sum(map(len, lit)) > 100))
    tell("pick", float(picked is not None and picked == with_light))


def annotation(view, things):
    """The pixels that the axes and the scalar bar change in ParaView's picture are the same with light."""
    shown = simple.GetRepresentation(things[1][0], view)
    pictures = {}
    for lit in (0, 1):
        for noted in (0, 1):
            enable(view) if lit else disable(view)
            view.OrientationAxesVisibility = noted
            view.CameraPosition = [70, -86, 44]  # things are small: background behind what is noted
            shown.SetScalarBarVisibility(view, bool(noted))
            pictures[lit, noted] = saved(view, f"annotation{lit}{noted}").astype(int)
    scenes.aim(view)
    view.OrientationAxesVisibility = 0
    shown.SetScalarBarVisibility(view, False)
    # Where light changes nothing behind them: text is blended with it.
    empty = (numpy.abs(pictures[0, 0] - pictures[1, 0]).max(axis=2) <= 1)
    drawn = (numpy.abs(pictures[0, 0] - pictures[0, 1]).max(axis=2) > 8) & empty
    same = numpy.abs(pictures[0, 1] - pictures[1, 1]).max(axis=2) <= 2
    print("annotation has", int(drawn.sum()), "pixels")
    tell("annotation", float(same[drawn].mean()) if drawn.sum() > 100 else 0.0)


def toggles(view):
    """ParaView's own settings, switched on and off again while the light is on."""
    enable(view, frames=2)
    before, after = saved(view, "before"), []
    for name in ("UseSSAO", "UseFXAA", "UseToneMapping", "EnableRayTracing", "HiddenLineRemoval"):
        if name == "EnableRayTracing" and not view.GetProperty("BackEnd").Available:
            print("this ParaView has no OSPRay")
            continue
        was = view.GetProperty(name).GetData()
        view.GetProperty(name).SetData(1 - was)
        changed = saved(view, name)
        view.GetProperty(name).SetData(was)
        print(f"{name} equal {scenes.within(before, changed):.5f}")
        if name == "UseToneMapping":
            tell("tone mapping changes", 1 - scenes.within(before, changed))
        after.append(scenes.within(before, saved(view, "again"), 0))
    print("after each", after)
    tell("after toggles", min(after))


def parallel(view):
    """Parallel projection, as tiles and at once."""
    view.CameraParallelProjection, view.CameraParallelScale = 1, 18
    scenes.rest(view)
    large = (2 * width, 2 * height)
    tiles = saved(view, "parallel_tiles", large)
    view.ViewSize = large
    tell("parallel as tiles", scenes.within(tiles, saved(view, "parallel", large)))
    view.ViewSize = scenes.SIZE
    view.CameraParallelProjection = 0


view = scenes.make_view()
things = scenes.sources()
scenes.show(view, things)
simple.Render(view)
interaction(view)
selection(view, things)
annotation(view, things)
toggles(view)
parallel(view)
animation(view, things)
layout(view, things)
