# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython or pvbatch: draw a scene in ParaView's view and with VTK alone, with the same settings.

usage: draw_both.py PRESET FOLDER [TECHNIQUE...]      prints shares of equal and changed pixels
"""
import sys

import scenes
import penumbra
from paraview import simple
from PIL import Image
from penumbra.paraview import enable

preset, folder, extra = sys.argv[1], sys.argv[2], sys.argv[3:]
simple._DisableFirstRenderCameraReset()
view = scenes.make_view()
sources = scenes.sources()
scenes.show(view, sources)
plain = scenes.picture(view)
enable(view, preset, on=extra)
lit = scenes.picture(view)

renderer = scenes.vtk_renderer(view, sources)
window = penumbra.window(renderer, size=scenes.SIZE, multisamples=view.GetRenderWindow().GetMultiSamples())
# ParaView's windows have a stencil buffer, and thus fewer bits of depth.
window.SetStencilCapable(view.GetRenderWindow().GetStencilCapable())
penumbra.enable(renderer, preset, on=extra)
truth = penumbra.render(window)

for name, image in (("plain", plain), ("lit", lit), ("vtk", truth)):
    Image.fromarray(image).save(f"{folder}/{preset}_{name}.png")
print(f"equal {scenes.within(lit, truth):.5f} changed {1 - scenes.within(lit, plain):.5f}")
