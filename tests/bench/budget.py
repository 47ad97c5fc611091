#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame budget: a scripted flight, a constant load, the cost of a pass without one, and the error that it costs.

flight    600 frames around an isosurface that changes: a mesh is loaded, the window grows, a second lamp comes on. Share of frames
          over the budget, and the worst one that is not within ten frames of such a step. Medians of several runs.
constant  the flight without these steps, around a surface that is new in every frame but hardly changes its size: changes of
          levels, those undone within 60 frames, and how much of the budget is used.
drift     the same around the surface of the flight, whose changes make a frame take up to 1.5 times as long.
rest      frames that refine a picture after the camera has stopped, in a window so large that the user's own settings take too long
          for them: the slowest, of the budget or 100 ms, whichever is more. Median of several runs.
error     mean relMSE of frames along a flight against the path tracer, with a budget, and with each fixed preset that never
          exceeds it.
overhead  times of frames without a budget and with one that is never reached, in turns.

The budget is --floors times what a frame takes with the lowest levels after all steps, measured first. Exits with 1 if a limit is exceeded.
"""
import argparse
import sys

import numpy as np
import penumbra
from indirect_light import write
from ray_scenes import Film, Report, tracer
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

STEPS = {150: "a mesh is loaded", 300: "the window grows", 450: "a second lamp comes on"}
SETTLING = 30  # frames until the budget must hold
SWING, TREMBLE = 20, 0.2  # change of the isosurface's value: with its size, and without
NEAR = 10      # frames after a step in which a frame may take longer
WARM = 60      # frames before figures of a constant load
RESPONSIVE = 100  # ms that a frame may take while it refines, whatever the budget


class Flight:
    """A wavelet's isosurface over a floor, lit by a lamp, seen from a camera that flies around it."""

    def __init__(self, size, preset, swing=SWING):
        self.source = vtkRTAnalyticSource()
        self.source.SetWholeExtent(-16, 16, -16, 16, -16, 16)
        self.contour = vtkContourFilter()
        self.contour.SetInputConnection(self.source.GetOutputPort())
        self.contour.SetValue(0, 160)
        self.swing = swing
        renderer = vtkRenderer()
        surface = self.actor(self.contour, (0.9, 0.5, 0.3))
        floor = vtkSphereSource()
        floor.SetThetaResolution(64)
        floor.SetPhiResolution(64)
        floor.SetRadius(60)
        floor.SetCenter(0, 0, -76)
        for actor in (surface, self.actor(floor, (0.7, 0.7, 0.7))):
            renderer.AddActor(actor)
        renderer.SetBackground(0.2, 0.25, 0.3)
        renderer.AutomaticLightCreationOff()
        self.lamp(renderer, (40, -60, 60), 0.9)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, -85, 30)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCameraClippingRange()
        self.size = size
        self.film = Film(renderer, size, preset)
        self.gi = self.film.gi
        self.gi.CollectStatisticsOn()

    @staticmethod
    def actor(source, color):
        normals, mapper, actor = vtkPolyDataNormals(), vtkPolyDataMapper(), vtkActor()
        normals.SetInputConnection(source.GetOutputPort())
        mapper.SetInputConnection(normals.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(color)
        return actor

    @staticmethod
    def lamp(renderer, place, intensity):
        light = vtkLight()
        light.SetPositional(True)
        light.SetConeAngle(180)
        light.SetPosition(place)
        light.SetIntensity(intensity)
        renderer.AddLight(light)

    def step(self, number):
        """Apply the scripted change that precedes a frame, if there is one."""
        renderer = self.film.renderer
        if number == 150:
            ball = vtkSphereSource()
            ball.SetThetaResolution(200)
            ball.SetPhiResolution(200)
            ball.SetRadius(9)
            ball.SetCenter(24, -10, 0)
            renderer.AddActor(self.actor(ball, (0.4, 0.6, 0.9)))
        elif number == 300:
            self.film.window.SetSize(self.size[0] * 5 // 4, self.size[1] * 5 // 4)
        elif number == 450:
            self.lamp(renderer, (-50, -40, 50), 0.5)

    def frame(self, number, steps=True):
        """Draw a frame; returns the statistics of its budget, or only its milliseconds without one."""
        if steps:
            self.step(number)
        if self.swing:
            self.contour.SetValue(0, 160 + self.swing * np.sin(0.02 * number))
        self.film.camera.Azimuth(0.4)
        self.film.renderer.ResetCameraClippingRange()
        seconds = self.film.frame()
        statistics = penumbra.statistics(self.gi)
        return statistics.get("budget", {"frame": 1e3 * seconds})


def budget_of(args, report, steps=(), swing=SWING):
    """The budget: a multiple of the median frame with the lowest levels, after these steps. Says which passes take longest then."""
    lowest = Flight(args.size, args.preset, swing)
    lowest.gi.SetFrameBudget(1)
    for number in steps:
        lowest.step(number)
    times, by_pass = [], {}
    for i in range(60):
        report.going_on(f"lowest levels: frame {i}")
        times.append(lowest.frame(i, False)["frame"])
        for entry in penumbra.statistics(lowest.gi)["passes"] if i >= 20 else ():
            by_pass[entry["name"]] = by_pass.get(entry["name"], 0) + entry["milliseconds"] / 40
    budget = args.floors * float(np.median(times[20:]))
    longest = sorted(by_pass, key=by_pass.get, reverse=True)[:4]
    report.figure("budget, ms", budget, more="at the lowest levels: " + ", ".join(f"{name} {by_pass[name]:.1f}" for name in longest))
    return budget


def levels(budget):
    return {knob["technique"]: knob["level"] for knob in budget["knobs"]}


def flight(args, report):
    budget = budget_of(args, report, STEPS)
    over, worst = [], []
    for run in range(args.runs):
        shot = Flight(args.size, args.preset)
        shot.gi.SetFrameBudget(budget)
        times = []
        for i in range(args.frames):
            report.going_on(f"run {run + 1} of {args.runs}: frame {i}")
            times.append(shot.frame(i)["frame"])
        times = np.array(times)
        settled = times[SETTLING:]
        far = [t for i, t in enumerate(times) if i >= SETTLING and not any(s <= i < s + NEAR for s in STEPS)]
        over.append(np.mean(settled > budget))
        worst.append(max(far) / budget)
        if args.pictures:
            write(args.pictures, f"flight_{run}.png", shot.film.picture())
            with open(f"{args.pictures}/flight_{run}.json", "w", encoding="utf-8") as file:
                file.write(shot.gi.GetStatistics())
            np.savetxt(f"{args.pictures}/flight_{run}.txt", times, "%.2f")
    report.figure(f"frames over the budget after {SETTLING}", float(np.median(over)), 0.05, share=True,
                  more="runs: " + ", ".join(f"{100 * v:.1f} %" for v in over))
    report.figure("slowest frame away from steps, of the budget", float(np.median(worst)), 1.5,
                  more="runs: " + ", ".join(f"{v:.2f}" for v in worst))


def steadiness(args, budget, report, run, swing):
    """Changes of levels, those undone within 60 frames, and the share of the budget that is not used, of one run."""
    shot = Flight(args.size, args.preset, swing)
    shot.gi.SetFrameBudget(budget)
    changes, undone, used, last, before = 0, 0, [], {}, None
    for i in range(args.frames):
        report.going_on(f"run {run + 1} of {args.runs}: frame {i}")
        statistics = shot.frame(i, False)
        now = levels(statistics)
        if i >= WARM:
            used.append(statistics["frame"])
            changes += now != before
            for technique, level in now.items():
                old = before.get(technique, level)
                if level != old:
                    undone += technique in last and i - last[technique][0] < 60 and last[technique][1] == level
                    last[technique] = (i, old)
        before = now
    remaining = any(knob["level"] + 1 < len(knob["levels"]) for knob in statistics["knobs"])
    return 100 * changes / (args.frames - WARM), undone, 1 - float(np.mean(used)) / budget if remaining else 0


def steady(args, report, what, swing):
    """Medians of several runs around a surface that swings."""
    budget = budget_of(args, report, swing=swing)
    runs = np.array([steadiness(args, budget, report, run, swing) for run in range(args.runs)])
    changes, undone, unused = np.median(runs, axis=0)
    report.figure(f"{what}: changes in 100 frames", changes, 1, more="runs: " + ", ".join(f"{v:.2f}" for v in runs[:, 0]))
    report.figure(f"{what}: changes undone within 60 frames", undone, 0, more="runs: " + ", ".join(f"{v:.0f}" for v in runs[:, 1]))
    report.figure(f"{what}: budget not used while knobs remain", unused, 0.25, share=True,
                  more="runs: " + ", ".join(f"{100 * v:.0f} %" for v in runs[:, 2]))


def constant(args, report):
    steady(args, report, "constant load", TREMBLE)


def drift(args, report):
    steady(args, report, "drifting load", SWING)


def turn_and_rest(size, args, budget, report, what):
    """Turn the camera three times and let it rest each time; returns milliseconds of frames by the state of the budget."""
    shot = Flight(size, args.preset)
    shot.gi.SetFrameBudget(budget)
    times = {"refining": [], "settled": []}
    for turn in range(1, 4):
        report.going_on(f"{what}: turn {turn} of 3")
        for i in range(60):
            shot.frame(i, False)
        settled = 0
        while settled < 5:
            shot.film.frame()
            statistics = penumbra.statistics(shot.gi)["budget"]
            settled += statistics["state"] == "settled"
            times.setdefault(statistics["state"], []).append(statistics["frame"])
    return times


def rest(args, report):
    budget = budget_of(args, report)
    limit = max(budget, RESPONSIVE)
    for scale in (1, 2, 3, 4, 6, 8):  # until refining must hold back
        size = tuple(scale * side for side in args.size)
        if np.median(turn_and_rest(size, args, budget, report, f"{size[0]}x{size[1]}")["settled"]) > 1.3 * limit:
            break
    else:
        print(f"frames that refine are not measured: the user's own settings fit {limit:.0f} ms even at {size[0]}x{size[1]}")
        return
    slowest, count = [], 0
    for run in range(args.runs):
        times = turn_and_rest(size, args, budget, report, f"run {run + 1} of {args.runs}")["refining"]
        slowest.append(max(times) / limit)
        count += len(times)
    report.figure("slowest frame that refines, of the budget or 100 ms", float(np.median(slowest)), 1,
                  more=f"{size[0]}x{size[1]}, {count} frames; runs: " + ", ".join(f"{v:.2f}" for v in slowest))


def error(args, report):
    budget = budget_of(args, report, swing=0)
    ends = [60, 120, 180]  # frames whose pictures are compared

    def along(preset, limit):
        shot = Flight(args.size, preset, swing=0)
        if limit:
            shot.gi.SetFrameBudget(limit)
        pictures, times = {}, []
        for i in range(max(ends) + 1):
            report.going_on(f"{preset}{' with a budget' if limit else ''}: frame {i}")
            times.append(shot.frame(i, False)["frame"])
            if i in ends:
                pictures[i] = (shot.film.picture(), shot.film.pose())
        return pictures, np.array(times[SETTLING:])

    governed, times = along(args.preset, budget)
    truth = tracer(Flight(args.size, "off", swing=0).film.renderer, args.size)
    truths = {}
    for i, (_, pose) in governed.items():
        report.going_on(f"path tracing frame {i}")
        truth.place(pose)
        truths[i] = truth.picture(args.truth)

    def mean_error(pictures):
        return float(np.mean([np.mean((p - truths[i]) ** 2 / (truths[i] ** 2 + 0.01)) for i, (p, _) in pictures.items()]))
    report.figure(f"relMSE of {args.preset} with a budget of {budget:.0f} ms", mean_error(governed),
                  more=f"{100 * np.mean(times > budget):.1f} % of frames over it")
    best = None
    for preset in ("off", "fast", "balanced", "high"):
        pictures, times = along(preset, 0)
        fits = np.percentile(times, 95) <= budget
        figure = mean_error(pictures)
        report.figure(f"relMSE of {preset}", figure, more=f"median {np.median(times):.0f} ms: {'fits' if fits else 'does not fit'}")
        best = min(figure, best) if fits and best is not None else figure if fits else best
    if best is not None:
        report.figure("relMSE with a budget / of the best preset that fits", mean_error(governed) / best, 1.15)


def overhead(args, report):
    """Frames without a budget and with one that all settings fit, in turns of twenty."""
    free, bound = (Flight(args.size, args.preset, swing=0) for _ in range(2))
    for shot in (free, bound):
        shot.gi.CollectStatisticsOff()
    bound.gi.SetFrameBudget(10000)
    for i in range(80):
        free.film.camera.Azimuth(0.4)
        free.film.frame()
        bound.film.camera.Azimuth(0.4)
        bound.film.frame()
    times = {free: [], bound: []}
    for turn in range(args.runs * 8):
        report.going_on(f"turn {turn}")
        for shot in (free, bound):
            for _ in range(10):
                shot.film.camera.Azimuth(0.4)
                times[shot].append(1e3 * shot.film.frame())
    without, with_budget = (float(np.median(times[shot])) for shot in (free, bound))
    report.figure("median ms of a frame without a budget", without)
    report.figure("with one that is never reached, / without", with_budget / without)


PARTS = {"flight": flight, "constant": constant, "drift": drift, "rest": rest, "error": error, "overhead": overhead}


def size_of(text):
    width, height = (int(part) for part in text.lower().split("x"))
    return width, height


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART", default=list(PARTS), help="any of " + ", ".join(PARTS))
    parser.add_argument("--size", type=size_of, default=(160, 120), metavar="WxH", help="size of the pictures (default 160x120)")
    parser.add_argument("--preset", default="high", choices=penumbra.presets(), help="the user's own settings (default high)")
    parser.add_argument("--floors", type=float, default=2, help="the budget, in times of the lowest levels (default 2)")
    parser.add_argument("--frames", type=int, default=600, help="frames of a flight (default 600)")
    parser.add_argument("--runs", type=int, default=3, help="runs of which the median counts (default 3)")
    parser.add_argument("--truth", type=int, default=256, help="paths of the path tracer (default 256)")
    parser.add_argument("--pictures", metavar="FOLDER", help="where to write pictures, times and statistics")
    args = parser.parse_args()
    report = Report()
    for part in args.parts:
        if part not in PARTS:
            parser.error(f"there is no part '{part}': choose from {', '.join(PARTS)}")
        PARTS[part](args, report)
    return 0 if report.passed else 1


if __name__ == "__main__":
    sys.exit(main())
