# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's three scenes, from data in Debian packages: a head, a protein, a landscape.

Each function returns a renderer with plain VTK actors, lights and camera, without anything from Penumbra.
"""
import math
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkGlyph3D, vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkWarpScalar
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkFiltersSources import vtkDiskSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkLight,
                                         vtkPolyDataMapper, vtkRenderer)

# A folder with the files below under the same paths, where the packages are not installed.
DATA = os.environ.get("PENUMBRA_SCENE_DATA", "")
MRICRON = DATA + "/usr/share/mricron/templates/"
VOLUMES = ("ch2.nii.gz", "ch2bet.nii.gz", "ch2better.nii.gz")
# The first one that is installed is used, because not every release of Debian has both.
PROTEINS = {
    DATA + "/usr/share/pymol/data/demo/1tii.pdb": "heat-labile enterotoxin (1TII)",
    DATA + "/usr/share/EMBOSS/test/data/structure/2hhb.ent": "haemoglobin (2HHB)",
}
PROTEIN = next((path for path in PROTEINS if os.path.exists(path)), next(iter(PROTEINS)))
ELEVATION = DATA + "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"


def actor(source, color=None, specular=0.0, power=20):
    """Create an actor for the output of a filter, in one colour or coloured by its data."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    result = vtkActor()
    result.SetMapper(mapper)
    if color:
        mapper.ScalarVisibilityOff()
        result.GetProperty().SetColor(color)
    result.GetProperty().SetSpecular(specular)
    result.GetProperty().SetSpecularPower(power)
    return result


def stage(top, bottom):
    """Create a renderer with a soft background."""
    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(bottom)
    renderer.SetBackground2(top)
    return renderer


def light(renderer, focus, direction, intensity, color=(1, 1, 1)):
    """Add a directional light from a direction in the world, toward a point."""
    result = vtkLight()
    result.SetLightTypeToSceneLight()
    result.PositionalOff()
    result.SetFocalPoint(focus)
    result.SetPosition(*(f + 1000 * d for f, d in zip(focus, direction)))
    result.SetIntensity(intensity)
    result.SetColor(color)
    renderer.AddLight(result)


def headlight(renderer, intensity):
    """Add a weak headlight, so that nothing is completely dark."""
    result = vtkLight()
    result.SetLightTypeToHeadlight()
    result.SetIntensity(intensity)
    renderer.AddLight(result)


def floor(center, radius, color):
    """Create a round floor that receives shadows."""
    disk = vtkDiskSource()
    disk.SetInnerRadius(0)
    disk.SetOuterRadius(radius)
    disk.SetCircumferentialResolution(128)
    disk.SetRadialResolution(8)
    result = actor(disk, color)
    result.SetPosition(center)
    return result


def read_volume(name):
    """Read a NIfTI volume of mricron's templates as an array [z, y, x] of floats."""
    reader = vtkNIFTIImageReader()
    reader.SetFileName(MRICRON + name)
    reader.Update()
    image = reader.GetOutput()
    shape = image.GetDimensions()[::-1]
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(shape).astype(np.float32)


def isosurface(field, value, spacing=1.0, origin=(0, 0, 0)):
    """Return the isosurface of an array [z, y, x], closed at the borders of the array."""
    field = np.pad(field, 1, constant_values=value - 30)
    origin = tuple(o - spacing for o in origin)
    image = vtkImageData()
    image.SetDimensions(field.shape[::-1])
    image.SetSpacing(spacing, spacing, spacing)
    image.SetOrigin(origin)
    image.GetPointData().SetScalars(numpy_to_vtk(field.ravel(), deep=True))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, value)
    contour.ComputeScalarsOff()
    return contour


def blur(field, times):
    """Smooth an array by repeated application of a small binomial filter."""
    for _ in range(times):
        for axis in range(3):
            before, after = np.roll(field, 1, axis), np.roll(field, -1, axis)
            field = 0.25 * before + 0.5 * field + 0.25 * after
    return field


def filled(solid):
    """Close the inner holes of a mask, which are the voxels with set voxels on both sides along each axis."""
    inside = np.ones_like(solid)
    for axis in range(3):
        forward = np.maximum.accumulate(solid, axis)
        backward = np.flip(np.maximum.accumulate(np.flip(solid, axis), axis), axis)
        inside &= forward & (backward if axis else True)
    return inside


def head():
    """An MRI head, cut open above the brain."""
    renderer = stage((0.83, 0.86, 0.90), (0.56, 0.60, 0.66))
    volume = read_volume("ch2.nii.gz")
    skin = blur(np.where(filled(volume > 32), np.maximum(volume, 90), volume), 5) - 36
    cavity = 0.5 - blur((read_volume("ch2bet.nii.gz") > 0).astype(np.float32), 14) * 4
    z, y, x = np.indices(volume.shape, dtype=np.float32)
    above = (y - 125) * 0.30 + (z - 116) * 0.95
    # Smoothed again, so that no edge is sharper than the voxels can represent.
    shell = blur(np.minimum(np.minimum(skin, 40 * cavity), -20 * above), 2)
    surface = isosurface(shell, 0)
    # Colour cut and inner surfaces like bone, the rest like skin.
    surface.Update()
    points = vtk_to_numpy(surface.GetOutput().GetPoints().GetData())
    i, j, k = np.clip(points + 0.5, 0, np.array(volume.shape[::-1]) - 1).astype(int).T
    cut = np.abs((points[:, 1] - 125) * 0.30 + (points[:, 2] - 116) * 0.95) < 0.4
    hollow = cavity[k, j, i] * 40 < skin[k, j, i]
    colors = np.where((cut | hollow)[:, None], (232, 214, 186), (222, 172, 142)).astype(np.uint8)
    surface.GetOutput().GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    outside = vtkPolyDataMapper()
    outside.SetInputData(surface.GetOutput())
    outer = vtkActor()
    outer.SetMapper(outside)
    outer.GetProperty().SetSpecular(0.10)
    outer.GetProperty().SetSpecularPower(12)
    renderer.AddActor(outer)
    # Voxels of half a millimetre, every second one is used. The origins of the volumes differ.
    brain = isosurface(blur(read_volume("ch2better.nii.gz"), 1)[::2, ::2, ::2], 60, 1.0, (15, 18, 1.5))
    renderer.AddActor(actor(brain, (0.88, 0.62, 0.60), 0.22, 30))
    light(renderer, (90, 110, 90), (0.85, 0.20, 0.60), 0.9, (1.0, 0.96, 0.90))
    headlight(renderer, 0.22)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(93, 120, 93)
    camera.SetPosition(93 + 270, 120 + 380, 93 + 300)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(22)
    renderer.ResetCameraClippingRange()
    return renderer


def read_atoms(path):
    """Read the positions, elements and chains of the atoms in a PDB file."""
    with open(path, encoding="ascii", errors="replace") as file:
        lines = [line for line in file if line.startswith("ATOM")]
    positions = np.array([[float(line[30 + 8 * i:38 + 8 * i]) for i in range(3)] for line in lines])
    # Files from before 1996 have no element column, so the element is taken from the atom's name.
    columns = [line[76:78].strip() for line in lines]
    elements = [column if column.isalpha() else line[12:16].strip(" 0123456789")[:1]
                for line, column in zip(lines, columns)]
    chains = [line[21] for line in lines]
    return positions, elements, chains


def protein():
    """A protein's atoms as balls, coloured by chain."""
    renderer = stage((0.93, 0.93, 0.95), (0.70, 0.72, 0.76))
    positions, elements, chains = read_atoms(PROTEIN)
    radii = {"C": 1.7, "N": 1.55, "O": 1.52, "S": 1.8}
    palette = [(0.93, 0.62, 0.35), (0.40, 0.63, 0.80), (0.45, 0.72, 0.60), (0.87, 0.48, 0.45),
               (0.70, 0.60, 0.82), (0.90, 0.80, 0.45), (0.55, 0.75, 0.85)]
    order = sorted(set(chains))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions, deep=True))
    atoms = vtkPolyData()
    atoms.SetPoints(points)
    scale = numpy_to_vtk(np.array([radii.get(e, 1.6) for e in elements]), deep=True)
    scale.SetName("radius")
    colors = np.array([palette[order.index(c) % len(palette)] for c in chains])
    colors[np.array(elements) == "O"] *= 0.86
    color = numpy_to_vtk((255 * colors).astype(np.uint8), deep=True)
    color.SetName("color")
    atoms.GetPointData().SetScalars(scale)
    atoms.GetPointData().AddArray(color)
    ball = vtkSphereSource()
    ball.SetRadius(1)
    ball.SetThetaResolution(14)
    ball.SetPhiResolution(9)
    balls = vtkGlyph3D()
    balls.SetInputData(atoms)
    balls.SetSourceConnection(ball.GetOutputPort())
    balls.SetScaleModeToScaleByScalar()
    molecule = actor(balls, None, 0.15, 20)
    molecule.GetMapper().SetScalarModeToUsePointFieldData()
    molecule.GetMapper().SelectColorArray("color")
    center = positions.mean(axis=0)
    molecule.SetOrigin(center)
    molecule.RotateX(-90)
    renderer.AddActor(molecule)
    size = np.linalg.norm(positions - center, axis=1).max()
    low = molecule.GetBounds()[4] - 1.0
    renderer.AddActor(floor((center[0], center[1], low), 6 * size, (0.84, 0.85, 0.88)))
    light(renderer, tuple(center), (-0.55, -0.45, 1.0), 0.95, (1.0, 0.97, 0.92))
    headlight(renderer, 0.20)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(center[0], center[1], center[2] - 0.1 * size)
    camera.SetPosition(center[0] + 1.3 * size, center[1] - 3.3 * size, center[2] + 2.6 * size)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(30)
    renderer.ResetCameraClippingRange()
    return renderer


def terrain():
    """The Jacksboro fault in Tennessee, from a digital elevation model with exaggerated height."""
    renderer = stage((0.66, 0.76, 0.88), (0.90, 0.92, 0.94))
    data = np.load(ELEVATION)
    height = data["elevation"].astype(np.float32)[::-1]
    rows, columns = height.shape
    north = float(data["dy"]) * 111_200
    east = float(data["dx"]) * 111_320 * math.cos(math.radians(float(data["ymin"])))
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.SetSpacing(east, north, 1)
    scalars = numpy_to_vtk(height.ravel(), deep=True)
    scalars.SetName("elevation")
    image.GetPointData().SetScalars(scalars)
    surface = vtkImageDataGeometryFilter()
    surface.SetInputData(image)
    warp = vtkWarpScalar()
    warp.SetInputConnection(surface.GetOutputPort())
    warp.SetScaleFactor(2.5)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(warp.GetOutputPort())
    normals.SplittingOff()
    colors = vtkColorTransferFunction()
    for metres, color in ((236, (0.36, 0.47, 0.30)), (330, (0.50, 0.58, 0.37)),
                          (480, (0.72, 0.69, 0.48)), (700, (0.66, 0.54, 0.42)),
                          (900, (0.72, 0.66, 0.60)), (1076, (0.93, 0.92, 0.90))):
        colors.AddRGBPoint(metres, *color)
    land = actor(normals)
    land.GetMapper().SetLookupTable(colors)
    land.GetMapper().UseLookupTableScalarRangeOn()
    renderer.AddActor(land)
    center = (columns * east / 2, rows * north / 2, 1100)
    size = columns * east
    light(renderer, center, (-0.9, 0.35, 0.58), 1.1, (1.0, 0.95, 0.85))
    headlight(renderer, 0.12)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(center[0] - 0.04 * size, center[1] - 0.06 * size, 900)
    camera.SetPosition(center[0] + 0.18 * size, center[1] - 0.85 * size, 0.52 * size)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(30)
    renderer.ResetCameraClippingRange()
    return renderer


SCENES = {
    "head": ("MRI head: skin and brain", head),
    "protein": (f"Protein: {PROTEINS[PROTEIN]}", protein),
    "terrain": ("Terrain: Jacksboro fault, Tennessee", terrain),
}
