# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython or pvbatch: SaveScreenshot at the view's size, larger, with a transparent background, and of a chart.

usage: screenshots.py FOLDER
"""
import sys

import scenes
from paraview import simple
from penumbra.paraview import enable

folder = sys.argv[1]
simple._DisableFirstRenderCameraReset()
view = scenes.make_view()
scenes.show(view, scenes.sources())
enable(view, frames=4)
simple.Render(view)
width, height = scenes.SIZE
small, large = [width, height], [3 * width, 3 * height]
simple.SaveScreenshot(f"{folder}/same.png", view, ImageResolution=small)
simple.SaveScreenshot(f"{folder}/transparent.png", view, ImageResolution=small, TransparentBackground=1)
simple.SaveScreenshot(f"{folder}/again.png", view, ImageResolution=small)
# ParaView draws pictures larger than the view in tiles. All screen-space techniques are on.
scenes.settle(view)
simple.SaveScreenshot(f"{folder}/tiled.png", view, ImageResolution=large)
view.ViewSize = large
simple.SaveScreenshot(f"{folder}/whole.png", view, ImageResolution=large)

chart = simple.CreateView("XYChartView")
chart.ViewSize = small
# The defaults of end points and colours differ between releases.
line = simple.PlotOverLine(Input=simple.Wavelet(), Point1=[-10, -10, -10], Point2=[10, 10, 10])
simple.Show(line, chart).SeriesColor = ["RTData", "0.89", "0.1", "0.11"]
simple.SaveScreenshot(f"{folder}/chart.png", chart, ImageResolution=small)
