# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: animation, layouts, interaction, selection, annotation and other settings of a view, with global
illumination on. Prints shares of equal pixels.

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


def report(name, value):
    print(f"{name}: {value:.5f}", flush=True)


def animation(view, sources):
    """Frames of a moving ball and a dimming light depend on their time only, not on earlier frames."""
    ball = sources[2][0]
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
    report("animation", min(equal))
    report("animation moves", min(1 - scenes.within(a, b) for a, b in zip(frames, frames[1:])))
    times.AnimationTime = 0
    simple.RemoveLight(lamp)


def layout(view, sources):
    """Two views with different settings, in one picture and separately."""
    other = scenes.make_view()
    scenes.show(other, sources)
    enable(view, "fast", frames=2)
    scenes.settle(other)
    shared = simple.CreateLayout("both")
    shared.SplitHorizontal(0, 0.5)
    shared.AssignView(1, view)
    shared.AssignView(2, other)
    shared.SetSize(2 * width, height)
    both = saved(shared, "both", (2 * width, height), SeparatorWidth=0)
    left, right = both[:, :view.ViewSize[0]], both[:, -other.ViewSize[0]:]
    report("left view", scenes.within(left, saved(view, "left", view.ViewSize)))
    report("right view", scenes.within(right, saved(other, "right", other.ViewSize)))
    narrow = min(left.shape[1], right.shape[1])
    report("views differ", 1 - scenes.within(left[:, :narrow], right[:, :narrow]))
    simple.Delete(other)


def interaction(view):
    """While the camera moves, reduced data is drawn in one frame, even if a still picture takes several."""
    view.LODThreshold = 0.0
    still, moved = {}, {}
    steady = ["temporal-accumulation", "anti-aliasing"]  # their frames depend on earlier ones by design
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
    report("interactive frames", scenes.within(moved[1], moved[8], 0))
    report("interactive is lit", 1 - scenes.within(moved[1], plain))
    report("after interaction", scenes.within(saved(view, "after"), still[8], 0))


def selected(view, source):
    simple.SetActiveSource(source)
    simple.SetActiveView(view)
    simple.SelectSurfaceCells(Rectangle=[width // 4, height // 4, 3 * width // 4, 3 * height // 4], View=view)
    chosen = source.GetSelectionInput(source.Port)
    ids = [list(part.IDs) for part in chosen.Input] if chosen is not None else []
    simple.ClearSelection()
    return ids


def selection(view, sources):
    """Selecting and picking give the same results with and without global illumination."""
    disable(view)
    simple.Render(view)
    surface = sources[1][0]
    without, picked = selected(view, surface), view.SMProxy.Pick(width // 2, height // 2)
    enable(view)
    simple.Render(view)
    lit, with_light = selected(view, surface), view.SMProxy.Pick(width // 2, height // 2)
    print("selected", [len(part) // 2 for part in lit])
    report("selection", float(lit == without and sum(map(len, lit)) > 100))
    report("pick", float(picked is not None and picked == with_light))


def annotation(view, sources):
    """The pixels of the axes and the scalar bar are the same with and without global illumination."""
    shown = simple.GetRepresentation(sources[1][0], view)
    pictures = {}
    for lit in (0, 1):
        for annotated in (0, 1):
            enable(view) if lit else disable(view)
            view.OrientationAxesVisibility = annotated
            view.CameraPosition = [70, -86, 44]  # far away, so that annotations have background behind them
            shown.SetScalarBarVisibility(view, bool(annotated))
            pictures[lit, annotated] = saved(view, f"annotation{lit}{annotated}").astype(int)
    scenes.aim(view)
    view.OrientationAxesVisibility = 0
    shown.SetScalarBarVisibility(view, False)
    # Only where light does not change the background, because text is blended with it.
    empty = (numpy.abs(pictures[0, 0] - pictures[1, 0]).max(axis=2) <= 1)
    drawn = (numpy.abs(pictures[0, 0] - pictures[0, 1]).max(axis=2) > 8) & empty
    same = numpy.abs(pictures[0, 1] - pictures[1, 1]).max(axis=2) <= 2
    print("annotation has", int(drawn.sum()), "pixels")
    report("annotation", float(same[drawn].mean()) if drawn.sum() > 100 else 0.0)


def toggles(view):
    """ParaView's own settings, switched on and off again while global illumination is on."""
    enable(view, frames=2)
    before, after = saved(view, "before"), []
    for name in ("UseSSAO", "UseFXAA", "UseToneMapping", "EnableRayTracing", "HiddenLineRemoval"):
        if name == "EnableRayTracing" and not view.GetProperty("BackEnd").Available:
            print("this ParaView has no OSPRay")
            continue
        original = view.GetProperty(name).GetData()
        view.GetProperty(name).SetData(1 - original)
        changed = saved(view, name)
        view.GetProperty(name).SetData(original)
        print(f"{name} equal {scenes.within(before, changed):.5f}")
        if name == "UseToneMapping":
            report("tone mapping changes", 1 - scenes.within(before, changed))
        after.append(scenes.within(before, saved(view, "again"), 0))
    print("after each", after)
    report("after toggles", min(after))


def looks(view):
    """A look replaces light kit and background; as-is brings both back, and ParaView's values stay what they were."""
    enable(view, "fast", frames=2)
    before = saved(view, "look_before")
    kept = view.Background.GetData(), view.UseLight, view.GIAmbientOcclusionAmbientShare
    enable(view, "fast", frames=2, look="studio")
    studio = saved(view, "look_studio")
    report("look changes", 1 - scenes.within(before, studio))
    report("look kept", scenes.within(studio, saved(view, "look_again"), 0))
    print("look corner", studio[0, 0].tolist())
    view.GISkyLight = 0  # a value below the look
    report("setting below the look", 1 - scenes.within(studio, saved(view, "look_without_sky")))
    view.GISkyLight = 1
    report("look again", scenes.within(studio, saved(view, "look_with_sky")))
    view.GILook = "as-is"
    report("look undone", scenes.within(before, saved(view, "look_after"), 0))
    report("look values", float(kept == (view.Background.GetData(), view.UseLight, view.GIAmbientOcclusionAmbientShare)))
    for name in ("no-such", folder + "/none.json"):
        try:
            enable(view, look=name)
        except ValueError as error:
            print("refused:", error)


def parallel(view):
    """Parallel projection, drawn in tiles and as a whole."""
    view.CameraParallelProjection, view.CameraParallelScale = 1, 18
    scenes.settle(view)
    large = (2 * width, 2 * height)
    tiles = saved(view, "parallel_tiles", large)
    view.ViewSize = large
    report("parallel as tiles", scenes.within(tiles, saved(view, "parallel", large)))
    view.ViewSize = scenes.SIZE
    view.CameraParallelProjection = 0


view = scenes.make_view()
sources = scenes.sources()
scenes.show(view, sources)
simple.Render(view)
interaction(view)
selection(view, sources)
annotation(view, sources)
toggles(view)
looks(view)
parallel(view)
animation(view, sources)
layout(view, sources)
