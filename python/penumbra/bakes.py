# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Loads baked light from files that penumbra bake or vtkGIProbeBaker wrote."""
import hashlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from . import exr
from .passes import _quiet

_BAKE_AGAIN = "bake it again with penumbra bake lightmap"
_LIGHT = ["R", "G", "B"]
_MOMENTS = [f"moment-{axis}.{color}" for axis in "xyz" for color in "RGB"]
_LAMPS = [f"lamps.{color}" for color in "RGB"]
_LAMP_MOMENTS = [f"lamps-{name}" for name in _MOMENTS]
_FIRST = [f"first.{color}" for color in "RGB"]
_POINTS = ["x", "y", "z", "u", "v", "nx", "ny", "nz"]


def _table(part, names):
    return numpy.stack([part.channels[name] for name in names], -1).reshape(-1, len(names))


def read_lightmap(path):
    """Read a lightmap's surfaces (vtkPolyData) and light (vtkImageData), the arguments of vtkGILightmap.SetBake().

    Raises ValueError, with a sentence, if the file is damaged or not a lightmap.
    """
    parts = exr.read(path)
    kind = parts[0].attributes.get("penumbra:kind", "")
    if not kind.startswith("lightmap"):
        raise ValueError(f"'{path}' is a picture but not a lightmap: give a file that penumbra bake lightmap wrote")
    if kind != "lightmap 1":
        raise ValueError(f"'{path}' is of another version of Penumbra: {_BAKE_AGAIN}")
    try:
        channels = [name for group in (_LIGHT, _MOMENTS, _LAMPS, _LAMP_MOMENTS) if group[0] in parts[0].channels
                    for name in group]
        tables = [_table(parts[0], channels + _FIRST), _table(parts[1], _POINTS), _table(parts[2], ["a", "b", "c"]),
                  _table(parts[3], ["x", "y", "width", "height", "high", "low"])]
        head = parts[0].attributes["penumbra:bake"]
        numbers = head.split("\n", 1)[0].split()
        scene = head.split("\n", 3)[3]
        expected = parts[0].attributes["penumbra:checksum"]
    except (KeyError, IndexError) as error:
        raise ValueError(f"the lightmap '{path}' is damaged: {_BAKE_AGAIN}") from error
    digest = hashlib.sha1(head.encode())
    for table in tables:
        digest.update(table.tobytes())
    if digest.hexdigest().lower() != expected.lower():
        raise ValueError(f"the lightmap '{path}' is damaged, its checksum does not fit: {_BAKE_AGAIN}")
    origin, points, triangles = numpy.array(numbers[:3], float), int(numbers[3]), int(numbers[4])
    return (_surfaces(tables[1][:points], tables[2][:triangles], origin, scene),
            _image(tables[0][:, :len(channels)], parts[0].channels["R"].shape))


def _surfaces(points, triangles, origin, scene):
    surfaces, positions, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    positions.SetData(numpy_to_vtk(origin + points[:, :3].astype(float), deep=True))
    surfaces.SetPoints(positions)
    surfaces.GetPointData().SetTCoords(numpy_to_vtk(numpy.ascontiguousarray(points[:, 3:5]), deep=True))
    surfaces.GetPointData().SetNormals(numpy_to_vtk(numpy.ascontiguousarray(points[:, 5:8]), deep=True))
    corners = numpy.insert(triangles.astype(numpy.int64), 0, 3, axis=1).ravel()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(corners, deep=True))
    surfaces.SetPolys(cells)
    text = vtkStringArray()
    text.SetName("scene")
    text.InsertNextValue(scene)
    surfaces.GetFieldData().AddArray(text)
    return surfaces


def _image(light, shape):
    image = vtkImageData()
    image.SetDimensions(shape[1], shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(light.astype(numpy.float32), deep=True))
    return image


def _load_probes(gi, path):
    reader = vtkXMLImageDataReader()
    with _quiet():
        if not reader.CanReadFile(str(path)):
            raise ValueError(f"'{path}' holds no baked light: give a file that penumbra bake probes wrote")
        reader.SetFileName(str(path))
        reader.Update()
    if reader.GetErrorCode():
        raise ValueError(f"the probes '{path}' are damaged: bake them again with penumbra bake probes")
    technique = gi.GetTechnique("sh-probes")
    if not technique.SetBake(reader.GetOutput()):
        raise ValueError(f"the probes '{path}' cannot be used: {technique.GetBakeError()}")
    technique.EnabledOn()
    return technique


def load_bake(gi, path):
    """Load baked light into the technique of a pass that uses it, and switch the technique on. Returns the technique.

    Raises ValueError, with a sentence, if the file holds no baked light, is damaged, or was altered.
    """
    with open(path, "rb") as file:
        if b"<VTKFile" in file.read(256):
            return _load_probes(gi, path)
    surfaces, light = read_lightmap(path)
    technique = gi.GetTechnique("lightmap")
    if not technique.SetBake(surfaces, light):
        raise ValueError(f"the lightmap '{path}' cannot be used: {_BAKE_AGAIN}")
    technique.EnabledOn()
    return technique
