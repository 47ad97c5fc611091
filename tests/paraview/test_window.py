# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window on a virtual display: the switch, the presets and the parameters in its panel."""
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from test_paraview import ENVIRONMENT, HERE, PLUGIN, TIMEOUT, Base

SCENES = HERE.parent.parent / "examples" / "scenes.py"


def qt_for_python():
    """Name of the Python package for ParaView's version of Qt."""
    paraview = shutil.which("paraview")
    libraries = subprocess.run(["ldd", paraview], capture_output=True, text=True).stdout if paraview else ""
    return "PyQt6" if "libQt6Core" in libraries else "PyQt5"


def missing():
    """Programs and packages that the test needs and that are not installed, or ''."""
    programs = [program for program in ("Xvfb", "paraview") if shutil.which(program) is None]
    modules = [module for module in (qt_for_python(),) if importlib.util.find_spec(module) is None]
    return ", ".join(programs + modules)


def write_terrain(path):
    """Write the demo's landscape to a file."""
    spec = importlib.util.spec_from_file_location("demo_scenes", SCENES)
    scenes = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(scenes)
    from vtkmodules import vtkRenderingOpenGL2  # noqa: F401 implements actors
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    renderer = scenes.terrain()
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(renderer.GetActors().GetLastActor().GetMapper().GetInputConnection(0, 0))
    writer.SetFileName(str(path))
    writer.SetDataModeToBinary()
    writer.Write()


class Display:
    """A virtual display for the duration of a with block, which gets its name."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
                                       pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        return f":{number}"

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


@unittest.skipIf(missing(), f"not installed: {missing()}")
class Window(Base):
    def open_window(self):
        data = self.folder / "terrain.vtp"
        write_terrain(data)
        plugins = self.folder / "plugins.xml"
        plugins.write_text(f'<Plugins><Plugin name="PenumbraGI" filename="{PLUGIN}" auto_load="1"/></Plugins>')
        home = self.folder / "home"
        home.mkdir(mode=0o700, exist_ok=True)
        with Display() as display:
            environment = ENVIRONMENT | {
                "DISPLAY": display, "HOME": str(home), "XDG_RUNTIME_DIR": str(home), "QT_QPA_PLATFORM": "xcb",
                "PV_PLUGIN_CONFIG_FILE": str(plugins), "PENUMBRA_WINDOW_DATA": str(data),
                "PENUMBRA_WINDOW_OUTPUT": str(self.folder)}
            command = ["paraview", "--disable-registry", f"--script={HERE / 'window.py'}"]
            process = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=TIMEOUT)
        self.messages = process.stdout + process.stderr
        self.assertTrue((self.folder / "result.json").exists(), f"ParaView ended with {process.returncode}: {self.messages}")
        result = json.loads((self.folder / "result.json").read_text())
        self.assertNotIn("failed", result, result.get("failed"))
        self.assertEqual(process.returncode, 0, self.messages)
        return result

    def test_the_panel_sets_switches_and_parameters(self):
        found = self.open_window()
        print(json.dumps(found, indent=1))
        for word in ("ERR|", "WARN|", "ERROR", "Traceback"):
            self.assertNotIn(word, self.messages + found["messages"])
        # The only message: probes were switched on before they were baked.
        self.assertRegex(found["messages"].strip(), "^Penumbra: the probes are on without a bake[^\\n]*$")
        self.assertTrue(found["has properties"])
        self.assertEqual(found["label of the switch"], "Global illumination")
        # If off, the panel shows only the switch; if on, the techniques' switches too. Parameters are advanced properties.
        self.assertEqual(found["rows when off"], ["GlobalIllumination"])
        self.assertIn("GIPreset", found["rows when on"])
        self.assertIn("GIShadowMaps", found["rows when on"])
        self.assertNotIn("GIShadowMapsResolution", found["rows when on"])
        self.assertGreater(found["changed by the switch"], 0.1)
        self.assertGreaterEqual(found["as enable() draws"], 0.995)
        self.assertTrue(found["switch follows enable()"])
        self.assertEqual(found["preset high"], {"resolution": [2048, 4096], "samples": 64, "reflections": [1, True],
                                                "box returns to": "choose"})
        self.assertGreaterEqual(found["as enable() draws high"], 0.999)
        self.assertIn("GIShadowMapsSlopeBias", found["advanced rows"])
        self.assertNotIn("GIPathTracingSamples", found["advanced rows"])  # its technique is off
        self.assertEqual(found["light's rows"], ["GIShape"])
        self.assertEqual(found["rectangle's rows"], ["GIShape", "GISize", "GITurn"])
        self.assertIn("Unit: texels", found["tooltip"])
        self.assertEqual(found["off again"], 1)
        self.assertEqual(max(found["horizontal overflow"]), 0)
        self.assertFalse(found["problem with probes"])
        # The trace of the changes in the panel works in another process.
        self.assertIn("renderView1.GIShadowMapsResolution = 512", found["recorded"])
        played = self.folder / "played.py"
        played.write_text("import penumbra.paraview\n" + (self.folder / "recorded.py").read_text() +
                          "\nprint('result', renderView1.GIShadowMapsResolution, renderView1.GIAmbientOcclusionSamples,"
                          " renderView1.GIAmbientOcclusionMethod)\n")
        self.assertIn("result 512 64 'hemisphere'", self.run_script("pvpython", played))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
