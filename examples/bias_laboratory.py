#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadow bias by hand: a slider for each bias of the shadow maps, and acne and gap as numbers, measured against rays.

usage: bias_laboratory.py SCENE.py[:FUNCTION] [--headless OUT.png]
"""
import argparse

import penumbra
from penumbra.shadow_bias import Bench, bias_kinds, measure
from penumbra.shadow_bias.__main__ import load_scene
from penumbra.shadow_bias.study import LIMITS, percent
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkInteractionWidgets import vtkSliderRepresentation2D, vtkSliderWidget
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor, vtkTextActor
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

MOST = 5  # texels; with a larger bias shadows detach from their casters in every scene
INK = (0.1, 0.1, 0.1)


class Laboratory:
    def __init__(self, window, renderer, interactor):
        self.window = window
        self.bench = Bench(window, renderer)
        self.judge = self.resolution = None
        self.label = vtkTextActor()
        text = self.label.GetTextProperty()
        text.SetFontSize(18)
        text.SetColor(INK)
        text.SetBackgroundColor(1, 1, 1)
        text.SetBackgroundOpacity(0.75)
        self.label.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        self.label.SetPosition(0.02, 0.84)
        renderer.AddViewProp(self.label)
        kinds = bias_kinds(self.bench.maps)
        self.sliders = {kind + "-bias": self.slider(interactor, kind + "-bias", i / len(kinds), (i + 1) / len(kinds))
                        for i, kind in enumerate(kinds)}
        interactor.GetInteractorStyle().AddObserver("EndInteractionEvent", lambda *_: self.measure_view())
        self.measure_view()

    def slider(self, interactor, parameter, left, right):
        representation = vtkSliderRepresentation2D()
        representation.SetMinimumValue(0)
        representation.SetMaximumValue(MOST)
        representation.SetValue(self.bench.maps.GetParameter(parameter))
        representation.SetTitleText(parameter + ", texels")
        representation.SetLabelFormat("%.2f")
        for point, x in ((representation.GetPoint1Coordinate(), left + 0.03),
                         (representation.GetPoint2Coordinate(), right - 0.03)):
            point.SetCoordinateSystemToNormalizedDisplay()
            point.SetValue(x, 0.1)
        for text in (representation.GetTitleProperty(), representation.GetLabelProperty()):
            text.SetColor(INK)
            text.ShadowOff()
            text.BoldOff()
        representation.GetTubeProperty().SetColor(0.5, 0.5, 0.5)
        widget = vtkSliderWidget()
        widget.SetInteractor(interactor)
        widget.SetRepresentation(representation)
        widget.EnabledOn()
        widget.AddObserver("InteractionEvent", lambda *_: self.measure())
        return widget

    def measure_view(self):
        """Measure at the current camera position: first ray-traced shadows, then the errors of the map."""
        self.hide(True)
        try:
            self.judge = measure(self.bench, self.resolution)
        except ValueError as error:
            self.judge = None
            self.show(str(error))
        else:
            self.resolution = int(self.bench.maps.GetParameter("resolution"))
            self.measure()

    def measure(self):
        if self.judge is None:
            return
        for parameter, slider in self.sliders.items():
            self.bench.maps.SetParameter(parameter, slider.GetRepresentation().GetValue())
        self.hide(True)
        errors = self.judge.measure(self.bench.draw_mask())
        self.show(f"acne {percent(errors['acne'])}{': too much' if errors['acne'] > LIMITS['acne'] else ''}\n"
                  f"gap {errors['gap']:.2f} texels{': too wide' if errors['gap'] > LIMITS['gap'] else ''}\n"
                  f"map of {self.resolution} texels per side")

    def show(self, text):
        self.label.SetInput(text)
        self.hide(False)
        self.window.Render()

    def hide(self, hidden):
        """Show or hide sliders and texts, which would be drawn into the depth that positions are read from."""
        self.window.SetSwapBuffers(not hidden)
        for prop in (self.label, *(slider.GetRepresentation() for slider in self.sliders.values())):
            prop.SetVisibility(not hidden)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scene", metavar="SCENE.py[:FUNCTION]")
    parser.add_argument("--headless", metavar="OUT.png", help="write the window's picture and exit")
    options = parser.parse_args()
    try:
        renderer = load_scene(options.scene)
    except ValueError as error:
        parser.exit(1, f"bias_laboratory: {error}\n")
    window = penumbra.window(renderer, size=(640, 400), multisamples=0)
    window.SetOffScreenRendering(bool(options.headless))
    interactor = vtkGenericRenderWindowInteractor() if options.headless else vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    window.Render()
    Laboratory(window, renderer, interactor)
    if options.headless:
        penumbra.save_png(window, options.headless)
    else:
        interactor.Start()


if __name__ == "__main__":
    main()
