# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: switch global illumination on and off COUNT times, then all techniques. Prints the growth of memory and of
OpenGL objects.

usage: toggles.py COUNT
"""
import ctypes
import sys

import scenes
from paraview import simple
from penumbra import vtkGIPass
from penumbra.paraview import disable, enable, settings

HIGHEST_NAME = 100000  # drivers may give each object a new name


def objects():
    """Number of OpenGL objects of each kind."""
    view.GetRenderWindow().MakeCurrent()
    library = ctypes.CDLL("libGL.so.1")
    found = {}
    for kind in ("Texture", "Buffer", "Framebuffer", "Program"):
        exists = getattr(library, f"glIs{kind}")
        exists.restype = ctypes.c_ubyte
        found[kind] = sum(exists(name) for name in range(1, HIGHEST_NAME))
    return found


def resident():
    ctypes.CDLL("libc.so.6").malloc_trim(0)  # return free memory to the system
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096 / 2**20


count = int(sys.argv[1])
simple._DisableFirstRenderCameraReset()
view = scenes.make_view()
view.ViewSize = [160, 120]
scenes.show(view, scenes.sources())
plain = scenes.picture(view)


def cycle():
    enable(view, "balanced")
    lit = scenes.picture(view)
    disable(view)
    return lit, scenes.picture(view)


def techniques():
    proxy = settings(view)
    enable(view, "off")
    known = vtkGIPass()
    for name in [known.GetTechnique(i).GetClassName()[len("vtk"):] for i in range(known.GetNumberOfTechniques())]:
        for value in (1, 0):
            proxy.SMProxy.GetProperty(name).SetElement(0, value)
            proxy.SMProxy.UpdateVTKObjects()
            simple.Render(view)
    disable(view)


first, _ = cycle()
techniques()
before, sizes = objects(), []
for _ in range(count):
    last, after_off = cycle()
    sizes.append(resident())
techniques()
grown = {kind: count - before[kind] for kind, count in objects().items()}
# Pools of the allocator and the driver reach their size in the first quarter. What grows on grows in each later quarter; a
# driver may still keep one large buffer from some cycle on. So the smaller growth from one quarter to the next counts.
quarter = max(count // 4, 1)
least = [min(sizes[first:first + quarter]) for first in (quarter, 2 * quarter, count - quarter)]
print("grown", grown, "megabytes", round(min(least[1] - least[0], least[2] - least[1]), 1))
print("lit_equal", scenes.within(first, last, 0), "plain_equal", scenes.within(plain, after_off, 0))
