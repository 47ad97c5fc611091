# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: global illumination in a view that was created before the plugin was loaded. Prints shares of pixels."""
import penumbra  # noqa: F401 so that windows can be created without a display
from paraview import simple

simple._DisableFirstRenderCameraReset()
view = simple.CreateView("RenderView")

import scenes  # noqa: E402 loads the plugin
from penumbra.paraview import disable, enable  # noqa: E402

print("has properties:", bool(view.SMProxy.GetProperty("GlobalIllumination")))
sources = scenes.sources()
scenes.show(scenes.prepare_view(view), sources)
plain = scenes.picture(view)
enable(view, "balanced")
lit = scenes.picture(view)
disable(view)
off = scenes.picture(view)

other = scenes.make_view()
scenes.show(other, sources)
enable(other, "balanced")
print("changed", 1 - scenes.within(lit, plain), "as_a_new_view", scenes.within(lit, scenes.picture(other), 0),
      "off_again", scenes.within(off, plain, 0))
