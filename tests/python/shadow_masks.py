# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Visibility of a light in each pixel of the demo's scenes, by shadow maps and by rays."""
import pathlib
import sys

import numpy as np
import penumbra
from penumbra.shadow_bias.bench import positions  # noqa: F401 also for the tests
from scipy.spatial import cKDTree
from vtkmodules.vtkRenderingCore import vtkLight

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples"))
import scenes  # noqa: E402 the demo's scenes

LIGHTS = ("directional", "cone", "omnidirectional", "camera")


def one_light(renderer, kind):
    """Replace the scene's lights by one light of a kind, in the direction of the key light."""
    key = next(light for light in renderer.GetLights() if not light.LightTypeIsHeadlight())
    toward = np.subtract(key.GetPosition(), key.GetFocalPoint())
    bounds = np.reshape(renderer.ComputeVisiblePropBounds(), (3, 2))
    size = np.linalg.norm(bounds[:, 1] - bounds[:, 0])
    focus = bounds.mean(axis=1)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    light = vtkLight()
    light.SetIntensity(1.0)
    if kind == "camera":  # over the photographer's left shoulder
        light.SetLightTypeToCameraLight()
        light.SetPosition(-0.9, 0.7, 1.0)
    else:
        light.SetLightTypeToSceneLight()
        light.SetFocalPoint(focus)
        # Outside the scene, but close enough for diverging shadows.
        light.SetPosition(focus + toward / np.linalg.norm(toward) * size * 0.75)
        light.SetPositional(kind != "directional")
        light.SetConeAngle({"cone": 40.0}.get(kind, 180.0))
    renderer.AddLight(light)
    return light


class Shot:
    """Mean radiance of still frames of a renderer with one technique, or without any."""

    def __init__(self, renderer, window, technique=None, frames=1, **values):
        gi = penumbra.vtkGIPass()
        if technique:
            found = gi.GetTechnique(technique)
            found.EnabledOn()
            for name, value in values.items():
                if not found.SetParameter(name.replace("_", "-"), value):
                    raise ValueError(found.GetLastError())
        gi.KeepRadianceOn()
        renderer.SetPass(gi)
        self.radiance = 0.0
        for _ in range(frames):
            window.Render()
            self.radiance = self.radiance + penumbra.radiance(gi, renderer)[..., :3].max(axis=2)
        self.radiance /= frames
        gi.ReleaseGraphicsResources(window)


def across(light, points, bounds, resolution):
    """Positions of points perpendicular to the light, in texels of a map that contains the scene."""
    origin = np.array(light.GetTransformedPosition())
    axis = np.array(light.GetTransformedFocalPoint()) - origin
    axis /= np.linalg.norm(axis)
    side = np.cross(axis, (0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (0.0, 1.0, 0.0))
    side /= np.linalg.norm(side)
    basis = np.stack((side, np.cross(side, axis)))
    if not light.GetPositional():
        corners = np.array(np.meshgrid(*bounds)).reshape(3, -1).T @ basis.T
        texel = (corners.max(axis=0) - corners.min(axis=0)).max() / resolution
        return points @ basis.T / texel
    # Positions on the unit sphere around the light. The six maps of an omnidirectional light are half as wide.
    cone = light.GetConeAngle() < 60
    texel = 2 * np.tan(np.radians(light.GetConeAngle())) / resolution if cone else 4 / resolution
    toward = points - origin
    return toward / np.linalg.norm(toward, axis=1, keepdims=True) / texel


def compare(rays, maps, lit, world, light, bounds, resolution, band=1.5, difference=0.5):
    """Number of pixels that face the light, number of those whose masks differ by more than a share of the light, those of
    them outside a band (in texels or pixels) along the edges of ray-traced shadows, and the ray-traced shadows."""
    shadow = rays < 0.5
    edge = np.zeros_like(shadow)
    for axis in (0, 1):
        # Depth is discontinuous there too: the texels beyond the edge show the other surface.
        change = np.diff(shadow.astype(int), axis=axis) != 0
        first = [slice(None)] * 2
        second = [slice(None)] * 2
        first[axis], second[axis] = slice(None, -1), slice(1, None)
        edge[tuple(first)] |= change
        edge[tuple(second)] |= change
    differ = lit & (np.abs(rays - maps) > difference)
    pixels = cKDTree(np.argwhere(edge)) if edge.any() else None
    outside = np.argwhere(differ)
    if pixels and len(outside):
        outside = outside[pixels.query(outside)[0] > band]
    seen = edge & ~np.isnan(world[..., 0])
    if seen.any() and len(outside):
        texels = cKDTree(across(light, world[seen], bounds, resolution))
        there = across(light, world[tuple(outside.T)], bounds, resolution)
        outside = outside[texels.query(there)[0] > band]
    return lit.sum(), differ.sum(), outside, shadow
