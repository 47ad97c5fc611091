#!/usr/bin/env python3
"""A radiosity solution next to the path tracer, in two views: cornell_radiosity.py SOLUTION.vtp OUT.png [WIDTH] [PATHS]

SOLUTION.vtp comes from: penumbra bake radiosity examples/cornell.json -o SOLUTION.vtp
"""
import json
import pathlib
import sys
import penumbra
from PIL import Image
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkPolyDataMapper, vtkRenderer

SCENE = json.loads((pathlib.Path(__file__).parent / "cornell.json").read_text())
width = int(sys.argv[3]) if len(sys.argv) > 3 else 400
paths = int(sys.argv[4]) if len(sys.argv) > 4 else 128


def solved():
    """Show the solution as it is, without lights or shading, so that any view is immediate."""
    reader, mapper, room, renderer = vtkXMLPolyDataReader(), vtkPolyDataMapper(), vtkActor(), vtkRenderer()
    reader.SetFileName(sys.argv[1])
    mapper.SetInputConnection(reader.GetOutputPort())  # the point scalars are colours
    room.SetMapper(mapper)
    room.GetProperty().LightingOff()
    room.GetProperty().BackfaceCullingOn()  # every cell is one side of a surface
    renderer.AddActor(room)
    return renderer


def scene():
    """Build the same room for the path tracer."""
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    for described in SCENE["objects"]:
        points, polygons, data = vtkPoints(), vtkCellArray(), vtkPolyData()
        for point in described["mesh"]["points"]:
            points.InsertNextPoint(point)
        for polygon in described["mesh"]["polygons"]:
            polygons.InsertNextCell(len(polygon), polygon)
        data.SetPoints(points)
        data.SetPolys(polygons)
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(data)
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
        material, surface = described["material"], actor.GetProperty()
        surface.SetColor(material["color"])
        if "emission" in material:
            surface.SetAmbient(1)
            surface.SetAmbientColor(material["emission"])
        else:
            surface.SetInterpolationToPBR()  # displayed with the same curve as the solution
            surface.SetRoughness(material["roughness"])
            surface.SetBaseIOR(material["ior"])
    return renderer


def look(renderer, turn):
    camera = vtkCamera()
    camera.SetPosition(SCENE["camera"]["position"])
    camera.SetFocalPoint(SCENE["camera"]["focal"][0], SCENE["camera"]["focal"][1], 280)  # the centre of the room
    camera.SetViewAngle(SCENE["camera"]["angle"])
    camera.Azimuth(turn)
    renderer.SetActiveCamera(camera)
    renderer.ResetCameraClippingRange()


sheet = Image.new("RGB", (2 * width, 2 * width))
for column, renderer in enumerate((solved(), scene())):
    if column == 1:
        penumbra.enable(renderer, "reference", path_tracing__samples=paths)
    window = penumbra.window(renderer, size=(width, width))
    for row, turn in enumerate((0, 12)):
        look(renderer, turn)
        picture = penumbra.render(window, frames=paths if column == 1 else 1)
        sheet.paste(Image.fromarray(picture), (column * width, row * width))
sheet.save(sys.argv[2])
