# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: a volume over a plane and a ball, first with the preset high and then without global illumination. Prints
the intersection of the volume's two silhouettes over their union.

usage: volumes.py FOLDER
"""
import sys

import numpy
import scenes
from paraview import simple
from PIL import Image
from penumbra.paraview import enable

folder = sys.argv[1]
simple._DisableFirstRenderCameraReset()
view = scenes.make_view()
wavelet = simple.Wavelet(WholeExtent=[-40, 40] * 3)
plane = simple.Plane(Origin=[-80, -80, -44], Point1=[80, -80, -44], Point2=[-80, 80, -44])
ball = simple.Sphere(Center=[36, -36, -32], Radius=12, ThetaResolution=48, PhiResolution=48)
scenes.show(view, [(source, None, [0.8, 0.8, 0.8]) for source in (plane, ball)])
view.CameraPosition, view.CameraFocalPoint = [136, -168, 88], [0, 0, -16]
volume = simple.Show(wavelet, view, "UniformGridRepresentation")
volume.SetRepresentationType("Volume")
simple.ColorBy(volume, ("POINTS", "RTData"))
volume.SetScalarBarVisibility(view, False)
volume.Shade, volume.Ambient = 1, 0.3
simple.GetColorTransferFunction("RTData").RGBPoints = [37.0, 1.0, 0.2, 0.0, 277.0, 1.0, 0.2, 0.0]
# A thin shell, which rays with a wrong start would miss.
simple.GetOpacityTransferFunction("RTData").Points = [37.0, 0.0, 0.5, 0.0, 150.0, 0.0, 0.5, 0.0, 155.0, 1.0, 0.5, 0.0,
                                                      165.0, 1.0, 0.5, 0.0, 170.0, 0.0, 0.5, 0.0, 277.0, 0.0, 0.5, 0.0]
view.UseLight = 0
lamp = simple.AddLight(view=view)
lamp.Position, lamp.FocalPoint = [-80, -40, 160], [0, 0, 0]


def silhouette(preset, frames):
    enable(view, preset, frames=frames)
    picture = scenes.picture(view)
    Image.fromarray(picture).save(f"{folder}/{preset}_{frames}.png")
    red, _, blue = numpy.moveaxis(picture.astype(int), 2, 0)
    return red > 1.5 * blue  # everything else is grey


for frames in (2, 1):
    lit = silhouette("high", frames)
    plain = silhouette("off", frames)
    print(f"silhouette {frames}: {(lit & plain).sum() / (lit | plain).sum():.5f} of {int(plain.sum())} pixels", flush=True)
