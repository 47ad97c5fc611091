# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Real-time global illumination for VTK.

    import penumbra
    penumbra.enable(renderer, "balanced")

Importing it also makes vtkRenderWindow() work without a display.
"""
import importlib as _importlib

# Importing these modules registers VTK's OpenGL classes, text, volumes and 2-D charts.
for _name in ("vtkRenderingOpenGL2", "vtkRenderingFreeType", "vtkRenderingVolumeOpenGL2",
              "vtkRenderingContextOpenGL2", "vtkInteractionStyle", "vtkRenderingUI"):
    _importlib.import_module("vtkmodules." + _name)
del _importlib, _name

from .vtkRenderingGI import *  # noqa: F403,E402 the wrapped classes, vtkGIPass and its like
from .images import radiance, relative_error, render, save_png, window  # noqa: E402
from .passes import disable, enable, frame_chart, load_bake, looks, presets, statistics, techniques  # noqa: E402

__version__ = "0.1.0"
