#!/usr/bin/env python3
"""A room with baked probes, and a ball that moves through their light: baked_probes.py OUT.png [WIDTH] [SAMPLES]

The bake is saved as a .vti file next to OUT.png, and loaded from there the next time. OUT.png shows the ball at three
positions, and the probes.
"""
import pathlib
import sys

import penumbra
from PIL import Image
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

out = pathlib.Path(sys.argv[1])
width = int(sys.argv[2]) if len(sys.argv) > 2 else 320
samples = int(sys.argv[3]) if len(sys.argv) > 3 else 1024

renderer = vtkRenderer()
renderer.SetBackground(0, 0, 0)


def add(source, color, **position):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0)
    renderer.AddActor(actor)
    return actor


def box(x0, x1, y0, y1, z0, z1, color):
    cube = vtkCubeSource()
    cube.SetBounds(x0, x1, y0, y1, z0, z1)
    add(cube, color).GetProperty().SetInterpolationToFlat()


white, thick = (0.75, 0.75, 0.75), 0.1
box(-2, 2, -1.5, 1.5, -thick, 0, white)             # floor
box(-2, 2, -1.5, 1.5, 2, 2 + thick, white)          # ceiling
box(-2, 2, 1.5, 1.5 + thick, 0, 2, white)           # back
box(-2 - thick, -2, -1.5, 1.5, 0, 2, (0.75, 0.15, 0.1))
box(2, 2 + thick, -1.5, 1.5, 0, 2, (0.1, 0.3, 0.7))
box(-0.1, 0.1, 0.2, 1.5, 0, 1.4, white)             # a screen
lamp = vtkLight()
lamp.SetLightTypeToSceneLight()
lamp.PositionalOn()
lamp.SetConeAngle(180)
lamp.SetPosition(-1.2, 0.4, 1.7)
lamp.SetIntensity(0.8)
renderer.AddLight(lamp)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -5.2, 1.2)
camera.SetFocalPoint(0, 0, 0.9)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()

window = penumbra.window(renderer, size=(width, width * 9 // 16))
gi = penumbra.enable(renderer, "balanced", on=["sh-probes"])

# Bake the static scene, before the ball is added.
field, saved = vtkImageData(), out.with_suffix(".vti")
if saved.exists():
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(saved))
    reader.Update()
    field = reader.GetOutput()
else:
    baker = penumbra.vtkGIProbeBaker()
    baker.SetProbes(768)
    baker.SetSamples(samples)
    if not baker.Bake(renderer, field):
        sys.exit(baker.GetLastError())
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(saved))
    writer.SetInputData(field)
    writer.SetDataModeToBinary()
    writer.Write()
probes = gi.GetTechnique("sh-probes")
if not probes.SetBake(field):
    sys.exit(probes.GetBakeError())

source = vtkSphereSource()
source.SetRadius(0.3)
source.SetPhiResolution(48)
source.SetThetaResolution(96)
ball = add(source, (0.9, 0.9, 0.9))
pictures = []
for x, y in ((-1.2, -0.6), (0, -0.6), (1.3, 0.3)):
    ball.SetPosition(x, y, 0.35)
    pictures.append(penumbra.render(window, frames=4))
    if gi.GetNotes():
        print(gi.GetNotes())
probes.SetShow(True)
pictures.append(penumbra.render(window, frames=4))

height = pictures[0].shape[0]
sheet = Image.new("RGB", (2 * width, 2 * height))
for i, picture in enumerate(pictures):
    sheet.paste(Image.fromarray(picture[:, :, :3]), (i % 2 * width, i // 2 * height))
sheet.save(out)
