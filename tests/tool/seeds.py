# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small good files of every format that penumbra render reads."""
import base64
import gzip
import json
import pathlib
import struct

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkRectilinearGrid, vtkStructuredGrid)
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageCast, vtkRTAnalyticSource
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import (
    vtkJPEGWriter, vtkMetaImageWriter, vtkNIFTIImageWriter, vtkPNGWriter, vtkTIFFWriter)
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkStructuredPointsWriter, vtkUnstructuredGridWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter, vtkXMLMultiBlockDataWriter, vtkXMLPolyDataWriter,
    vtkXMLRectilinearGridWriter, vtkXMLStructuredGridWriter, vtkXMLUnstructuredGridWriter)

SIDE = 9  # samples of the volume along each axis


def volume():
    source = vtkRTAnalyticSource()
    half = SIDE // 2
    source.SetWholeExtent(-half, half, -half, half, -half, half)
    cast = vtkImageCast()
    cast.SetInputConnection(source.GetOutputPort())
    cast.SetOutputScalarTypeToShort()
    cast.Update()
    return cast.GetOutput()


def surface():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(12)
    sphere.SetPhiResolution(8)
    elevation = vtkElevationFilter()
    elevation.SetInputConnection(sphere.GetOutputPort())
    elevation.Update()
    return elevation.GetOutput()


def tetrahedra(image):
    split = vtkDataSetTriangleFilter()
    split.SetInputData(image)
    split.Update()
    return split.GetOutput()


def rectilinear():
    grid = vtkRectilinearGrid()
    grid.SetDimensions(5, 6, 7)
    for put, count in (
            (grid.SetXCoordinates, 5), (grid.SetYCoordinates, 6), (grid.SetZCoordinates, 7)):
        put(numpy_to_vtk(np.arange(count) ** 2 * 0.1, deep=True))
    values = vtkDoubleArray()
    values.SetName("cell value")
    for i in range(4 * 5 * 6):
        values.InsertNextValue(i)
    grid.GetCellData().AddArray(values)
    return grid


def structured():
    grid, points = vtkStructuredGrid(), vtkPoints()
    grid.SetDimensions(4, 4, 4)
    for k, j, i in np.ndindex(4, 4, 4):
        points.InsertNextPoint(i + 0.1 * j, j, k + 0.2 * i)
    grid.SetPoints(points)
    return grid


def blocks(first):
    cube = vtkCubeSource()
    cube.SetCenter(1.2, 0, 0)
    cube.Update()
    both = vtkMultiBlockDataSet()
    both.SetBlock(0, first)
    both.SetBlock(1, cube.GetOutput())
    return both


def picture(heights):
    image = vtkImageData()
    image.SetDimensions(heights.shape[1], heights.shape[0], 1)
    gray = np.round(heights * 6 + 128).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(gray.ravel(), deep=True))
    return image


def write(writer, data, path, **settings):
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    for name, value in settings.items():
        getattr(writer, name)(*value)
    writer.Write()


def gltf(buffer):
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.4, 0.2, 1]}}],
        "buffers": [{"byteLength": 60, **buffer}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]}


def write_gltf(folder):
    corners = struct.pack("<12f6H", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1, 0, 1, 2, 1, 3, 2)
    uri = "data:application/octet-stream;base64," + base64.b64encode(corners).decode()
    (folder / "a.gltf").write_text(json.dumps(gltf({"uri": uri})))
    text = json.dumps(gltf({})).encode()
    text += b" " * (-len(text) % 4)
    chunks = (struct.pack("<II", len(text), 0x4E4F534A) + text +
              struct.pack("<II", len(corners), 0x004E4942) + corners)
    (folder / "a.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def write_rasters(folder, values):
    """NRRD and SLC, which VTK does not write."""
    head = f"NRRD0004\ntype: short\ndimension: 3\nsizes: {SIDE} {SIDE} {SIDE}\nspacings: 1 1 1\n"
    raw = values.astype("<i2").tobytes()
    (folder / "raw.nrrd").write_bytes(f"{head}encoding: raw\nendian: little\n\n".encode() + raw)
    packed = gzip.compress(raw, mtime=0)
    (folder / "gzip.nrrd").write_bytes(f"{head}encoding: gzip\nendian: little\n\n".encode() + packed)
    slc = f"11111\n{SIDE} {SIDE} {SIDE}\n8\n1 1 1\n0 0 0 0\n1 1 X".encode() + bytes(3)
    (folder / "a.slc").write_bytes(slc + np.clip(values, 0, 255).astype(np.uint8).tobytes())


def write_dem(folder, heights):
    """One degree block of the USGS: a header of 1024 bytes, then a record for each profile."""
    rows, columns = heights.shape
    whole = np.round(heights).astype(int) + 100
    head = f"{'A HILL':<144}{1:6d}{1:6d}{1:6d}{10:6d}" + f"{0.0:24.15E}" * 15 + f"{2:6d}{2:6d}{4:6d}"
    for x, y in ((0, 0), (0, rows), (columns, rows), (columns, 0)):
        head += f"{x * 30.0:24.15E}{y * 30.0:24.15E}"
    head += f"{whole.min():24.15E}{whole.max():24.15E}{0.0:24.15E}{0:6d}"
    head += f"{30.0:12.6E}{30.0:12.6E}{1.0:12.6E}{1:6d}{columns:6d}"
    text = f"{head:<1024}"
    for column in range(columns):
        record = f"{1:6d}{column + 1:6d}{rows:6d}{1:6d}{column * 30.0:24.15E}{0.0:24.15E}{0.0:24.15E}"
        record += f"{whole[:, column].min():24.15E}{whole[:, column].max():24.15E}"
        text += f"{record + ''.join(f'{value:6d}' for value in whole[:, column]):<1024}"
    (folder / "a.dem").write_text(text)


def write_molecule(folder):
    names = ["N", "CA", "C", "O", "CB"] * 4
    lines = [
        f"ATOM  {i:5d}  {name:<3s} ALA A{i:4d}    {i * 1.1:8.3f}{i % 3:8.3f}{i % 5:8.3f}"
        f"  1.00  0.00           {name[0]:>2s}" for i, name in enumerate(names)]
    (folder / "a.pdb").write_text("\n".join([*lines, "END", ""]))


def make(folder):
    """Writes them to the folder; the paths, in the same order every time."""
    folder = pathlib.Path(folder)
    image, faces = volume(), surface()
    grid = tetrahedra(image)
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    raw = {"SetDataModeToAppended": (), "EncodeAppendedDataOff": (), "SetCompressorTypeToNone": ()}
    write(vtkXMLImageDataWriter(), image, folder / "a.vti")
    write(vtkXMLImageDataWriter(), image, folder / "raw.vti", **raw)
    write(vtkXMLPolyDataWriter(), faces, folder / "a.vtp")
    write(vtkXMLPolyDataWriter(), faces, folder / "ascii.vtp", SetDataModeToAscii=())
    write(vtkXMLUnstructuredGridWriter(), grid, folder / "a.vtu")
    write(vtkXMLRectilinearGridWriter(), rectilinear(), folder / "a.vtr")
    write(vtkXMLStructuredGridWriter(), structured(), folder / "a.vts")
    write(vtkXMLMultiBlockDataWriter(), blocks(faces), folder / "a.vtm")
    write(vtkPolyDataWriter(), faces, folder / "ascii.vtk")
    write(vtkPolyDataWriter(), faces, folder / "binary.vtk", SetFileTypeToBinary=())
    write(vtkStructuredPointsWriter(), image, folder / "image.vtk", SetFileTypeToBinary=())
    write(vtkUnstructuredGridWriter(), grid, folder / "grid.vtk", SetFileTypeToBinary=())
    write(vtkPLYWriter(), faces, folder / "a.ply")
    write(vtkPLYWriter(), faces, folder / "ascii.ply", SetFileTypeToASCII=())
    write(vtkSTLWriter(), faces, folder / "a.stl", SetFileTypeToBinary=())
    write(vtkSTLWriter(), faces, folder / "ascii.stl")
    write(vtkOBJWriter(), faces, folder / "a.obj")
    write(vtkNIFTIImageWriter(), image, folder / "a.nii")
    write(vtkNIFTIImageWriter(), image, folder / "a.nii.gz")
    write(vtkMetaImageWriter(), image, folder / "a.mha")
    write(vtkMetaImageWriter(), image, folder / "raw.mha", SetCompression=(False,))
    write(vtkExodusIIWriter(), grid, folder / "a.ex2")
    heights = np.fromfunction(lambda i, j: np.sin(i / 5) * np.cos(j / 7) * 20, (20, 25)).astype("f4")
    np.savez_compressed(folder / "a.npz", elevation=heights)
    np.save(folder / "a.npy", heights)
    for writer, name in (
            (vtkPNGWriter(), "a.png"), (vtkJPEGWriter(), "a.jpg"), (vtkTIFFWriter(), "a.tif")):
        write(writer, picture(heights), folder / name)
    write_gltf(folder)
    write_rasters(folder, values)
    write_dem(folder, np.tile(heights, (1, 5)))  # fewer than 100 columns VTK cannot read
    write_molecule(folder)
    return sorted(path for path in folder.iterdir() if path.is_file())
