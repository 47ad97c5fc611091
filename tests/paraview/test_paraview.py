# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView with the plugin in scripts: pvpython and pvbatch without a display."""
import json
import os
import pathlib
import re
import runpy
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
# Let Open MPI run as root, as in a container, and waiting ranks yield the processor.
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
ENVIRONMENT = {key: value for key, value in os.environ.items() if key != "DISPLAY"} | MPI
PACKAGE = pathlib.Path(os.environ.get("PENUMBRA_PYTHON_PATH", HERE.parent.parent / "build" / "python"))
PLUGIN = (PACKAGE / "penumbra" / runpy.run_path(PACKAGE / "penumbra" / "_plugin_path.py")["PLUGIN"]).resolve()
TIMEOUT = 3600  # seconds after which a program counts as stuck
ENVIRONMENT["PYTHONPATH"] = os.pathsep.join([str(PACKAGE), str(HERE)])


def picture(path):
    return numpy.asarray(Image.open(path)).astype(int)


def within(one, other, limit=2):
    return float((numpy.abs(one - other).max(axis=2) <= limit).mean())


class Base(unittest.TestCase):
    def setUp(self):
        kept = os.environ.get("PENUMBRA_TEST_OUTPUT")
        self.folder = pathlib.Path(kept or tempfile.mkdtemp())
        self.folder.mkdir(parents=True, exist_ok=True)
        if not kept:
            self.addCleanup(shutil.rmtree, self.folder)

    # ParaView 6.1 logs these without the plugin too: a warning of Mesa 26 about VTK's shader of shaded volumes, and two
    # of its own in each picture after SelectCells, which representations.py calls.
    STOCK_MESSAGES = {"": [r"GL Message.*`g_dataPos' used uninitialized"],
                        "representations.py": [r"vtkSMPropertyHelper.*Failed to locate property: Input$",
                                               r"vtkSMPropertyHelper.*not supported for the current property type\.$"]}

    @classmethod
    def without_stock_messages(cls, output, script):
        patterns = cls.STOCK_MESSAGES[""] + cls.STOCK_MESSAGES.get(script, [])
        return "\n".join(line for line in output.splitlines()
                         if not any(re.search(pattern, line) for pattern in patterns))

    def run_script(self, program, script, *arguments):
        """Run a script, and check that ParaView reports no error or warning. Returns the output."""
        command = [*program.split(), str(HERE / script), *map(str, arguments)]
        process = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=TIMEOUT)
        output = self.without_stock_messages(process.stdout + process.stderr, script)
        self.messages = output
        self.assertEqual(process.returncode, 0, output)
        for word in ("ERR|", "WARN|", "Traceback", "Error"):
            self.assertNotIn(word, output)
        print(f"\n{program} {script} {' '.join(map(str, arguments[:1]))}: {process.stdout.strip()}")
        return process.stdout

    def check_refusal(self, text):
        """Check that baking with several processes reports an error once, raises it, and writes no file."""
        self.assertRegex(text, "refused: .* cannot be baked by several processes.* False")
        self.assertEqual(self.messages.count("by several processes"), 2, self.messages)

    def number(self, name, text):
        return float(re.search(rf"\b{name}'?:? ([-\d.]+)", text).group(1))


class Pictures(Base):
    # The blending of edges differs by up to 2 of 255. Up to 0.5 % of the pixels, along edges, may differ because
    # ParaView's mappers and VTK's transform points in a different order of operations.
    def check_same_as_vtk(self, program, preset, *techniques):
        text = self.run_script(program, "draw_both.py", preset, self.folder, *techniques)
        self.assertGreaterEqual(self.number("equal", text), 0.995)
        return self.number("changed", text)

    def test_a_view_equals_vtk(self):
        self.assertGreater(self.check_same_as_vtk("pvpython", "balanced"), 0.3)

    def test_a_view_with_probes_equals_vtk(self):
        self.assertGreater(self.check_same_as_vtk("pvpython", "high", "ddgi"), 0.3)

    def test_off_equals_paraview(self):
        self.assertLess(self.check_same_as_vtk("pvpython", "off"), 0.005)

    def test_batch_equals_vtk(self):
        self.assertGreater(self.check_same_as_vtk("pvbatch", "balanced"), 0.3)


class Representations(Base):
    def test_representations_and_settings(self):
        text = self.run_script("pvpython", "representations.py", self.folder)
        cases = re.findall(r"(\w+): off ([\d.]+) balanced_changes ([\d.]+) after ([\d.]+)", text)
        self.assertGreaterEqual(len(cases), 20)
        for name, off, changed, after in cases:
            with self.subTest(name):
                self.assertGreaterEqual(float(off), 0.995)
                self.assertEqual(float(after), 1.0)
                # Without a light nothing is shaded.
                self.assertGreater(float(changed), -1.0 if name == "no_light_kit" else 0.02)


class Animations(Base):
    def test_frames_show_their_own_time(self):
        text = self.run_script("pvpython", "animations.py", self.folder)
        errors = re.findall(r"frame \d: ([\d.e-]+)", text)
        self.assertEqual(len(errors), 3)
        for error in errors:
            self.assertLessEqual(float(error), 0.002)
        self.assertGreater(self.number("film moves", text), 0.02)


class Volumes(Base):
    def test_volumes_keep_their_shape(self):
        text = self.run_script("pvpython", "volumes.py", self.folder)
        for frames in (2, 1):
            common, pixels = re.search(rf"silhouette {frames}: ([\d.]+) of (\d+)", text).groups()
            self.assertGreaterEqual(float(common), 0.98)
            self.assertGreater(int(pixels), 5000)


class Screenshots(Base):
    def check_screenshots(self, program):
        self.run_script(program, "screenshots.py", self.folder)
        same, again = picture(self.folder / "same.png"), picture(self.folder / "again.png")
        self.assertEqual(within(same, again, 0), 1.0)
        tiled, whole = picture(self.folder / "tiled.png"), picture(self.folder / "whole.png")
        self.assertEqual(tiled.shape[:2], (3 * same.shape[0], 3 * same.shape[1]))
        # ParaView smooths edges in each tile separately.
        self.assertGreaterEqual(within(tiled, whole), 0.995)
        clear = picture(self.folder / "transparent.png")
        self.assertEqual(clear.shape[2], 4)
        opaque, empty = clear[..., 3] == 255, clear[..., 3] == 0
        self.assertGreater(opaque.mean(), 0.5)
        self.assertGreater(empty.mean(), 0.2)
        self.assertLess(1 - opaque.mean() - empty.mean(), 0.03)  # smoothed edges
        difference = numpy.abs(clear[..., :3] - same[..., :3]).max(axis=2)
        self.assertGreaterEqual((difference[opaque] <= 2).mean(), 0.98)
        red, green, blue = numpy.moveaxis(picture(self.folder / "chart.png")[..., :3], 2, 0)
        self.assertGreater(((red > 150) & (green < 100) & (blue < 100)).sum(), 100)  # its curve

    def test_screenshots(self):
        self.check_screenshots("pvpython")

    def test_screenshots_in_batch(self):
        self.check_screenshots("pvbatch")


class Session(Base):
    """Other uses of a view with global illumination, in one process of ParaView."""

    def test_session(self):
        text = self.run_script("pvpython", "session.py", self.folder)
        for name, limit in (("animation", 1), ("left view", 0.999), ("right view", 0.999), ("interactive frames", 1),
                            ("after interaction", 1), ("selection", 1), ("pick", 1), ("annotation", 0.98),
                            ("after toggles", 1), ("look kept", 1), ("look again", 0.999), ("look undone", 1),
                            ("look values", 1), ("parallel as tiles", 0.995)):
            with self.subTest(name):
                self.assertGreaterEqual(self.number(name, text), limit)
        for name in ("views differ", "animation moves", "interactive is lit", "tone mapping changes", "look changes",
                     "setting below the look"):
            with self.subTest(name):
                self.assertGreater(self.number(name, text), 0.02)
        self.assertIn("refused: there is no look 'no-such': there are as-is, ", text)
        self.assertRegex(text, "refused: the look '.*/none.json' cannot be read")


class Budget(Base):
    def test_the_budget_lowers_moving_pictures_only(self):
        text = self.run_script("pvpython", "budget.py", self.folder)
        for name in ("still", "screenshot", "beside it", "screenshot has none"):
            with self.subTest(name):
                self.assertEqual(self.number(name, text), 1.0)
        self.assertGreater(self.number("moving is lowered", text), 0.005)
        self.assertGreater(self.number("chart covers", text), 0.3)
        self.assertEqual(text.count("ms is not possible: it must be from 1 to 10000"), 4)
        self.assertIn("deleted: [0, 1, 0, 1, 0]", text)


class Baked(Base):
    def test_probes_are_baked_written_and_checked(self):
        text = self.run_script("pvpython", "baked.py", "bake", self.folder)
        self.assertRegex(text, "to a folder: .* cannot be written")
        self.assertIn("partial bake: a bake that the command can resume", text)
        self.assertGreater(self.number("changed", text), 0.1)
        text = self.run_script("pvpython", "baked.py", "load", self.folder)
        self.assertEqual(within(picture(self.folder / "bake.png"), picture(self.folder / "load.png"), 0), 1.0)
        self.assertIn("problem with it: none", text)
        self.check_sentences(text, "does not exist", "holds no baked light", "' is damaged")
        self.assertEqual([float(share) for share in re.findall(r"(?:unlit|again|state) ([\d.]+)", text)], [1.0] * 5)
        self.assertIn("light ", self.messages)  # the change that no longer fits the bake

    def check_sentences(self, text, *sentences):
        for sentence in sentences:
            self.assertRegex(text, f"problem: .*{sentence}")
            self.assertEqual(self.messages.count(sentence), 2, self.messages)  # as a message, and in the property

    @unittest.skipUnless(os.environ.get("PENUMBRA_COMMAND"), "needs the command penumbra, which bakes lightmaps")
    def test_a_lightmap_of_the_command_lights_the_same_files(self):
        text = self.run_script("pvpython", "lightmap.py", self.folder, os.environ["PENUMBRA_COMMAND"])
        self.assertIn("problem with it: none", text)
        self.assertGreater(self.number("changed", text), 0.1)
        self.assertGreaterEqual(within(picture(self.folder / "view.png"), picture(self.folder / "tool.png")), 0.995)
        self.check_sentences(text, "does not exist", "holds no baked light", "' is damaged", "penumbra bake convert")
        self.assertEqual([float(share) for share in re.findall(r"(?:unlit|again) ([\d.]+)", text)], [1.0] * 5)
        self.assertIn("the lightmap no longer fits: 'floor' changed its look since the bake", self.messages)
        self.assertIn("problem with other data: none", text)  # the pass's note reports it


class States(Base):
    def test_state_is_restored_in_a_new_process(self):
        self.run_script("pvpython", "states.py", "save", self.folder)
        saved = picture(self.folder / "save.png")
        for action in ("load", "run"):
            text = self.run_script("pvpython", "states.py", action, self.folder)
            self.assertIn("samples 28 radius 1.25 temporal 0 look studio", text)
            self.assertEqual(within(saved, picture(self.folder / f"{action}.png"), 0), 1.0, action)


class Lights(Base):
    def test_lights_have_shapes_also_in_states(self):
        saved, loaded = self.folder / "saved.png", self.folder / "loaded.png"
        for action, kinds in (("save", ("pvsm", "py")), ("save-older", ("pvsm",))):
            for kind in kinds:
                text = self.run_script("pvpython", "lights.py", action, self.folder / f"lights.{kind}", saved)
                self.assertNotIn("accepted", text)
                self.assertEqual(self.number("removed", text), 1)
                self.assertGreater(self.number("shape changes", text), 0.02)
                self.assertIn(f"the light has properties: {action == 'save'}", text)
                if action == "save":
                    self.assertGreater(self.number("size changes", text), 0.02)
                    self.assertEqual(self.number("size is restored", text), 1)
                self.run_script("pvpython", "lights.py", "load", self.folder / f"lights.{kind}", loaded)
                self.assertEqual(within(picture(saved), picture(loaded), 0), 1.0)


class Server(Base):
    def test_a_server_draws_the_same(self):
        with socket.socket() as probe:
            probe.bind(("localhost", 0))
            port = probe.getsockname()[1]
        with open(self.folder / "server.log", "w+") as log:
            server = subprocess.Popen(
                ["pvserver", "--hostname=localhost", f"--server-port={port}",
                 f"--plugins={PLUGIN}"], env=ENVIRONMENT, stdout=log, stderr=subprocess.STDOUT)
            try:
                self.wait_for_server(server, self.folder / "server.log")
                remote = self.run_script("pvpython", "remote.py", self.folder / "remote.png", port)
                self.assertEqual(server.wait(60), 0)
            finally:
                server.kill()
                server.wait()
        self.assertIn("remote 1", remote)
        self.check_refusal(remote)
        self.assertNotIn("ERR|", (self.folder / "server.log").read_text())
        self.run_script("pvpython", "remote.py", self.folder / "local.png")
        share = within(picture(self.folder / "remote.png"), picture(self.folder / "local.png"))
        print(f"equal {share:.5f}")
        self.assertGreaterEqual(share, 0.995)

    def wait_for_server(self, server, log):
        deadline = time.monotonic() + TIMEOUT
        while time.monotonic() < deadline:
            if "Connection URL" in log.read_text():
                return
            self.assertIsNone(server.poll(), log.read_text())
            time.sleep(0.2)
        self.fail(f"the server did not start: {log.read_text()}")


class Ranks(Base):
    def test_two_ranks(self):
        for count, name in ((1, "one"), (2, "two")):
            program = f"mpirun --oversubscribe -n {count} pvbatch" if count > 1 else "pvbatch"
            text = self.run_script(program, "ranks.py", self.folder / name, 100)
            warnings = self.messages.count("stop at the boundaries")
            self.assertEqual(warnings, 1 if count > 1 else 0, text)
            if count > 1:
                self.check_refusal(text)
        # Direct light does not depend on the other rank. Edges differ, as they are blended before compositing.
        for name, limit in (("plain", 0.995), ("direct", 0.995), ("after", 0.995)):
            share = within(picture(self.folder / f"one_{name}.png"), picture(self.folder / f"two_{name}.png"))
            print(f"{name} {share:.5f}")
            self.assertGreaterEqual(share, limit)


    def test_two_ranks_keep_one_budget(self):
        self.run_script("mpirun --oversubscribe -n 2 pvbatch --sym", "budget_ranks.py", self.folder, 80)
        ranks = [json.loads((self.folder / f"rank{rank}.json").read_text()) for rank in (0, 1)]
        for number, (one, two) in enumerate(zip(*ranks)):
            self.assertEqual((one["state"], two["state"]), ("moving", "moving"))
            self.assertTrue(one["levels"])
            self.assertEqual(one["levels"], two["levels"], f"frame {number}")
        for rank in ranks:  # each has frames that IceT does not let it draw, which the other must not wait for
            pauses = sum(one["milliseconds"] == two["milliseconds"] for one, two in zip(rank, rank[1:]))
            self.assertGreater(pauses, 10)


class Switching(Base):
    def test_switching_frees_all_resources(self):
        text = self.run_script("pvpython", "toggles.py", 200)
        for kind in ("Texture", "Buffer", "Framebuffer", "Program"):
            self.assertLessEqual(self.number(kind, text), 0)
        self.assertLess(self.number("megabytes", text), 4)  # in 50 cycles
        self.assertEqual(self.number("lit_equal", text), 1.0)
        self.assertEqual(self.number("plain_equal", text), 1.0)

    def test_a_view_older_than_the_plugin(self):
        text = self.run_script("pvpython", "older_view.py")
        self.assertIn("has properties: False", text)
        self.assertGreater(self.number("changed", text), 0.1)
        self.assertEqual(self.number("as_a_new_view", text), 1.0)
        self.assertEqual(self.number("off_again", text), 1.0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
