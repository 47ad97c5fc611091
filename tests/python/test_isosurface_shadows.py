#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Default shadow maps on isosurfaces with smooth normals, against hard ray-traced shadows.

Normals of coarse facets differ from their shading normals, and maps that confuse the two draw acne on slopes. Tests three
fields at coarse, middle and fine resolution, each with three kinds of light.

usage: test_isosurface_shadows.py [--size WxH] [--pictures FOLDER] [FIELD...]
"""
import argparse
import os
import pathlib
import sys

import numpy as np
import penumbra
import shadow_masks
from PIL import Image
from shadow_masks import scenes
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

LIMIT = 0.3  # percent of the pixels
BAND = 1.5  # texels or pixels along edges that are left out
RESOLUTION = 2048  # the default
# Difference in light: an eighth is noise of the filter at an edge, a quarter is acne on a slope.
DIFFERENCE = 0.25


def wavelet(extent):
    """ParaView's Wavelet and its default contour."""
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-extent, extent, -extent, extent, -extent, extent)
    contour = vtkFlyingEdges3D()
    contour.SetInputConnection(source.GetOutputPort())
    contour.SetValue(0, 150)
    contour.ComputeScalarsOff()
    return contour


def head(step):
    """The demo's MRI head, from every nth voxel."""
    volume = scenes.read_volume("ch2.nii.gz")
    skin = scenes.blur(np.where(scenes.filled(volume > 32), np.maximum(volume, 90), volume), 5) - 36
    return scenes.isosurface(skin[::step, ::step, ::step], 0, spacing=step)


def gyroid(points):
    """A thick sheet along a gyroid, clipped by a ball."""
    axis = np.linspace(-1.5 * np.pi, 1.5 * np.pi, points)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    sheet = np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x) + 0.3
    ball = 4.4 - np.sqrt(x * x + y * y + z * z)
    return scenes.isosurface(np.minimum(sheet, ball), 0, spacing=40 / points)


FIELDS = {"wavelet": (wavelet, (10, 20, 40)), "head": (head, (6, 3, 1)), "gyroid": (gyroid, (16, 32, 64))}
LEVELS = ("coarse", "middle", "fine")
LIGHTS = ("directional", "positional", "spot")


def stage(contour):
    """A renderer with the surface above a plane, and the centre and size of the surface."""
    contour.Update()
    bounds = np.reshape(contour.GetOutput().GetBounds(), (3, 2))
    center = bounds.mean(axis=1)
    size = (bounds[:, 1] - bounds[:, 0]).max()
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    renderer.AddActor(scenes.actor(contour, (0.9, 0.9, 0.9)))
    plane = vtkPlaneSource()
    low = center - 1.2 * size
    low[2] = bounds[2, 0] - 0.02 * size
    plane.SetOrigin(low)
    plane.SetPoint1(low + (2.4 * size, 0, 0))
    plane.SetPoint2(low + (0, 2.4 * size, 0))
    renderer.AddActor(scenes.actor(plane, (0.9, 0.9, 0.9)))
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(center)
    camera.SetPosition(center + size * np.array((0.975, -1.35, 0.975)))
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(35)
    renderer.ResetCameraClippingRange()
    return renderer, center, size


def place_light(renderer, kind, center, size):
    """Replace the lights of a stage by one light of a kind."""
    renderer.RemoveAllLights()
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetFocalPoint(center)
    light.SetPosition(center + size * np.array((-0.75, -1.5, 1.25)))
    light.SetPositional(kind != "directional")
    light.SetConeAngle(40 if kind == "spot" else 180)
    renderer.AddLight(light)
    return light


def compare(renderer, window, light):
    """Percentages of the pixels that face the light (differing ones, those outside the band along edges, too dark ones there),
    both masks, and the pixels outside the band."""
    bare = shadow_masks.Shot(renderer, window).radiance
    world = shadow_masks.positions(renderer, window)
    lit = (bare > 0.02 * bare.max()) & ~np.isnan(world[..., 0])
    masks = [np.where(lit, shot.radiance / np.maximum(bare, 1e-9), 0.0) for shot in (
        shadow_masks.Shot(renderer, window, "ray-traced-shadows", light_angle=0),
        shadow_masks.Shot(renderer, window, "shadow-maps"))]
    bounds = np.reshape(renderer.ComputeVisiblePropBounds(), (3, 2))
    count, differ, outside, _ = shadow_masks.compare(
        *masks, lit, world, light, bounds, RESOLUTION, BAND, DIFFERENCE)
    dark = sum(masks[0][tuple(pixel)] > 0.5 for pixel in outside)
    return [100 * number / count for number in (differ, len(outside), dark)], masks, outside


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("fields", nargs="*", default=list(FIELDS))
    parser.add_argument("--size", default="400x300")
    parser.add_argument("--pictures", default=os.environ.get("PENUMBRA_TEST_OUTPUT"),
                        help="folder for pictures of the masks")
    options = parser.parse_args()
    worst = 0.0
    print("percent of the pixels that face the light:")
    print(f"{'field':8} {'facets':7} {'light':12} {'differ':>7} {'outside':>8} {'too dark':>9}")
    for name in options.fields:
        make, sizes = FIELDS[name]
        for level, size in zip(LEVELS, sizes):
            renderer, center, extent = stage(make(size))
            window = penumbra.window(
                renderer, size=tuple(map(int, options.size.split("x"))), multisamples=0)
            for kind in LIGHTS:
                light = place_light(renderer, kind, center, extent)
                (differ, outside, dark), masks, pixels = compare(renderer, window, light)
                print(f"{name:8} {level:7} {kind:12} {differ:7.2f} {outside:8.2f} {dark:9.2f}", flush=True)
                worst = max(worst, outside)
                if options.pictures:
                    picture = 255 * np.stack([masks[0], masks[1], masks[1]], axis=2)
                    picture[tuple(pixels.T)] = (255, 255, 0)
                    Image.fromarray(np.clip(picture, 0, 255).astype(np.uint8)).save(
                        pathlib.Path(options.pictures) / f"isosurface-{name}-{level}-{kind}.png")
    print(f"worst outside {BAND} texels or pixels along edges: {worst:.2f} %, at most {LIMIT} %")
    return 0 if worst <= LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
