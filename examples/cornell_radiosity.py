#!/usr/bin/env python3
"""A radiosity solution beside the path tracer, from two views: cornell_radiosity.py SOLUTION.vtp OUT.png [WIDTH] [SPP]"""
import sys
import penumbra
from PIL import Image
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkPolyDataMapper, vtkRenderer

reader = vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
solution = reader.GetOutput()
width = int(sys.argv[3]) if len(sys.argv) > 3 else 400
samples = int(sys.argv[4]) if len(sys.argv) > 4 else 128


def actor(data):
    mapper, made = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    made.SetMapper(mapper)
    made.GetProperty().BackfaceCullingOn()  # every cell is one side of a surface
    return made


def solved():
    """What was worked out, shown as it is: no light, no shading, any frame rate."""
    renderer, room = vtkRenderer(), actor(solution)
    room.GetMapper().ScalarVisibilityOn()
    room.GetMapper().SetScalarModeToUsePointData()
    room.GetProperty().LightingOff()
    renderer.AddActor(room)
    return renderer


def scene():
    """The surfaces again, for the path tracer: a piece for each pair of albedo and emission."""
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    cells = solution.GetCellData()
    looks = [cells.GetArray(name).GetTuple3(i) for i in range(solution.GetNumberOfCells())
             for name in ("albedo", "emission")]
    looks = list(zip(looks[::2], looks[1::2]))
    known = sorted(set(looks))
    numbers = vtkUnsignedCharArray()
    numbers.SetName("look")
    for look in looks:
        numbers.InsertNextValue(known.index(look))
    cells.AddArray(numbers)
    for number, (albedo, emission) in enumerate(known):
        piece, polygons = vtkThreshold(), vtkGeometryFilter()
        piece.SetInputData(solution)
        piece.SetInputArrayToProcess(0, 0, 0, 1, "look")
        piece.SetLowerThreshold(number)
        piece.SetUpperThreshold(number)
        polygons.SetInputConnection(piece.GetOutputPort())
        polygons.Update()
        part = actor(polygons.GetOutput())
        surface = part.GetProperty()
        surface.BackfaceCullingOff()
        surface.SetInterpolationToPBR()  # shown with the same curve as the solution's colours
        surface.SetRoughness(1)
        surface.SetBaseIOR(1)  # no highlight
        surface.SetColor(albedo)
        if any(emission):
            surface.SetInterpolationToFlat()
            surface.SetAmbient(1)
            surface.SetAmbientColor(emission)
        renderer.AddActor(part)
    return renderer


def look(renderer, turn):
    camera = vtkCamera()
    camera.SetPosition(278, 273, -800)
    camera.SetFocalPoint(278, 273, 280)
    camera.SetViewAngle(39.3)
    camera.Azimuth(turn)
    renderer.SetActiveCamera(camera)
    renderer.ResetCameraClippingRange()


sheet = Image.new("RGB", (2 * width, 2 * width))
for column, renderer in enumerate((solved(), scene())):
    if column == 1:
        penumbra.enable(renderer, "reference", path_tracing__samples=samples)
    window = penumbra.window(renderer, size=(width, width))
    for row, turn in enumerate((0, 12)):
        look(renderer, turn)
        frames = samples if column == 1 else 1
        sheet.paste(Image.fromarray(penumbra.render(window, frames=frames)), (column * width, row * width))
sheet.save(sys.argv[2])
