# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's scenes in white, so that pictures show openness: drawn with ambient light only, or path traced in surroundings
of radiance 1."""
import os

import numpy as np
import penumbra
import scenes
from bench_scenes import surround
from vtkmodules.vtkRenderingCore import vtkLight

BIAS = 0.001  # for vtkSSAOPass, in diagonals of the scene


def white(name, ambient):
    """A scene whose surfaces reflect all ambient light, or all light of the surroundings."""
    renderer = scenes.SCENES[name][1]()
    for actor in renderer.GetActors():
        actor.GetMapper().ScalarVisibilityOff()
        material = actor.GetProperty()
        material.SetColor(1, 1, 1)
        material.SetSpecular(0)
        material.SetAmbient(1 if ambient else 0)
        material.SetDiffuse(0 if ambient else 1)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    if ambient:
        renderer.AddLight(vtkLight())  # without a light VTK draws no ambient light
    renderer.GradientBackgroundOff()
    renderer.SetBackground(0, 0, 0)
    return renderer


def diagonal(renderer):
    """Diagonal of the bounds of the visible props, the unit of lengths."""
    low, high = np.array(renderer.ComputeVisiblePropBounds()).reshape(3, 2).T
    return float(np.linalg.norm(high - low))


def by_vtk(name, size, radius, samples=32):
    """A renderer and its window with vtkSSAOPass, or without occlusion if the radius is 0."""
    renderer = white(name, ambient=True)
    window = penumbra.window(renderer, size=size, multisamples=0)
    if radius > 0:
        renderer.UseSSAOOn()
        renderer.SetSSAORadius(radius * diagonal(renderer))
        renderer.SetSSAOBias(BIAS * diagonal(renderer))
        renderer.SetSSAOKernelSize(samples)
        renderer.SSAOBlurOn()
    return renderer, window


def by_penumbra(name, size, parameters):
    """A renderer and its window with Penumbra's occlusion, or without if parameters is None. Radius and thickness are in
    diagonals of the scene."""
    renderer = white(name, ambient=True)
    window = penumbra.window(renderer, size=size, multisamples=0)
    gi = penumbra.enable(renderer, "off", off="anti-aliasing")
    if parameters is not None:
        occlusion = gi.GetTechnique("ambient-occlusion")
        occlusion.EnabledOn()
        settings = {"ambient-share": 0, "interreflection": 0, **parameters}
        for key, value in settings.items():
            if key in ("radius", "thickness"):
                value *= diagonal(renderer)
            if not occlusion.SetParameterFromText(key, str(value)):
                raise ValueError(occlusion.GetLastError())
    return renderer, window


def picture(method):
    """Openness as drawn, rows from the top. method: a renderer and its window."""
    return penumbra.render(method[1])[:, :, 0].astype(float) / 255


def traced(name, size, samples, folder=None):
    """Path-traced openness at any distance, and whether a surface covers the whole pixel."""
    kept = folder and os.path.join(folder, f"{name}-{size[0]}x{size[1]}-{samples}.npy")
    if kept and os.path.exists(kept):
        result = np.load(kept)
    else:
        renderer = white(name, ambient=False)
        surround(renderer, np.ones((4, 8, 3)))
        window = penumbra.window(renderer, size=size, multisamples=0)
        gi = penumbra.enable(renderer, "reference")
        gi.KeepRadianceOn()
        tracing = gi.GetTechnique("path-tracing")
        tracing.SetParameter("samples", samples)
        tracing.SetParameter("bounces", 0)
        for _ in range(samples):
            window.Render()
        result = penumbra.radiance(gi, renderer)
        if kept:
            np.save(kept, result)
    return result[..., 0], result[..., 3] > 0.99
