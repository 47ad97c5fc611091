# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: SaveAnimation with the preset high of coloured balls that appear and disappear over a plane. Prints the
error of frames against pictures that new views draw of the same times.

usage: animations.py FOLDER
"""
import sys

import numpy
import penumbra
import scenes
from paraview import simple
from PIL import Image
from penumbra.paraview import enable

FRAMES = 5
COLOURS = ([0.9, 0.1, 0.1], [0.1, 0.8, 0.2], [0.2, 0.3, 0.9])

folder = sys.argv[1]
simple._DisableFirstRenderCameraReset()
balls = [simple.Sphere(Center=[8 * x, 8 * x, -5], Radius=5.5, ThetaResolution=32, PhiResolution=32) for x in (-1, 0, 1)]
plane = simple.Plane(**scenes.GROUND)
wall = simple.Plane(Origin=[-20, -20, -11], Point1=[-20, 20, -11], Point2=[-20, -20, 15])


def make_view():
    view = scenes.make_view()
    scenes.show(view, [(source, None, [0.9, 0.9, 0.9]) for source in (plane, wall)] +
                [(ball, None, colour) for ball, colour in zip(balls, COLOURS)])
    view.UseLight = 0
    lamp = simple.AddLight(view=view)
    lamp.Position, lamp.FocalPoint = [20, -10, 30], [0, 0, 0]
    enable(view, "high", ddgi__probes=343)
    return view


times = simple.GetAnimationScene()
times.PlayMode, times.NumberOfFrames, times.StartTime, times.EndTime = "Sequence", FRAMES, 0.0, 1.0
# Ball i is visible in frames i and i + 1, and tiny in the others.
for i, ball in enumerate(balls):
    track = simple.GetAnimationTrack("Radius", proxy=ball)
    keys = [(0.0, 5.5 if i == 0 else 0.01), ((i - 0.1) / (FRAMES - 1), 5.5), ((i + 1.1) / (FRAMES - 1), 0.01)]
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=max(time, 0.0), KeyValues=[value], Interpolation="Boolean")
                       for time, value in (keys if i else keys[1:])] + [
                           simple.CompositeKeyFrame(KeyTime=1.0, KeyValues=[0.01])]
view = make_view()
simple.SaveAnimation(f"{folder}/film.png", view, ImageResolution=list(scenes.SIZE), FrameWindow=[0, FRAMES - 1])
film = [numpy.asarray(Image.open(f"{folder}/film.{i:04d}.png"))[..., :3] / 255.0 for i in range(FRAMES)]
simple.Delete(view)
for i in (3, 1, 2):
    times.AnimationTime = i / (FRAMES - 1)
    view = make_view()
    truth = scenes.saved(view, f"{folder}/single{i}.png") / 255.0
    simple.Delete(view)
    print(f"frame {i}: {penumbra.relative_error(film[i], truth)[0]:.6f}", flush=True)
print(f"film moves: {min(numpy.abs(a - b).max(axis=2).mean() for a, b in zip(film, film[1:])):.5f}")
