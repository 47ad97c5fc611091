#!/usr/bin/env python3
"""Skies as a renderer's light: skies.py OUT.png [WIDTH] [SAMPLES]

Path traces one scene under six skies of vtkGISkySource: uniform, gradient, daylight at noon and near sunset, and soft
boxes in two arrangements. Each picture shows the sky behind the scene, as Penumbra's path tracer sees it.
"""
import math
import sys

import penumbra
from PIL import Image
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

out = sys.argv[1]
width = int(sys.argv[2]) if len(sys.argv) > 2 else 320
samples = int(sys.argv[3]) if len(sys.argv) > 3 else 64

renderer = vtkRenderer()
renderer.AutomaticLightCreationOff()


def add(source, color, metallic=0.0, roughness=0.5, **settings):
    for name, value in settings.items():
        getattr(source, "Set" + name)(*value) if isinstance(value, tuple) else getattr(source, "Set" + name)(value)
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    shading = actor.GetProperty()
    shading.SetInterpolationToPBR()
    shading.SetColor(color)
    shading.SetMetallic(metallic)
    shading.SetRoughness(roughness)
    renderer.AddActor(actor)


round_ball = {"PhiResolution": 64, "ThetaResolution": 96}
add(vtkPlaneSource(), (0.5, 0.5, 0.5), Origin=(-4.0, -4.0, 0.0), Point1=(4.0, -4.0, 0.0), Point2=(-4.0, 4.0, 0.0))
add(vtkSphereSource(), (0.8, 0.8, 0.8), Center=(-1.2, 0.0, 0.6), Radius=0.6, **round_ball)
add(vtkSphereSource(), (0.95, 0.93, 0.9), 1.0, 0.15, Center=(0.2, -0.3, 0.5), Radius=0.5, **round_ball)
add(vtkCubeSource(), (0.75, 0.3, 0.2), XLength=0.8, YLength=0.8, ZLength=1.2, Center=(1.4, 0.3, 0.6))
camera = renderer.GetActiveCamera()
camera.SetPosition(0.6, -7.0, 1.9)
camera.SetFocalPoint(0.1, 0.0, 0.75)
camera.SetViewUp(0.0, 0.0, 1.0)
camera.SetViewAngle(28.0)
renderer.ResetCameraClippingRange()


def box(**settings):
    made = penumbra.vtkGISoftBox()
    for name, value in settings.items():
        getattr(made, "Set" + name)(*value) if isinstance(value, tuple) else getattr(made, "Set" + name)(value)
    return made


def uniform(sky):
    sky.SetStrength(0.8)


def gradient(sky):
    sky.SetKindToGradient()


def noon(sky):
    sky.SetKindToDaylight()
    sky.SetSunByTime(48.86, 2.35, "2026-06-21T09:30:00Z")
    sky.SetSunStrength(math.pi)  # VTK divides the light of lamps on physically based materials by pi


def evening(sky):
    sky.SetKindToDaylight()
    sky.SetSunElevation(6.0)
    sky.SetSunAzimuth(300.0)
    sky.SetTurbidity(1.6)
    sky.SetStrength(5.0)
    sky.SetSunStrength(math.pi)


def studio(sky):
    sky.SetKindToGradient()
    sky.SetStrength(0.35)
    sky.FollowCameraOn()
    sky.AddSoftBox(box(Elevation=40.0, Azimuth=-50.0, Width=50.0, Height=50.0, Radiance=2.5))
    sky.AddSoftBox(box(Elevation=15.0, Azimuth=75.0, Width=30.0, Height=60.0, Radiance=0.8))
    sky.AddSoftBox(box(Elevation=35.0, Azimuth=160.0, Width=40.0, Height=20.0, Radiance=6.0))


def two_colors(sky):
    sky.SetStrength(0.05)
    sky.FollowCameraOn()
    sky.AddSoftBox(box(Elevation=25.0, Azimuth=-80.0, Radius=25.0, Radiance=4.0, Color=(1.0, 0.55, 0.25)))
    sky.AddSoftBox(box(Elevation=25.0, Azimuth=80.0, Radius=25.0, Radiance=4.0, Color=(0.3, 0.55, 1.0)))


window = penumbra.window(renderer, size=(width, width * 9 // 16))
penumbra.enable(renderer, "reference", path_tracing__samples=samples)
pictures = []
for kind in (uniform, gradient, noon, evening, studio, two_colors):
    sky = penumbra.vtkGISkySource()
    sky.VisibleOn()
    kind(sky)
    sky.ApplyTo(renderer)
    pictures.append(penumbra.render(window, frames=samples))
    sky.RemoveFrom(renderer)

height = pictures[0].shape[0]
sheet = Image.new("RGB", (3 * width, 2 * height))
for i, picture in enumerate(pictures):
    sheet.paste(Image.fromarray(picture[:, :, :3]), (i % 3 * width, i // 3 * height))
sheet.save(out)
