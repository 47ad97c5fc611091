# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: a lightmap that the command baked from files lights the same files in a view.

usage: lightmap.py FOLDER COMMAND
"""
import json
import subprocess
import sys

import scenes
from paraview import simple
from penumbra.paraview import enable
from PIL import Image
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

folder, command = sys.argv[1:]
WALLS = {"floor": ([-1, -1, -1], [1, -1, -1], [-1, 1, -1]), "back": ([-1, 1, -1], [1, 1, -1], [-1, 1, 1])}
COLOUR, LAMP = [0.7, 0.5, 0.3], [0.5, -0.6, 0.9]
CAMERA = {"position": [0.3, -4, 0.3], "focal": [0, 0.6, -0.8], "up": [0, 0, 1], "angle": 12}  # the walls fill the picture


def write_walls():
    """Write data files, and a scene file that shows them like ParaView."""
    for name, corners in WALLS.items():
        plane, normals, writer = vtkPlaneSource(), vtkPolyDataNormals(), vtkXMLPolyDataWriter()
        plane.SetOrigin(corners[0])
        plane.SetPoint1(corners[1])
        plane.SetPoint2(corners[2])
        normals.SetInputConnection(plane.GetOutputPort())
        writer.SetInputConnection(normals.GetOutputPort())
        writer.SetFileName(f"{folder}/{name}.vtp")
        writer.SetDataModeToBinary()
        writer.Write()
    material = {"color": COLOUR, "specular-power": 100}
    with open(f"{folder}/walls.json", "w") as file:
        json.dump({"objects": [{"name": name, "file": f"{name}.vtp", "material": material} for name in WALLS],
                   "lights": [{"type": "point", "position": LAMP, "intensity": 0.6}], "background": [0, 0, 0],
                   "camera": CAMERA}, file)


def run(*arguments):
    subprocess.run([command, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def problem():
    simple.Render(view)
    view.UpdatePropertyInformation()
    return view.GetProperty("GILightmapProblem").GetData()


write_walls()
run("bake", "lightmap", "walls.json", "-o", "map.vti", "--texel-size", "0.1", "--samples", "64")
run("render", "walls.json", "--bake", "map.vti", "--preset", "off", "--frames", "1",
    "--size", "{}x{}".format(*scenes.SIZE), "-o", "tool.png")

simple._DisableFirstRenderCameraReset()
view = scenes.make_view(UseLight=0, Background=[0, 0, 0])
shown = []
for name in WALLS:
    wall = simple.Show(simple.XMLPolyDataReader(FileName=[f"{folder}/{name}.vtp"]), view, "GeometryRepresentation")
    wall.ColorArrayName = [None, ""]
    wall.AmbientColor = wall.DiffuseColor = COLOUR
    shown.append(wall)
lamp = simple.AddLight(view=view)
lamp.Type, lamp.ConeAngle, lamp.Position, lamp.Intensity = "Positional", 180, LAMP, 0.6
view.CameraPosition, view.CameraFocalPoint = CAMERA["position"], CAMERA["focal"]
view.CameraViewUp, view.CameraViewAngle = CAMERA["up"], CAMERA["angle"]
enable(view, "off", lightmap__live_fallback=0)
plain = scenes.picture(view)
view.GILightmap = 1
view.GILightmapFile = f"{folder}/map.vti"
image = scenes.picture(view)
print("problem with it:", problem() or "none")
print(f"changed {1 - scenes.within(image, plain):.5f}")
Image.fromarray(image).save(f"{folder}/view.png")
with open(f"{folder}/map.vti", "rb") as whole, open(f"{folder}/cut.vti", "wb") as cut:
    cut.write(whole.read()[:4000])
with open(f"{folder}/old.exr", "wb") as old:
    old.write(b"\x76\x2f\x31\x01")
for name in ("nothing.vti", "view.png", "cut.vti", "old.exr"):
    view.GILightmapFile = f"{folder}/{name}"
    print("problem:", problem())
    print(f"unlit {scenes.within(scenes.picture(view), plain, 0):.5f}")
view.GILightmapFile = f"{folder}/map.vti"
print(f"again {scenes.within(scenes.picture(view), image, 0):.5f}")
shown[0].DiffuseColor = [0.7, 0.5, 0.4]  # the pass's note reports it
simple.Render(view)
print("problem with other data:", problem() or "none")
