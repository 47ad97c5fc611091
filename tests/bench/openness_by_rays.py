# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Openness of the surfaces of a scene, by rays through VTK's cell locator: a reference for ambient occlusion that shares no
code with Penumbra."""
import math

import numpy as np
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.util.numpy_support import vtk_to_numpy

GOLDEN = math.pi * (3 - math.sqrt(5))


def triangles(renderer):
    """Surfaces of all actors as triangles in world coordinates."""
    append = vtkAppendPolyData()
    for actor in renderer.GetActors():
        actor.GetMapper().Update()
        transform = vtkTransform()
        transform.SetMatrix(actor.GetMatrix())
        moved = vtkTransformPolyDataFilter()
        moved.SetTransform(transform)
        moved.SetInputData(actor.GetMapper().GetInput())
        triangulated = vtkTriangleFilter()
        triangulated.SetInputConnection(moved.GetOutputPort())
        triangulated.Update()
        surface = vtkPolyData()
        surface.ShallowCopy(triangulated.GetOutput())
        append.AddInputData(surface)
    append.Update()
    return append.GetOutput()


class Reference:
    """The surfaces of a scene, and their openness at pixels of a picture."""

    def __init__(self, renderer):
        self.surface = triangles(renderer)
        self.points = vtk_to_numpy(self.surface.GetPoints().GetData()).astype(float)
        normals = self.surface.GetPointData().GetNormals()
        self.normals = vtk_to_numpy(normals).astype(float) if normals else None
        self.cells = vtk_to_numpy(self.surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.diagonal = self.surface.GetLength()
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.surface)
        self.locator.BuildLocator()

    def nearest(self, start, end):
        """First intersection of a line: its position along the line from 0 to 1, the cell and the weights of its corners.
        None if there is none."""
        part, position, weights = mutable(0.0), [0.0] * 3, [0.0] * 3
        piece, cell = mutable(0), mutable(0)
        if not self.locator.IntersectWithLine(start, end, 0.0, part, position, weights, piece, cell):
            return None
        return float(part), int(cell), (1 - weights[0] - weights[1], weights[0], weights[1])

    def visible(self, start, end):
        """First intersection of a line: its position, and the normals of shading and of the triangle, both toward the eye.
        None if there is none."""
        hit = self.nearest(start, end)
        if hit is None:
            return None
        part, cell, weights = hit
        corners = self.points[self.cells[cell]]
        flat = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        flat /= max(np.linalg.norm(flat), 1e-30)
        smooth = weights @ self.normals[self.cells[cell]] if self.normals is not None else flat
        smooth /= max(np.linalg.norm(smooth), 1e-30)
        eye = start - end
        return (start + part * (end - start), smooth if smooth @ eye > 0 else -smooth,
                flat if flat @ eye > 0 else -flat)

    def openness(self, position, normal, flat, rays, turn, radii):
        """Unoccluded fraction of the cosine-weighted hemisphere for each radius."""
        helper = np.array([1.0, 0, 0]) if abs(normal[0]) < 0.9 else np.array([0, 1.0, 0])
        across = np.cross(normal, helper)
        across /= np.linalg.norm(across)
        other = np.cross(normal, across)
        start = position + 1e-5 * self.diagonal * flat
        reach = np.full(rays, math.inf)
        for i in range(rays):
            height = math.sqrt(1 - (i + 0.5) / rays)
            side, angle = math.sqrt((i + 0.5) / rays), GOLDEN * i + turn
            direction = side * (math.cos(angle) * across + math.sin(angle) * other) + height * normal
            if direction @ flat <= 0:
                reach[i] = 0
                continue
            hit = self.nearest(start, start + 2 * self.diagonal * direction)
            if hit:
                reach[i] = 2 * self.diagonal * hit[0]
        return [float(np.mean(reach >= radius)) if math.isfinite(radius) else float(np.mean(np.isinf(reach)))
                for radius in radii]


def pixel_rays(renderer, size, pixels):
    """Start and end of camera rays through the centres of pixels (column, row from the top), between the clipping planes."""
    camera = renderer.GetActiveCamera()
    width, height = size
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
    inverse = np.linalg.inv([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])

    def unproject(column, row, depth):
        x, y = 2 * (column + 0.5) / width - 1, 1 - 2 * (row + 0.5) / height
        p = inverse @ np.array([x, y, depth, 1.0])
        return p[:3] / p[3]
    return [(unproject(x, y, -1.0), unproject(x, y, 1.0)) for x, y in pixels]


def sample(renderer, size, count, rays, radii, seed=1):
    """Openness at random pixels: their columns and rows, and a row of values for each radius."""
    reference = Reference(renderer)
    random = np.random.default_rng(seed)
    pixels, values = [], []
    for _ in range(20 * count):
        if len(pixels) == count:
            break
        pixel = (int(random.integers(size[0])), int(random.integers(size[1])))
        start, end = pixel_rays(renderer, size, [pixel])[0]
        surface = reference.visible(start, end)
        if surface:
            pixels.append(pixel)
            values.append(reference.openness(*surface, rays, random.uniform(0, 2 * math.pi), radii))
    columns, rows = np.array(pixels).T
    return columns, rows, np.array(values).T
