#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A room with baked indirect light, and a ball that moves through it, lit by probes.

    baked_room.py FOLDER [WIDTHxHEIGHT] [SAMPLES]

Writes pictures with and without indirect light, two of the moving ball, and one of the room with another lamp: the
lightmap then no longer fits, a note says so, and DDGI takes over. The walls are rectangles, whose texels are easy to
place; `penumbra bake lightmap` unwraps any surface.
"""
import pathlib
import sys

import numpy
import penumbra
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

TEXELS = 32  # along each side of a wall
# A corner, the vectors to the two neighbouring corners (whose cross product points into the room), and a colour.
WALLS = [((-1, -1, -1), (2, 0, 0), (0, 2, 0), (0.75, 0.75, 0.75)),
         ((-1, -1, 1), (0, 2, 0), (2, 0, 0), (0.75, 0.75, 0.75)),
         ((-1, 1, -1), (2, 0, 0), (0, 0, 2), (0.75, 0.75, 0.75)),
         ((-1, -1, -1), (0, 2, 0), (0, 0, 2), (0.8, 0.15, 0.1)),
         ((1, -1, -1), (0, 0, 2), (0, 2, 0), (0.15, 0.6, 0.2))]


def actor_of(source, color):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    return actor


def make_room():
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    for corner, u, v, color in WALLS:
        plane = vtkPlaneSource()
        plane.SetOrigin(corner)
        plane.SetPoint1(numpy.add(corner, u))
        plane.SetPoint2(numpy.add(corner, v))
        renderer.AddActor(actor_of(plane, color))
    lamp = vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.PositionalOn()
    lamp.SetConeAngle(180)
    lamp.SetPosition(0.3, -0.3, 0.7)
    lamp.SetIntensity(0.8)
    renderer.AddLight(lamp)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -4.2, 0)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(0.5, 20)
    return renderer, lamp


def vtk_array(values):
    return numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)


def bake(renderer, samples):
    """Bake a lightmap: texel centres run from edge to edge of each wall, and the walls are stacked in the map."""
    steps = numpy.linspace(0.002, 0.998, TEXELS)  # slightly inside, because other walls begin at the edges
    points, normals, corners, coordinates, directions = [], [], [], [], []
    for number, (corner, u, v, _) in enumerate(WALLS):
        corner, u, v = (numpy.array(value, float) for value in (corner, u, v))
        normal = numpy.cross(u, v) / numpy.linalg.norm(numpy.cross(u, v))
        points += [corner + s * u + t * v for t in steps for s in steps]
        normals += [normal] * TEXELS * TEXELS
        for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corners.append(corner + s * u + t * v)
            texel = numpy.array((0.5 + s * (TEXELS - 1), 0.5 + t * (TEXELS - 1))) / TEXELS
            coordinates.append((texel[0], (number + texel[1]) / len(WALLS)))
            directions.append(normal)
    gatherer, light = penumbra.vtkGILightGatherer(), vtkFloatArray()
    gatherer.SetSamples(samples)
    if not gatherer.Gather(renderer, vtk_array(points), vtk_array(normals), light):
        raise RuntimeError(gatherer.GetLastError())
    image = vtkImageData()
    image.SetDimensions(TEXELS, TEXELS * len(WALLS), 1)
    image.GetPointData().SetScalars(vtk_array(vtk_to_numpy(light)))
    surfaces, vertices, cells, scene = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkStringArray()
    vertices.SetData(vtk_array(corners))
    first = 4 * numpy.arange(len(WALLS))[:, None]
    triangles = numpy.concatenate([first + [[0, 1, 2]], first + [[0, 2, 3]]])
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(numpy.insert(triangles, 0, 3, axis=1).ravel(), deep=True))
    surfaces.SetPoints(vertices)
    surfaces.SetPolys(cells)
    surfaces.GetPointData().SetTCoords(vtk_array(numpy.array(coordinates, numpy.float32)))
    surfaces.GetPointData().SetNormals(vtk_array(numpy.array(directions, numpy.float32)))
    scene.SetName("scene")
    scene.InsertNextValue(penumbra.vtkGILightmap.DescribeScene(renderer))
    surfaces.GetFieldData().AddArray(scene)
    return surfaces, image


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    size = tuple(map(int, (sys.argv[2] if len(sys.argv) > 2 else "640x480").split("x")))
    samples = int(sys.argv[3]) if len(sys.argv) > 3 else 1024
    renderer, lamp = make_room()
    window = penumbra.window(renderer, size=size, multisamples=0)
    gi = penumbra.enable(renderer, "fast")
    penumbra.save_png(window, str(folder / "direct.png"))
    lightmap = gi.GetTechnique("lightmap")
    lightmap.SetBake(*bake(renderer, samples))
    lightmap.EnabledOn()
    penumbra.save_png(window, str(folder / "baked.png"))
    # The ball is not in the map, so probes light it.
    ball = vtkSphereSource()
    ball.SetRadius(0.35)
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(32)
    moving = actor_of(ball, (0.9, 0.9, 0.9))
    renderer.AddActor(moving)
    gi.GetTechnique("ddgi").EnabledOn()
    for number, x in enumerate((-0.5, 0.5)):
        moving.SetPosition(x, -0.2, -0.5)
        penumbra.save_png(window, str(folder / f"moving_{number}.png"), frames=24)
        print("notes:", gi.GetNotes() or "none")
    lamp.SetPosition(-0.5, -0.3, 0.7)
    penumbra.save_png(window, str(folder / "another_lamp.png"), frames=24)
    print("notes:", gi.GetNotes())


if __name__ == "__main__":
    main()
