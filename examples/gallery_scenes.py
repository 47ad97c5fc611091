# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Further scenes of the gallery, generated here: stream tubes, a volume, and a helmet of metal.

Each function returns a renderer with plain VTK props and camera, like those of scenes.py.
"""
import math

import numpy as np
from scenes import actor, blur, read_volume, stage
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPiecewiseFunction, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersModeling import vtkRotationalExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkPointSource, vtkSphereSource
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume, vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

VIRIDIS = ((0.267, 0.005, 0.329), (0.254, 0.265, 0.530), (0.164, 0.471, 0.558), (0.135, 0.659, 0.518),
           (0.478, 0.821, 0.318), (0.993, 0.906, 0.144))


def look_at(renderer, focus, offset, up=(0, 0, 1), angle=30):
    """Aim the camera at a point from an offset."""
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(focus)
    camera.SetPosition(*(f + o for f, o in zip(focus, offset)))
    camera.SetViewUp(up)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()
    return renderer


def tubes():
    """Stream tubes of a steady ABC flow (Arnold, Beltrami, Childress) in a ball, coloured by speed."""
    renderer = stage((0.83, 0.86, 0.90), (0.56, 0.60, 0.66))
    count, size = 48, 2 * math.pi
    z, y, x = np.meshgrid(*[np.linspace(0, size, count)] * 3, indexing="ij")
    flow = np.stack([np.sin(z) + 0.8 * np.cos(y), 0.9 * np.sin(x) + np.cos(z), 0.8 * np.sin(y) + 0.9 * np.cos(x)], -1)
    image = vtkImageData()
    image.SetDimensions(count, count, count)
    image.SetSpacing(*[size / (count - 1)] * 3)
    vectors = numpy_to_vtk(flow.reshape(-1, 3), deep=True)
    vectors.SetName("velocity")
    speed = numpy_to_vtk(np.linalg.norm(flow, axis=-1).ravel(), deep=True)
    speed.SetName("speed")
    image.GetPointData().SetVectors(vectors)
    image.GetPointData().SetScalars(speed)
    seeds = vtkPointSource()
    seeds.SetCenter(size / 2, size / 2, size / 2)
    seeds.SetRadius(0.42 * size)
    seeds.SetNumberOfPoints(160)
    tracer = vtkStreamTracer()
    tracer.SetInputData(image)
    tracer.SetSourceConnection(seeds.GetOutputPort())
    tracer.SetMaximumPropagation(7)
    tracer.SetIntegrationDirectionToBoth()
    tube = vtkTubeFilter()
    tube.SetInputConnection(tracer.GetOutputPort())
    tube.SetRadius(0.055)
    tube.SetNumberOfSides(12)
    tube.CappingOn()
    colors = vtkColorTransferFunction()
    for i, color in enumerate(VIRIDIS):
        colors.AddRGBPoint(2.4 * i / (len(VIRIDIS) - 1), *color)
    shown = actor(tube, specular=0.2)
    shown.GetMapper().SetLookupTable(colors)
    shown.GetMapper().SetScalarModeToUsePointFieldData()
    shown.GetMapper().SelectColorArray("speed")
    renderer.AddActor(shown)
    return look_at(renderer, [size / 2] * 3, (6, -14, 6.5))


def volume():
    """The MRI head as a volume, shaded, with the skin half transparent before the brain."""
    renderer = stage((0.83, 0.86, 0.90), (0.56, 0.60, 0.66))
    field = np.ascontiguousarray(blur(np.pad(read_volume("ch2.nii.gz"), 4), 4)[::2, ::2, ::2])
    image = vtkImageData()
    image.SetDimensions(field.shape[::-1])
    image.SetSpacing(2, 2, 2)
    image.GetPointData().SetScalars(numpy_to_vtk(field.ravel(), deep=True))
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for value, rgb in ((0, (0.75, 0.45, 0.35)), (60, (0.90, 0.68, 0.55)), (100, (0.85, 0.55, 0.50)), (180, (0.97, 0.93, 0.85))):
        color.AddRGBPoint(value, *rgb)
    for value, alpha in ((0, 0), (25, 0), (50, 0.12), (90, 0.15), (130, 0.65), (200, 0.9)):
        opacity.AddPoint(value, alpha)
    settings = vtkVolumeProperty()
    settings.SetColor(color)
    settings.SetScalarOpacity(opacity)
    settings.SetScalarOpacityUnitDistance(3)
    settings.SetInterpolationTypeToLinear()
    settings.ShadeOn()
    settings.SetAmbient(0.15)
    settings.SetDiffuse(0.85)
    settings.SetSpecular(0.15)
    shown = vtkVolume()
    shown.SetMapper(mapper)
    shown.SetProperty(settings)
    renderer.AddVolume(shown)
    return look_at(renderer, (90, 108, 90), (300, 430, 130), angle=28)


def turned(profile, angle=360, start=0, closed=False):
    """A surface of revolution about the z axis, from points (radius, height)."""
    points = vtkPoints()
    for radius, height in profile:
        points.InsertNextPoint(radius * math.cos(math.radians(start)), radius * math.sin(math.radians(start)), height)
    line = vtkCellArray()
    count = len(profile)
    line.InsertNextCell(count + closed)
    for i in range(count + closed):
        line.InsertCellPoint(i % count)
    outline = vtkPolyData()
    outline.SetPoints(points)
    outline.SetLines(line)
    surface = vtkRotationalExtrusionFilter()
    surface.SetInputData(outline)
    surface.SetAngle(angle)
    surface.SetResolution(96)
    surface.SetCapping(0)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SetFeatureAngle(40)
    normals.ConsistencyOn()
    return normals


def shell(radius, low, high, thickness, steps=24):
    """The profile of a part of a sphere's shell between two angles above the equator."""
    angles = np.radians(np.linspace(low, high, steps))
    outer = [(radius * math.cos(a), radius * math.sin(a)) for a in angles]
    inner = [((radius - thickness) * math.cos(a), (radius - thickness) * math.sin(a)) for a in angles[::-1]]
    return outer + inner


def ring(radius, height, tube, steps=24):
    """The profile of a torus."""
    return [(radius + tube * math.cos(a), height + 1.4 * tube * math.sin(a))
            for a in np.linspace(0, 2 * math.pi, steps, endpoint=False)]


def coated(source, color, metallic, roughness):
    """An actor with a physically based material."""
    result = actor(source, color)
    result.GetProperty().SetInterpolationToPBR()
    result.GetProperty().SetMetallic(metallic)
    result.GetProperty().SetRoughness(roughness)
    return result


def helmet():
    """A helmet of steel and brass with a red crest on a wooden stand, physically based."""
    renderer = stage((0.83, 0.86, 0.90), (0.56, 0.60, 0.66))
    steel, brass, wood, red = (0.77, 0.78, 0.80), (0.91, 0.72, 0.38), (0.45, 0.28, 0.16), (0.62, 0.06, 0.05)
    parts = [(turned(shell(1.0, 0, 90, 0.05), closed=True), steel, 1.0, 0.28),
             (turned(ring(1.01, 0.0, 0.07), closed=True), brass, 1.0, 0.18),
             (turned([(0.985, 0.02), (1.0, -0.9), (0.93, -1.25), (0.90, -1.25), (0.96, -0.9), (0.94, 0.02)], 250, -35,
                     closed=True), steel, 1.0, 0.35)]
    for start in (-128, -76):  # cheek pieces, with the face open between them
        parts.append((turned([(1.02, 0.0), (1.03, -0.75), (0.99, -0.8), (0.98, 0.0)], 24, start, closed=True), brass, 1.0, 0.3))
    for i in range(24):
        stud = vtkSphereSource()
        stud.SetRadius(0.045)
        stud.SetThetaResolution(20)
        stud.SetPhiResolution(20)
        angle = math.radians(15 * i)
        stud.SetCenter(0.985 * math.cos(angle), 0.985 * math.sin(angle), 0.2)
        parts.append((stud, brass, 1.0, 0.15))
    blade = turned([(1.02, -0.07), (1.42, -0.05), (1.42, 0.05), (1.02, 0.07)], 180, closed=True)
    crest = vtkTransformPolyDataFilter()
    crest.SetInputConnection(blade.GetOutputPort())
    turn = vtkTransform()
    turn.RotateZ(90)
    turn.RotateX(90)
    crest.SetTransform(turn)
    parts.append((crest, red, 0.0, 0.7))
    for radius, height, center in ((0.16, 1.5, -1.15), (0.85, 0.14, -1.93)):
        post = vtkCylinderSource()
        post.SetRadius(radius)
        post.SetHeight(height)
        post.SetResolution(64)
        post.SetCenter(0, center, 0)
        upright = vtkTransform()
        upright.RotateX(90)
        stands = vtkTransformPolyDataFilter()
        stands.SetInputConnection(post.GetOutputPort())
        stands.SetTransform(upright)
        parts.append((stands, wood, 0.0, 0.45))
    for source, color, metallic, roughness in parts:
        renderer.AddActor(coated(source, color, metallic, roughness))
    return look_at(renderer, (0, 0, -0.32), (3.2, -6.3, 2.2))


SCENES = {
    "tubes": ("Stream tubes of an ABC flow", tubes),
    "volume": ("MRI head as a volume", volume),
    "helmet": ("A helmet of steel and brass", helmet),
}
