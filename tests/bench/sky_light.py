#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light of skies by sky-light compared with the path tracer on the demo's scenes and the example's isosurface: in the very
first frame (cold), in the first frame after a turn of the camera (orbit), and in a still picture. Exits with 1 if an error
of the last two is above its limit.

The scenes have no lights here and no highlights, and the reference has no bounces, so that pictures show the light that
arrives straight from the sky."""
import sys
import time

import numpy as np
import penumbra
from bench_scenes import SCENES, Parser, surround
from indirect_light import FINER, kept, smaller, write
from vtkmodules.vtkRenderingCore import vtkLight

FRAMES = 32  # of a still picture
TURN = 7  # degrees
# Limits of relMSE, of the signed mean, and of relMSE in the first frame of an orbit.
LIMITS = {"uniform": (0.003, 0.01, 0.02), "gradient": (0.01, 0.02, None), "sun": (0.01, 0.02, None),
          "picture": (0.01, 0.02, None)}


def directions(height=256):
    """Unit vectors of the pixels of an equirectangular image, lowest row first; y is up."""
    latitude, longitude = np.meshgrid((np.arange(height) + 0.5) / height * np.pi - np.pi / 2,
                                      (np.arange(2 * height) + 0.5) / height * np.pi - np.pi, indexing="ij")
    return np.stack((np.cos(latitude) * np.cos(longitude), np.sin(latitude), np.cos(latitude) * np.sin(longitude)), axis=-1)


def disc(d, toward, degrees, radiance):
    """A disc of light of an angular diameter."""
    toward = np.array(toward) / np.linalg.norm(toward)
    inside = d @ toward > np.cos(np.radians(0.5 * degrees))
    return inside[..., None] * np.array(radiance)


def sky(name):
    """Radiance of a sky, as an image."""
    d = directions()
    up = d[..., 1:2]
    blue, haze, ground = np.array((0.25, 0.45, 0.9)), np.array((0.9, 0.9, 0.85)), np.array((0.22, 0.2, 0.18))
    if name == "uniform":
        return np.ones(d.shape)
    if name == "gradient":
        return 0.3 + 0.7 * (0.5 + 0.5 * up) * np.array((0.9, 1.0, 1.1))
    clear = np.where(up > 0, blue + (haze - blue) * (1 - np.clip(up, 0, 1)) ** 4, ground)
    if name == "sun":
        return clear + disc(d, (0.5, 0.6, -0.62), 3, (900, 850, 750))
    # A picture with clouds, windows and a small sun, from a few waves.
    random = np.random.default_rng(5)
    waves = sum(np.sin(d @ random.normal(size=3) * 2.0 ** octave + random.uniform(0, 6)) / 1.6 ** octave for octave in range(1, 6))
    clouds = np.clip(waves, 0, None)[..., None] * np.where(up > 0, 0.6, 0.05)
    return 0.5 * clear + clouds + disc(d, (-0.3, 0.75, -0.5), 1.5, (4000, 3800, 3500)) + disc(d, (0.9, 0.15, 0.2), 12, (9, 7, 5))


def lit(scene, name):
    """A scene lit by a sky alone."""
    renderer = SCENES[scene]()
    for actor in renderer.GetActors():
        actor.GetProperty().SetSpecular(0)
        actor.GetProperty().SetAmbient(0)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    faint = vtkLight()  # without a light VTK draws unlit colours
    faint.SetIntensity(1e-9)
    renderer.AddLight(faint)
    renderer.GradientBackgroundOff()
    renderer.SetBackground(0, 0, 0)
    surround(renderer, sky(name))
    renderer.SetEnvironmentUp(0, 0, 1)
    renderer.SetEnvironmentRight(1, 0, 0)
    return renderer


class Film:
    """A scene under a sky in a window, drawn with a preset."""

    def __init__(self, scene, name, size, preset, **parameters):
        self.renderer = lit(scene, name)
        self.gi = penumbra.enable(self.renderer, preset, **parameters)
        self.gi.KeepRadianceOn()
        self.window = penumbra.window(self.renderer, size=size, multisamples=0)

    def picture(self, frames):
        """Radiance after a number of frames."""
        for _ in range(frames):
            self.window.Render()
        self.window.WaitForCompletion()
        return penumbra.radiance(self.gi, self.renderer)[..., :3].astype(float)

    def turn(self, degrees):
        """Move the camera around the scene."""
        self.renderer.GetActiveCamera().Azimuth(degrees)


def truths(film, spp):
    """Two pictures of the path tracer, independent of each other and of those with its default seed."""
    pictures = []
    for seed in (1, 2):
        film.gi.GetTechnique("path-tracing").SetParameter("seed", seed)
        pictures.append(film.picture(spp))
    film.gi.GetTechnique("path-tracing").SetParameter("seed", 0)
    return np.stack(pictures)


def traced(scene, name, size, spp):
    """Truths of a scene under a sky."""
    return truths(Film(scene, name, size, "reference", **{"path-tracing.samples": spp, "path-tracing.bounces": 0}), spp)


def compared(picture, truths):
    """relMSE and the signed mean error. The noise of two independent truths cancels in the product of the differences."""
    truth = truths.mean(axis=0)
    epsilon = 0.01 * truth.mean() ** 2
    square = (picture - truths[0]) * (picture - truths[1])
    return (square / (truth ** 2 + epsilon)).mean(), picture.mean() / truth.mean() - 1


def options():
    """Parse the command line."""
    parser = Parser(__doc__, "160x90", parameter="NAME=VALUE")
    parser.add_argument("--skies", nargs="+", default=list(LIMITS), choices=LIMITS)
    parser.add_argument("--spp", type=int, default=512, help="paths per pixel of each of the two references, whose noise cancels")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps traced pictures for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write the compared pictures there: cold, orbit, still, path tracer")
    return parser.parse()


def main():
    """Print a line for each sky and scene."""
    args = options()
    parameters = {"sky-light." + key: value for key, value in args.set.items()}
    passed = True
    print(f"{'sky':9} {'scene':11}" + "".join(f"{title + ': relMSE':>17} {'mean':>9}" for title in ("cold", "orbit", "still")) +
          f"{'s of processor time':>21}")
    for name in args.skies:
        for scene in args.scenes:
            truths = kept(args.keep, f"{scene}_{name}_{args.size[0]}x{args.size[1]}_2x{args.spp}", lambda: traced(scene, name, args.size, args.spp))
            film = Film(scene, name, [FINER * side for side in args.size], "off", on="sky-light", **parameters)
            started = time.process_time()
            cold = smaller(film.picture(1))
            film.turn(-TURN)
            film.picture(FRAMES)
            film.turn(TURN)
            orbit = smaller(film.picture(1))
            still = smaller(film.picture(FRAMES - 1))
            seconds = time.process_time() - started
            write(args.pictures, f"{name}_{scene}.png", cold, orbit, still, truths.mean(axis=0))
            errors = [compared(picture, truths) for picture in (cold, orbit, still)]
            print(f"{name:9} {scene:11}" + "".join(f"{error:17.4f} {100 * mean:+7.2f} %" for error, mean in errors) +
                  f"{seconds:21.1f}", flush=True)
            most, most_mean, most_orbit = LIMITS[name]
            passed = passed and errors[2][0] <= most and abs(errors[2][1]) <= most_mean and (
                most_orbit is None or errors[1][0] <= most_orbit)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
