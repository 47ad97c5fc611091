# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's window (paraview --script): use global illumination in the panel, with mouse and keyboard.

environment: PENUMBRA_WINDOW_DATA, a file with polygons; PENUMBRA_WINDOW_OUTPUT, a folder for pictures and for
result.json, with the findings or the error.

Steps are generators that yield seconds during which the window's event loop runs. ParaView records traces with Python from
this loop, so it must not be run from here.
"""
import json
import os
import pathlib
import time
import traceback

import scenes
from paraview import simple, smtrace
from penumbra.paraview import disable, enable  # the plugin is loaded already

# The package for this ParaView's version of Qt.
if "libQt6Core" in pathlib.Path("/proc/self/maps").read_text(encoding="utf-8"):
    from PyQt6.QtCore import QPoint, Qt, QTimer
    from PyQt6.QtTest import QTest
    from PyQt6.QtWidgets import (QApplication, QCheckBox, QComboBox, QDockWidget, QLabel, QLineEdit, QMainWindow,
                                 QPlainTextEdit, QPushButton, QScrollArea, QTextEdit, QToolButton, QWidget)
else:
    from PyQt5.QtCore import QPoint, Qt, QTimer
    from PyQt5.QtTest import QTest
    from PyQt5.QtWidgets import (QApplication, QCheckBox, QComboBox, QDockWidget, QLabel, QLineEdit, QMainWindow,
                                 QPlainTextEdit, QPushButton, QScrollArea, QTextEdit, QToolButton, QWidget)

FOLDER = pathlib.Path(os.environ["PENUMBRA_WINDOW_OUTPUT"])
TIMEOUT = 600  # seconds; an idle machine needs a fraction of one
RESULT = {}


def wait(event, condition):
    end = time.monotonic() + TIMEOUT
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"did not happen within {TIMEOUT} s: {event}")
        yield 0.1


class Panel:
    """A panel of properties, as a user operates it."""

    def __init__(self, window, name="propertiesPanel"):
        self.panel = window.findChild(QWidget, name)
        self.area = self.panel.findChild(QScrollArea, "scrollArea")

    def widget(self, name, kind):
        """The widget of a given class in a property's row."""
        row = self.panel.findChild(QWidget, name)
        if row is None:
            raise AssertionError(f"the panel has no row '{name}'")
        return row if kind is QWidget else row.findChild(kind)

    def click(self, widget):
        self.area.ensureWidgetVisible(widget)
        yield 0.2
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, QPoint(10, widget.height() // 2))
        yield 0.2

    def choose(self, name, text):
        """Open a combo box and click an entry."""
        box = self.widget(name, QComboBox)
        self.area.ensureWidgetVisible(box)
        box.showPopup()
        yield 0.3
        choices = box.view()
        index = box.model().index(box.findText(text), 0)
        QTest.mouseClick(choices.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, choices.visualRect(index).center())
        yield 0.2

    def write(self, name, text):
        line = self.widget(name, QLineEdit)
        self.area.ensureWidgetVisible(line)
        line.setFocus()
        line.selectAll()
        QTest.keyClicks(line, text)
        QTest.keyClick(line, Qt.Key.Key_Return)
        yield 0.2

    def show_advanced(self):
        return self.click(self.panel.findChild(QToolButton, "AdvancedButton"))

    def visible(self):
        """Names of our visible rows, scrolled into view or not."""
        return {row.objectName() for row in self.panel.findChildren(QWidget)
                if row.objectName().startswith(("GI", "GlobalIllumination")) and row.isVisibleTo(self.area.widget())}

    def titles(self):
        return {label.text() for label in self.panel.findChildren(QLabel)
                if ("lobal illumination" in label.text() or "GI: " in label.text()) and label.isVisibleTo(self.area.widget())}

    def overhang(self):
        """Pixels by which the content is wider than the panel."""
        return self.area.horizontalScrollBar().maximum()


def photograph(window, name):
    yield 0.5
    window.screen().grabWindow(0).save(str(FOLDER / f"{name}.png"))


def screenshot(view):
    """Screenshot of the view, which does not depend on earlier averages."""
    return scenes.saved(view, FOLDER / "screenshot.png", view.ViewSize)


def scene(view):
    """Show a landscape under a fixed light, seen from the south."""
    simple._DisableFirstRenderCameraReset()
    surface = simple.OpenDataFile(os.environ["PENUMBRA_WINDOW_DATA"])
    display = simple.Show(surface, view)
    view.UseColorPaletteForBackground, view.BackgroundColorMode = 0, "Gradient"
    view.Background, view.Background2 = [0.93, 0.94, 0.95], [0.60, 0.72, 0.86]
    view.OrientationAxesVisibility = 0
    display.SetScalarBarVisibility(view, False)
    colors = simple.GetColorTransferFunction("elevation")
    colors.RGBPoints = [236, 0.36, 0.47, 0.30, 330, 0.50, 0.58, 0.37, 480, 0.72, 0.69, 0.48, 700, 0.66, 0.54, 0.42,
                        900, 0.72, 0.66, 0.60, 1076, 0.93, 0.92, 0.90]
    bounds = surface.GetDataInformation().GetBounds()
    middle = [(bounds[i] + bounds[i + 1]) / 2 for i in (0, 2, 4)]
    size = bounds[1] - bounds[0]
    view.KeyLightIntensity = 0.15
    lamp = simple.AddLight(view=view)
    lamp.Type, lamp.Intensity = "Directional", 1.1
    lamp.FocalPoint = middle
    lamp.Position = [middle[0] - 0.9 * size, middle[1] + 0.35 * size, middle[2] + 0.45 * size]
    view.CameraFocalPoint = [middle[0] - 0.02 * size, middle[1] - 0.04 * size, middle[2]]
    view.CameraPosition = [middle[0] + 0.22 * size, middle[1] - 1.2 * size, middle[2] + 0.7 * size]
    view.CameraViewUp = [0, 0, 1]
    simple.Render(view)


def steps():
    window = next(w for w in QApplication.topLevelWidgets() if isinstance(w, QMainWindow))
    window.resize(window.screen().size())
    window.move(0, 0)
    browser = window.findChild(QDockWidget, "pipelineBrowserDock")
    window.resizeDocks([browser], [360], Qt.Orientation.Horizontal)
    window.resizeDocks([browser], [110], Qt.Orientation.Vertical)
    view = simple.GetActiveView()
    RESULT["has properties"] = bool(view.SMProxy.GetProperty("GlobalIllumination"))
    scene(view)
    panel = Panel(window)
    for section in ("PropertiesButton", "DisplayButton"):
        yield from panel.click(panel.panel.findChild(QWidget, section))
    yield 1
    plain = scenes.capture(view)
    RESULT["rows when off"] = sorted(panel.visible())
    narrow = panel.overhang()
    yield from photograph(window, "off")

    switch = panel.widget("GlobalIllumination", QCheckBox)
    RESULT["label of the switch"] = switch.text()
    yield from panel.click(switch)
    yield from wait("the picture changes as the switch is clicked", lambda: scenes.within(scenes.capture(view), plain) < 0.9)
    yield 1
    lit = scenes.capture(view)
    RESULT["changed by the switch"] = 1 - scenes.within(lit, plain)
    RESULT["rows when on"] = sorted(panel.visible())
    panel.area.ensureWidgetVisible(panel.widget("GIAntiAliasing", QWidget))
    yield from photograph(window, "on")

    yield from panel.click(switch)
    yield from wait("the picture is as before as the switch is clicked again",
                    lambda: scenes.within(scenes.capture(view), plain, 0) == 1)
    enable(view, "balanced")
    simple.Render(view)
    yield from wait("the switch follows enable()", switch.isChecked)
    RESULT["switch follows enable()"] = switch.isChecked()
    RESULT["as enable() draws"] = scenes.within(scenes.capture(view), lit)

    def resolution():
        return view.GIShadowMapsResolution

    before = resolution()
    smtrace.start_trace()
    yield from panel.choose("GIPreset", "high")
    yield from wait("the preset sets the resolution of shadow maps", lambda: resolution() != before)
    yield 1
    RESULT["preset high"] = {
        "resolution": [before, resolution()], "samples": view.GIAmbientOcclusionSamples,
        "reflections": [view.GIScreenSpaceReflections, panel.widget("GIScreenSpaceReflections", QCheckBox).isChecked()],
        "box returns to": panel.widget("GIPreset", QComboBox).currentText()}
    view.GIDDGIProbes, view.GIDDGIUpdates = 64, 4
    for _ in range(5):
        simple.Render(view)  # until the probes have converged
    high = screenshot(view)
    enable(view, "high", ddgi__probes=64, ddgi__updates=4)
    RESULT["as enable() draws high"] = scenes.within(screenshot(view), high)

    switched = panel.visible()
    yield from panel.show_advanced()
    yield from wait("advanced rows appear", lambda: len(panel.visible()) > len(switched))
    RESULT["advanced rows"] = sorted(panel.visible() - switched)
    RESULT["titles"] = sorted(panel.titles())
    yield from panel.write("GIShadowMapsResolution", "512")
    yield from wait("an entered number is set", lambda: resolution() == 512)
    yield from panel.choose("GIAmbientOcclusionMethod", "hemisphere")
    yield from wait("a chosen entry is set", lambda: view.GIAmbientOcclusionMethod == "hemisphere")
    trace = smtrace.stop_trace()
    (FOLDER / "recorded.py").write_text(trace)
    RESULT["recorded"] = [line.strip() for line in trace.splitlines() if ".GI" in line]
    RESULT["tooltip"] = panel.widget("GIShadowMapsSlopeBias", QWidget).toolTip()
    RESULT["horizontal overflow"] = [narrow, panel.overhang()]
    panel.area.ensureWidgetVisible(panel.widget("GIShadowMapsFilterRadius", QWidget))
    yield from photograph(window, "advanced")

    yield from panel.click(panel.widget("GIDDGI", QCheckBox))  # DDGI would take precedence over baked probes
    yield from panel.click(panel.widget("GISHProbes", QCheckBox))
    yield from panel.write("GISHProbesCount", "60")
    yield from panel.write("GISHProbesSamples", "16")
    yield 0.5
    before = scenes.capture(view)
    yield from panel.click(panel.widget("GISHProbesBake", QPushButton))
    yield from wait("baked probes change the picture", lambda: scenes.within(scenes.capture(view), before) < 0.95)
    view.UpdatePropertyInformation()
    RESULT["problem with probes"] = view.GetProperty("GISHProbesProblem").GetData()
    panel.area.ensureWidgetVisible(panel.widget("GISHProbesIntensity", QWidget))
    yield from photograph(window, "baked")
    view.GISHProbes = 0
    yield from panel.show_advanced()
    disable(view)
    simple.Render(view)
    RESULT["off again"] = scenes.within(scenes.capture(view), plain, 0)
    yield from light_steps(window, view)
    output = window.findChild(QWidget, "outputWidgetDock")
    RESULT["messages"] = "".join(text.toPlainText() for kind in (QPlainTextEdit, QTextEdit) for text in output.findChildren(kind))


def light_steps(window, view):
    """The rows of the scene's light in the Light Inspector follow its shape, which is chosen there."""
    lamp = view.AdditionalLights[0]
    dock = window.findChild(QDockWidget, "lightInspectorDock")
    dock.show()
    dock.raise_()
    yield 1
    names = ("GIShape", "GIAngle", "GIRadius", "GISize", "GITurn")
    panel = Panel(window, "lightInspectorPanel")

    def rows():
        return [name for name in names if not panel.widget(name, QWidget).isHidden()]

    RESULT["light's rows"] = rows()
    yield from panel.choose("GIShape", "rectangle")
    yield from wait("the shape is set", lambda: lamp.GIShape == "rectangle")
    RESULT["rectangle's rows"] = rows()
    yield from photograph(window, "light")


def run(remaining):
    """Run the next step, then the remaining ones after the event loop has run. Closes the window after the last one."""
    try:
        QTimer.singleShot(int(1000 * next(remaining)), lambda: run(remaining))
        return
    except StopIteration:
        pass
    except BaseException:
        RESULT["failed"] = traceback.format_exc()
    (FOLDER / "result.json").write_text(json.dumps(RESULT, indent=1))
    QApplication.exit(0)


run(steps())
