# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: the scene drawn by a server, or by this process if no port is given.

usage: remote.py PICTURE [PORT]
"""
import sys

import scenes
from paraview import simple
from PIL import Image
from penumbra.paraview import enable

simple._DisableFirstRenderCameraReset()
if len(sys.argv) > 2:
    simple.Connect("localhost", int(sys.argv[2]))
    scenes.penumbra.paraview.load()
view = scenes.make_view()
if len(sys.argv) > 2:
    view.RemoteRenderThreshold = 0  # megabytes, so that the server always draws
    view.CompressorConfig = "vtkLZ4Compressor 0 3"  # lossless
scenes.show(view, scenes.sources())
enable(view, frames=2, look="studio")
Image.fromarray(scenes.picture(view)).save(sys.argv[1])
if len(sys.argv) > 2:
    scenes.refuse_to_bake(view, sys.argv[1] + ".vti")
print("remote", int(view.GetClientSideObject().GetUseDistributedRenderingForRender()))
