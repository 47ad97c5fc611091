# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders what the denoiser learns from: signals of few rays, and the same pictures with more rays and other random numbers.

Targets need not be free of noise: it is independent of that of the inputs, so the mean of a squared loss has its minimum where
that for perfect targets would have it (Lehtinen et al. 2018, Noise2Noise: Learning Image Restoration without Clean Data).
"""
import os
from dataclasses import dataclass

import numpy as np
import penumbra
import reference
import training_scenes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

FOLDER = "data"         # within that of the results
ORBIT = 8               # frames while the camera turns
STILL = (1, 4, 8, 16, 64)  # numbers of still frames of the other inputs
LONGEST = 0.4           # share of the cameras that have the last of these
ORBITS = 2              # of each camera
TARGET_FRAMES, TARGET_RAYS = 24, 4
MEASURE_FRAMES = 12    # of the light that errors are divided by
SETTLE = 30             # frames after which probes know the scene
PROBED = 0.4            # share of the scenes with probes, whose parameters are those of the preset with them
PROBES = {"ddgi.rays": 64, "ddgi.updates": 24}
RECENT = 4 / 3          # variance of a still mean, in which recent frames count more, by that of a plain one
LEAST, MOST = 4, 255    # frames from which a mean's error is known, and up to which they are counted
NORMAL = 4096           # steps of a packed normal
LUMINANCE = np.array((0.2126, 0.7152, 0.0722), np.float32)
# Arrays that are stored with each signal: see target() and direct_light(); count is the number of still frames, 0 for an orbit.
TARGET = "target", "target_error", "measure", "known", "count", "direct"


@dataclass
class Signal:
    """Light at the pixels of a picture, bottom row first, with what the denoiser knows of it.

    light: (h, w, 3) mean irradiance; error: (h, w) relative standard error of its luminance, 0 if unknown; frames: (h, w) number
    of frames in the mean, 0 without a surface; normal: (h, w, 2) octahedral, in view coordinates; depth: (h, w) view z, negative;
    projection: (2,) the projection's scales of x and y.
    """
    light: np.ndarray
    error: np.ndarray
    frames: np.ndarray
    normal: np.ndarray
    depth: np.ndarray
    projection: np.ndarray

    FIELDS = ("light", "error", "frames", "normal", "depth", "projection")


class Film:
    """A scene in a window that draws light by one ray per pixel and its mean over frames."""

    parity = False  # whether the newest frame is in the odd histories

    def __init__(self, renderer, size, also=(), **parameters):
        """size: (width, height). also: other techniques to switch on."""
        self.renderer, self.camera = renderer, renderer.GetActiveCamera()
        self.gi = penumbra.enable(renderer, "off", on=["ray-traced-light", "temporal-accumulation", *also], **parameters)
        self.window = penumbra.window(renderer, size=size, multisamples=0)
        self.find_parity()

    def frame(self, count=1):
        """Draw frames. Histories take turns, even and odd."""
        for _ in range(count):
            self.window.Render()
            if self.gi.GetLastError():
                raise RuntimeError(self.gi.GetLastError())
            self.parity = not self.parity

    def buffer(self, name, odd):
        """A history as an array."""
        image = vtkImageData()
        parity = "odd" if odd else "even"
        if not self.gi.GetBuffer(self.renderer, f"temporal-accumulation.{name}.{parity}", image):
            raise RuntimeError(f"the pass has no history {name}")
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 4).copy()

    def find_parity(self):
        """Draw frames, and see which histories change."""
        self.frame(2)
        before = self.buffer("surface", False)
        self.frame()
        self.parity = bool(np.array_equal(before, self.buffer("surface", False), equal_nan=True))

    def cut(self):
        """Look the other way for a frame, so that the next one finds no history."""
        self.camera.Yaw(180)
        self.frame()
        self.camera.Yaw(-180)

    def signal(self, still):
        """What the newest frame knows. still: whether the camera stood still in the frames of the mean."""
        mean = self.buffer("irradiance.rays", self.parity)
        surface = self.buffer("surface", self.parity)
        frames = np.where(surface[..., 1] < 0, np.minimum(surface[..., 3], MOST), 0)
        # Histories are undefined where there is no surface.
        mean, surface = (np.where(frames[..., None] > 0, values, 0) for values in (mean, surface))
        luminance = mean[..., :3] @ LUMINANCE
        variance = np.maximum(mean[..., 3] - luminance ** 2, 0) * (RECENT if still else 1) / np.maximum(frames, 1)
        error = np.minimum(np.sqrt(variance) / np.maximum(luminance, 1e-20), 0.99)
        high = np.floor(surface[..., 0] / NORMAL)
        normal = np.stack((high, surface[..., 0] - high * NORMAL), -1) / (NORMAL - 1)
        aspect = mean.shape[1] / mean.shape[0]
        matrix = self.camera.GetProjectionTransformMatrix(aspect, -1, 1)
        return Signal(mean[..., :3], np.where(frames >= LEAST, error, 0), frames, normal, surface[..., 1],
                      np.array((matrix.GetElement(0, 0), matrix.GetElement(1, 1))))


def lamps(renderer):
    """Lights of a renderer in view coordinates: places (x, y, z, 1), or directions to them (x, y, z, 0); and the light that
    they give, in units of the signal's."""
    view = renderer.GetActiveCamera().GetViewTransformMatrix()
    for light in renderer.GetLights():
        place, aim = np.array(light.GetTransformedPosition()), np.array(light.GetTransformedFocalPoint())
        place = np.append(place, 1) if light.GetPositional() else np.append(place - aim, 0)
        yield np.array(view.MultiplyPoint(place)), light.GetIntensity() * np.array(light.GetDiffuseColor())


def direct_light(renderer, signal):
    """Light (h, w, 3) of the renderer's lights on the surfaces of a signal, without shadows: pictures show it besides."""
    surfaces = reference.Surfaces(signal)
    total = np.zeros_like(surfaces.position)
    for place, light in lamps(renderer):
        toward = place[:3] - place[3] * surfaces.position
        cosine = (surfaces.direction * toward).sum(-1) / np.maximum(np.linalg.norm(toward, axis=-1), 1e-20)
        total += np.maximum(cosine, 0)[..., None] * light
    return np.where(surfaces.exists[..., None], total, 0).astype(np.float32)


def many_rays(film, frames):
    """The signal of still frames with many rays."""
    film.cut()
    film.frame(frames)
    return film.signal(True)


def target(film):
    """Light after many rays, its relative standard error, the same light by other random numbers, and whether each pixel has it.

    Errors are divided by the second light. If the noise of one picture were both in an error and in what divides it, results that
    are too dark would seem better.
    """
    light = film.gi.GetTechnique("ray-traced-light")
    light.SetParameter("rays", TARGET_RAYS)
    measure, drawn = many_rays(film, MEASURE_FRAMES), many_rays(film, TARGET_FRAMES)
    light.SetParameter("rays", 1)
    return drawn.light, drawn.error, measure.light, (drawn.frames > 0) & np.isfinite(drawn.light + measure.light).all(-1)


def camera_samples(film, random, longest):
    """Signals of one camera: after orbits that end where it is, then after numbers of still frames. They share a target."""
    signals = []
    for turn in random.uniform(-4, 4, ORBITS):
        film.camera.Azimuth(-ORBIT * turn)
        film.cut()
        for _ in range(ORBIT):
            film.camera.Azimuth(turn)
            film.frame()
        signals.append(film.signal(False))
    film.cut()
    drawn = 0
    for count in STILL if longest else STILL[:-1]:
        film.frame(count - drawn)
        drawn = count
        signals.append(film.signal(True))
    return signals, target(film)


def render(family, seed, size, cameras):
    """Arrays of a scene's samples, as they are stored."""
    renderer, random = training_scenes.make(family, seed)
    probes = random.random() < PROBED
    film = Film(renderer, (size, size), ["ddgi"] if probes else [], **(PROBES if probes else {}))
    film.frame(SETTLE if probes else 0)
    stored = {name: [] for name in Signal.FIELDS + TARGET}
    for _ in range(cameras):
        film.camera.Azimuth(random.uniform(-6, 6) if family == "room" else random.uniform(30, 100))
        renderer.ResetCameraClippingRange()
        signals, (light, error, measure, known) = camera_samples(film, random, random.random() < LONGEST)
        direct = direct_light(renderer, signals[-1])
        for number, signal in enumerate(signals):
            for name in Signal.FIELDS:
                stored[name].append(getattr(signal, name).astype(np.float32))
            stored["target"].append(light)
            stored["target_error"].append(error.astype(np.float32))
            stored["measure"].append(measure)
            stored["known"].append(known & np.isfinite(signal.light).all(-1))
            stored["direct"].append(direct)
            stored["count"].append(0 if number < ORBITS else STILL[number - ORBITS])
    return {name: np.stack(values) for name, values in stored.items()}


def path_of(folder, family, seed):
    """File of a scene's samples."""
    return os.path.join(folder, f"{family}_{seed:04d}.npz")


def ensure(folder, wanted, size, cameras, progress):
    """Render the scenes, pairs of family and seed, that the folder lacks. progress: called with the share that is done."""
    os.makedirs(folder, exist_ok=True)
    missing = [pair for pair in wanted if not os.path.exists(path_of(folder, *pair))]
    for done, (family, seed) in enumerate(missing):
        progress(done / len(missing))
        samples = render(family, seed, size, cameras)
        unfinished = path_of(folder, family, seed) + ".part"
        with open(unfinished, "wb") as file:
            np.savez(file, **samples)
        os.replace(unfinished, path_of(folder, family, seed))
    progress(1.0)


def load(path):
    """Samples of a scene: pairs of a signal and a dictionary of TARGET."""
    with np.load(path) as file:
        stored = {name: file[name] for name in file.files}
    return [(Signal(*(stored[name][i] for name in Signal.FIELDS)), {name: stored[name][i] for name in TARGET})
            for i in range(len(stored["count"]))]
