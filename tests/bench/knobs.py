#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the levels of a frame budget cost in quality: the error of a moving picture with each level of each technique against the
path tracer, less that with the last level. The governor weighs these figures, the "error" in a technique's JSON file.

Each level has a film of its own: some frames at rest, then an orbit of the camera, during which three frames are compared. All
films draw the same frames with the same random numbers, so that the noise of what the levels share cancels in the differences,
as do the noise of the truth and, except for anti-aliasing, the edges of objects, which only the truth smooths. What remains is
given as the standard error over scenes and frames. A level whose figure is not above twice that is marked ~: it cannot be told from the last one. The last
column is the relMSE of its pictures against those of the last level: how much of a difference there is, better or worse.

ddgi: the lamp moves, too, and the frames at rest have the last level, as those of a user's have: otherwise the figures would
show how long probes take to find light at all. sky-light: a prop moves slightly at the start of the orbit, so that the maps are
redrawn. ray-traced-shadows and shadow-maps: the lights have a size.

relMSE: mean of (picture - truth)^2 / (truth^2 + 0.01).
"""
import argparse
import json
import pathlib
import re
import sys

import numpy as np
from denoiser import named  # finds tool/denoiser too
from indirect_light import kept
from penumbra import vtkGILightShape
from ray_scenes import SIDES, Film, Report, TwoLamps, keep_lit, metal_room, painted, surround, tracer
from sky_light import sky
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkLight

TECHNIQUES = pathlib.Path(__file__).resolve().parents[2] / "vtk_module" / "techniques"
WARM, ORBIT, TURN = 20, 24, 1.5  # frames at rest and of the orbit; its degrees per frame
COMPARED = (8, 16, 24)           # frames of the orbit
LAMP_TURN = 3                    # degrees per frame around the vertical axis
SUN, SPHERE = 4, 0.06            # size of lights: degrees; of the distance to the middle of the scene
WIDE = 40                        # width of ground, in diagonals of the scene on it
NUDGE = 1e-4                     # of the scene's diagonal
LIGHT = ("isosurface", "cornell", "terrain-1000", "tubes-1000")
WIDE_SCENES = ("wide-plates-1001", "wide-terrain-1002")  # thin tubes would outweigh all others a hundredfold
SHADOWS = ("lamps", "isosurface", "terrain-1002", "tubes-1000")

# Setup of each technique. kind: modification of the scenes. zoom: crop the middle of a picture enlarged by this factor, because
# small pictures do not resolve the texels of a map. bounces: of the truth. rest: frames at rest have the last level.
SETUPS = {
    # Ray-traced light takes the place of these two in `high`. In `balanced`, occlusion affects 2 % of the light of lamps.
    # It has no effect beside sky-light, which rules out scenes under a sky.
    "ambient-occlusion": {"preset": "balanced", "scenes": ("lamps", "isosurface", "terrain-1002", "plates-1000")},
    "sky-light": {"preset": "balanced", "scenes": ("isosurface", "terrain", "tubes-1000"), "kind": "sky"},
    "ddgi": {"scenes": ("lamps", "isosurface", "plates-1000"), "kind": "lamp", "rest": True},
    "anti-aliasing": {"scenes": ("isosurface", "terrain-1002", "tubes-1000", "plates-1000"), "smooth": True},
    "ray-traced-light": {"scenes": LIGHT},
    "denoising": {"scenes": LIGHT},
    "ray-traced-shadows": {"scenes": SHADOWS, "kind": "soft", "on": ["ray-traced-shadows"], "off": ["shadow-maps"]},
    "shadow-maps": {"scenes": WIDE_SCENES, "kind": "soft", "zoom": 4},
    # Direct light only: indirect light on metal would mask errors of the reflections.
    "screen-space-reflections": {"scenes": ("metal", "metal-lamps", "metal-isosurface"), "off": ["ddgi", "ray-traced-light"],
                                 "bounces": 1},
}


def floor_of_metal(renderer):
    """Make the floor of a room as that of metal_room()."""
    look = renderer.GetActors().GetItemAsObject(list(SIDES).index("floor")).GetProperty()
    look.SetInterpolationToPBR()
    look.SetMetallic(1)
    look.SetRoughness(0.4)
    look.SetColor(0.9, 0.9, 0.9)


def widen(renderer):
    """Put a scene on wide ground, with the sun as its only light, as in a view over a landscape: maps must reach far."""
    center, diagonal = middle(renderer)
    plane = vtkPlaneSource()
    x, y, z = center - (0, 0, diagonal / 2)
    half = WIDE * diagonal / 2
    plane.SetOrigin(x - half, y - half, z)
    plane.SetPoint1(x + half, y - half, z)
    plane.SetPoint2(x - half, y + half, z)
    plane.Update()
    renderer.AddActor(painted(plane.GetOutput(), (0.6, 0.6, 0.6)))
    renderer.RemoveAllLights()
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(center + (-0.6, -0.5, 0.8))
    light.SetFocalPoint(center)
    renderer.AddLight(light)


def stage(name):
    """A renderer with a scene by name: those of the bench, family-seed, lamps, metal, metal-lamps, metal-isosurface, or wide-
    and a scene."""
    if name == "metal":
        return metal_room().renderer
    if name.startswith("wide-"):
        renderer = stage(name.removeprefix("wide-"))
        widen(renderer)
        return renderer
    base = name.removeprefix("metal-")
    renderer = TwoLamps().renderer if base == "lamps" else named(base)
    if base != name:
        floor_of_metal(renderer)
    return renderer


def middle(renderer):
    """The middle of a scene, and its diagonal."""
    low, high = np.reshape(renderer.ComputeVisiblePropBounds(), (3, 2)).T
    return (low + high) / 2, float(np.linalg.norm(high - low))


def lamps(renderer):
    """The lights that do not move with the camera."""
    return [light for light in renderer.GetLights() if light.LightTypeIsSceneLight()]


def soften(renderer):
    """Give lights a size."""
    for light in lamps(renderer):
        if light.GetPositional():
            distance = np.linalg.norm(np.subtract(light.GetPosition(), middle(renderer)[0]))
            vtkGILightShape.SetSphere(light, SPHERE * distance)
        else:
            vtkGILightShape.SetAngle(light, SUN)


def light_by_sky(renderer):
    """Replace lights by a cloudy sky with a sun."""
    for actor in renderer.GetActors():
        actor.GetProperty().SetSpecular(0)
        actor.GetProperty().SetAmbient(0)
    renderer.RemoveAllLights()
    keep_lit(renderer)
    surround(renderer, sky("picture"))
    renderer.SetEnvironmentUp(0, 0, 1)
    renderer.SetEnvironmentRight(1, 0, 0)


class Stage:
    """A scene whose camera, and what else moves, follow the frames of the orbit."""

    def __init__(self, name, setup):
        self.renderer, self.kind = stage(name), setup.get("kind")
        self.renderer.GetActiveCamera().Zoom(setup.get("zoom", 1))
        if self.kind == "soft":
            soften(self.renderer)
        elif self.kind == "sky":
            light_by_sky(self.renderer)
        self.middle, self.diagonal = middle(self.renderer)

    def step(self, frame):
        """Move what moves before a frame of the orbit; frames count from 1."""
        self.renderer.GetActiveCamera().Azimuth(TURN)
        if self.kind == "lamp":
            light, turn = lamps(self.renderer)[0], np.radians(LAMP_TURN)
            x, y, z = np.array(light.GetPosition()) - self.middle
            light.SetPosition(self.middle + (x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn), z))
        elif self.kind == "sky" and frame == 1:
            self.renderer.GetActors().GetLastActor().AddPosition(0, 0, NUDGE * self.diagonal)
        self.renderer.ResetCameraClippingRange()


def truths(name, setup, args, report):
    """Pictures of the path tracer at the frames that are compared."""
    bounces = setup.get("bounces", 8)

    def trace():
        scene, pictures = Stage(name, setup), []
        shot = tracer(scene.renderer, args.size, **{"path-tracing.bounces": bounces})
        for frame in range(1, ORBIT + 1):
            scene.step(frame)
            if frame in COMPARED:
                report.going_on(f"{name}: path tracing frame {frame}")
                pictures.append(shot.picture(args.truth))
        return np.stack(pictures)
    kind = setup.get("kind", "plain") + (f"_zoom{setup['zoom']}" if "zoom" in setup else "") + (
        f"_bounces{bounces}" if "bounces" in setup else "")
    return kept(args.keep, f"knobs_{name}_{kind}_{args.size[0]}x{args.size[1]}_{args.truth}", trace)


def kebab(name):
    """A parameter's name on the command line."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name).lower()


def moving(technique, setup, name, level, last, args):
    """The compared pictures of an orbit with one level."""
    def parameters(values):
        return {f"{technique}.{kebab(key)}": value for key, value in values.items()}
    scene = Stage(name, setup)
    rests = setup.get("rest")
    shot = Film(scene.renderer, args.size, setup.get("preset", "high"), on=setup.get("on", ()), off=setup.get("off", ()),
                smooth=setup.get("smooth", False), **parameters(last if rests else level))
    for _ in range(WARM):
        shot.frame()
    if rests:
        for key, value in level.items():
            shot.gi.GetTechnique(technique).SetParameter(kebab(key), value)
    pictures = []
    for frame in range(1, ORBIT + 1):
        scene.step(frame)
        shot.frame()
        if frame in COMPARED:
            pictures.append(shot.picture())
    return pictures


def stored(differences):
    """The errors to store: at least 0, and not rising with more work, because the governor would never choose a level that costs
    more than one with a smaller error. So a level has at most the error of each cheaper one (what is above is noise, or a flaw
    that more work shows); two digits, as there are no more in the measurement."""
    return [float(f"{value:.2g}") or 0 for value in np.minimum.accumulate(np.maximum(differences, 0))]


def relative(picture, truth):
    """relMSE."""
    return np.mean((picture - truth) ** 2 / (truth ** 2 + 0.01))


def measure(technique, budget, args, report):
    """Print the table of a technique; returns the errors to store."""
    setup, levels = SETUPS[technique], budget["levels"]
    scenes = args.scenes or setup["scenes"]
    errors = np.zeros((len(levels), len(scenes), len(COMPARED)))
    changes = np.zeros(errors.shape)
    for s, name in enumerate(scenes):
        expected = truths(name, setup, args, report)
        for n, level in reversed(list(enumerate(levels))):
            report.going_on(f"{technique}: level {n} of {len(levels) - 1}, {name}")
            pictures = moving(technique, setup, name, level, levels[-1], args)
            best = pictures if n == len(levels) - 1 else best
            errors[n, s], changes[n, s] = ([relative(p, t) for p, t in zip(pictures, what)] for what in (expected, best))
    differences = (errors - errors[-1]).reshape(len(levels), -1)
    noise = differences.std(axis=1, ddof=1) / np.sqrt(differences.shape[1])
    found = stored(differences.mean(axis=1))
    if sys.stderr.isatty():
        print("\r" + " " * report.width + "\r", end="", file=sys.stderr)
    print(f"\n{technique}, {setup.get('preset', 'high')}\n{'level':68}" + "".join(f"{name:>18}" for name in scenes) +
          f"{'difference':>20}{'to store':>11}{'from last':>11}")
    for n, level in enumerate(levels):
        mean = differences[n].mean()
        doubtful = "~" if n < len(levels) - 1 and mean < 2 * noise[n] else " "
        text = ", ".join(f"{kebab(key)} {value}" for key, value in level.items())
        print(f"{text:68}" + "".join(f"{value:18.5f}" for value in errors[n].mean(axis=1)) +
              f"{mean:+11.5f} ± {noise[n]:.5f}{doubtful}{found[n]:10g}{changes[n].mean():11.5f}", flush=True)
    return found


def write_errors(path, errors):
    """Put errors into a JSON file, which otherwise stays as it is."""
    text = path.read_text(encoding="utf-8")
    new, count = re.subn(r'"error": \[[^\]]*\]', f'"error": {json.dumps(errors)}', text)
    if count != 1:
        raise ValueError(f"{path} has {count} lists of errors")
    path.write_text(new, encoding="utf-8")


def size_of(text):
    """Width and height."""
    width, height = (int(part) for part in text.lower().split("x"))
    return width, height


def main():
    """Print a table for each technique."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("techniques", nargs="*", metavar="TECHNIQUE", help="any of " + ", ".join(SETUPS) + " (default: all)")
    parser.add_argument("--size", type=size_of, default=(64, 64), metavar="WxH", help="size of the pictures (default 64x64)")
    parser.add_argument("--truth", type=int, default=128, metavar="PATHS",
                        help="paths per pixel of the truth (default %(default)s)")
    parser.add_argument("--scenes", nargs="+", metavar="SCENE", help="instead of each technique's own: " + stage.__doc__)
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps the truths for the next run")
    parser.add_argument("--write", action="store_true", help="put the errors into the techniques' JSON files")
    args = parser.parse_args()
    files = {}
    for path in sorted(TECHNIQUES.glob("*/*.json")):
        technique = json.loads(path.read_text(encoding="utf-8"))
        if "budget" in technique:
            files[technique["name"]] = path, technique["budget"]
    for name in args.techniques:
        if name not in files:
            parser.error(f"'{name}' has no budget: choose from {', '.join(files)}")
    report, found = Report(), {}
    for name in args.techniques or files:
        if name not in SETUPS:
            parser.error(f"there is no way to measure '{name}' yet: add it to SETUPS")
        path, budget = files[name]
        found[name] = measure(name, budget, args, report)
        if args.write:
            write_errors(path, found[name])
    print()
    for name, errors in found.items():
        print(f'{name:26} "error": {json.dumps(errors)}')
    return 0


if __name__ == "__main__":
    sys.exit(main())
