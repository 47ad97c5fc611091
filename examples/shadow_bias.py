# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A board, a ball and a ring on a floor, for the bias laboratory:

    python3 -m penumbra.shadow_bias examples/shadow_bias.py -o bias
"""
from scenes import actor, headlight, stage
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkParametricFunctionSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight


def plane(side, color):
    source = vtkPlaneSource()
    source.SetOrigin(-side / 2, -side / 2, 0)
    source.SetPoint1(side / 2, -side / 2, 0)
    source.SetPoint2(-side / 2, side / 2, 0)
    return actor(source, color)


def box(center, size, color):
    source = vtkCubeSource()
    source.SetCenter(center)
    source.SetXLength(size[0])
    source.SetYLength(size[1])
    source.SetZLength(size[2])
    return actor(source, color)


def ball(center, radius, color):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(64)
    source.SetPhiResolution(33)
    made = actor(source, color)
    made.SetPosition(center)
    return made


def ring(center, radius, inner, color):
    torus = vtkParametricTorus()
    torus.SetRingRadius(radius)
    torus.SetCrossSectionRadius(inner)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(torus)
    source.SetUResolution(64)
    source.SetVResolution(32)
    made = actor(source, color)
    made.SetPosition(center)
    return made


def view(actors, toward, position, focal, angle=30, intensity=1.0):
    """A renderer of actors, a directional light from a direction, and a camera whose up is z."""
    renderer = stage((0.95, 0.96, 0.97), (0.74, 0.77, 0.81))
    for each in actors:
        renderer.AddActor(each)
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(toward)
    light.SetIntensity(intensity)
    renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focal)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()
    return renderer


def scene():
    renderer = view(
        [plane(5, (0.78, 0.78, 0.8)), box((-0.9, 0.2, 0.5), (1.4, 0.02, 1), (0.85, 0.62, 0.35)),
         ball((0.55, -0.1, 0.45), 0.45, (0.4, 0.6, 0.8)), ring((1.55, 0.6, 0.12), 0.4, 0.12, (0.6, 0.75, 0.5))],
        toward=(0.5, 2, 1.5), position=(1.2, -4.6, 3.4), focal=(0.2, -0.35, 0.1), intensity=0.8)
    headlight(renderer, 0.45)
    return renderer
