#!/usr/bin/env python3
"""A sun, a disc and a rectangle, by shadow maps, by rays and by path tracing: area_lights.py OUT.jpg [WIDTH [FRAMES]]

WIDTH: of each picture. FRAMES: at rest, averaged.
"""
import sys

import numpy
import penumbra
from PIL import Image
from penumbra import vtkGILightShape
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

TECHNIQUES = ("shadow-maps", "ray-traced-shadows", "path-tracing")


def add(renderer, source, color):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetSpecular(0.4)
    actor.GetProperty().SetSpecularPower(25)
    renderer.AddActor(actor)


def make_scene(shape):
    renderer, light = vtkRenderer(), vtkLight()
    floor, ball = vtkPlaneSource(), vtkSphereSource()
    floor.SetOrigin(-4, -4, 0)
    floor.SetPoint1(4, -4, 0)
    floor.SetPoint2(-4, 4, 0)
    ball.SetCenter(0, 0, 0.75)
    ball.SetThetaResolution(128)
    ball.SetPhiResolution(128)
    add(renderer, floor, (0.9, 0.9, 0.9))
    add(renderer, ball, (0.9, 0.5, 0.3))
    light.SetPosition(1.2, 0.8, 3)
    if shape == "sun":
        vtkGILightShape.SetAngle(light, 6)
    else:
        light.PositionalOn()
        light.SetConeAngle(180)  # no cone
        light.SetAttenuationValues(0, 0, 1)
        light.SetIntensity(7)
        if shape == "disc":
            vtkGILightShape.SetDisc(light, 0.7)
        else:
            vtkGILightShape.SetRectangle(light, 2, 0.5, 20)
    renderer.AddLight(light)
    renderer.SetBackground(0.2, 0.2, 0.25)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.4, -4, 2.8)
    camera.SetFocalPoint(-0.2, 0, 0.4)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()
    return renderer


def main():
    width = int(sys.argv[2]) if len(sys.argv) > 2 else 320
    frames = int(sys.argv[3]) if len(sys.argv) > 3 else 64
    rows = []
    for shape in ("sun", "disc", "rectangle"):
        row = []
        for technique in TECHNIQUES:
            renderer = make_scene(shape)
            on = (technique,) if technique == "path-tracing" else (technique, "anti-aliasing")
            penumbra.enable(renderer, "off", on=on, path_tracing__bounces=0, anti_aliasing__mode="accumulate",
                            ray_traced_shadows__samples=4)
            window = penumbra.window(renderer, size=(width, width * 5 // 8), multisamples=0)
            row.append(penumbra.render(window, frames=frames)[..., :3])
        rows.append(numpy.concatenate(row, axis=1))
    Image.fromarray(numpy.concatenate(rows)).save(sys.argv[1], quality=88)


main()
