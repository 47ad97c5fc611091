#!/usr/bin/env python3
"""An MRI head with shadows and ambient occlusion: render_head.py HEAD.nii.gz OUT.png [WIDTH]"""
import sys
import penumbra
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

reader, skin, mapper = vtkNIFTIImageReader(), vtkFlyingEdges3D(), vtkPolyDataMapper()
reader.SetFileName(sys.argv[1])
skin.SetInputConnection(reader.GetOutputPort())
skin.SetValue(0, 32)
mapper.SetInputConnection(skin.GetOutputPort())
mapper.ScalarVisibilityOff()
head, light, renderer = vtkActor(), vtkLight(), vtkRenderer()
head.SetMapper(mapper)
head.GetProperty().SetColor(0.87, 0.68, 0.56)
light.SetPosition(1, 1, 1)
renderer.AddLight(light)
renderer.AddActor(head)
renderer.SetBackground(0.75, 0.78, 0.82)
renderer.GetActiveCamera().SetPosition(0.5, 1, 0.35)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(1.4)
penumbra.enable(renderer, "balanced")
width = int(sys.argv[3]) if len(sys.argv) > 3 else 800
penumbra.save_png(penumbra.window(renderer, size=(width, width)), sys.argv[2], frames=16)
