# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the penumbra command and judges how it ends."""
import json
import os
import pathlib
import random
import signal
import subprocess
import tempfile
import time
import unittest

COMMAND = os.environ.get("PENUMBRA_COMMAND", "penumbra")
LONGEST = 3600  # seconds after which a command is taken for stuck
DEFAULT_LOOK = "note: the look 'studio' lights the scene"  # said wherever no look is asked for
TINY = ("--size", "32x24", "--frames", "1")


def box(**more):
    return {"size": [32, 24], "frames": 1, "objects": [{"box": {}}], **more}


class CommandTest(unittest.TestCase):
    """A folder of its own for every class, and the command to run in it."""

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name)

    def scene(self, described, name="scene.json"):
        path = self.folder / name
        path.write_text(json.dumps(described))
        return path

    def penumbra(self, *arguments, env=None):
        """In that folder; a variable of the environment that is None is unset."""
        changed = {**os.environ, **(env or {})}
        return subprocess.run(
            [COMMAND, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
            errors="replace", timeout=LONGEST, stdin=subprocess.DEVNULL,
            env={key: value for key, value in changed.items() if value is not None})

    def needs(self, backend):
        """Skips the test where there is no such backend: Mesa after 25.0 has no OSMesa."""
        ended = self.penumbra("info", "--backend", backend)
        if ended.returncode != 0 and "could not be loaded" in ended.stderr:
            self.skipTest(ended.stderr.strip())

    def succeeds(self, *arguments, notes=(), env=None):
        """Ends with 0 and says nothing but notes with these words, one each."""
        ended = self.penumbra(*arguments, env=env)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        lines = [line for line in ended.stderr.splitlines() if DEFAULT_LOOK not in line]
        self.assertEqual(len(lines), len(notes), ended.stderr)
        for line, words in zip(lines, notes):
            self.assertTrue(line.startswith("penumbra: note: "), line)
            self.assertIn(words, line)
        return ended

    def report(self, *arguments, notes=()):
        """The JSON that it prints as it ends well."""
        return json.loads(self.succeeds(*arguments, notes=notes).stdout)

    def compare(self, one, other, *limits):
        return self.report("compare", one, other, "--json", *limits)

    def refused(self, *arguments, says, status=None, env=None):
        """Ends with one sentence that has these words, no signal, and a status other than 0."""
        ended = self.penumbra(*arguments, env=env)
        self.assert_sentence(ended, says)
        if status is not None:
            self.assertEqual(ended.returncode, status, ended.stderr)
        return ended

    def killed(self, *arguments, when):
        """Killed as soon as when() is true, with all that it started; whether it had not ended by itself before."""
        process = subprocess.Popen([COMMAND, *map(str, arguments)], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True)
        until = time.monotonic() + LONGEST
        while not when() and process.poll() is None and time.monotonic() < until:
            time.sleep(0.01)
        running = process.poll() is None
        if running:
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return running

    def killed_at_work(self, *arguments, when, output, attempts=5):
        """Killed while it works and when() is true; started again where a busy machine let it end before."""
        for _ in range(attempts):
            (self.folder / output).unlink(missing_ok=True)
            if self.killed(*arguments, when=when):
                return
        self.fail(f"ended by itself {attempts} times before it could be killed")

    def killed_at_any_moment(self, *arguments, seconds, output, kills=5):
        """Started and killed again and again, at moments by chance of a run that takes so long; then it ends well."""
        (self.folder / output).unlink(missing_ok=True)
        moments = []
        for i in range(kills):
            moment = seconds * (i + random.random()) / kills
            start = time.monotonic()
            if self.killed(*arguments, when=lambda: time.monotonic() - start > moment):
                moments.append(f"{moment:.2f}")
        print(f"\n{output}: killed after {', '.join(moments)} of {seconds:.2f} s")
        self.succeeds(*arguments)
        left = [path.name for path in self.folder.glob(output + "?*")]
        self.assertEqual(left, [], "files of bakes that were killed")

    def assert_sentence(self, ended, says):
        self.assertIn(ended.returncode, (1, 2), ended.stderr)
        lines = ended.stderr.splitlines()
        sentences = [line for line in lines if not line.startswith("penumbra: note: ")]
        self.assertEqual(len(sentences), 1, ended.stderr)
        self.assertEqual(sentences[0], lines[-1], "notes come before")
        self.assertTrue(sentences[0].startswith("penumbra: "), ended.stderr)
        self.assertIn(says, sentences[0])
        for raw in ("ERR|", "WARN|", "Warning:", "ERROR:"):
            self.assertNotIn(raw, ended.stdout + ended.stderr)


class LightmapTest(CommandTest):
    def bake(self, scene, *arguments, notes=(), output="map.vti"):
        return self.report("bake", "lightmap", scene, "-o", output, "--stats", *arguments, notes=notes)

    def compare_maps(self, one, other):
        """As penumbra compare does, of the light that two lightmaps hold."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLImageDataReader

        def light(name):
            reader = vtkXMLImageDataReader()
            reader.SetFileName(str(self.folder / name))
            reader.Update()
            return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)
        ours, truth = light(one), light(other)
        self.assertEqual(ours.shape, truth.shape)
        return {"maximum": float(abs(ours - truth).max()),
                "relmse": float(((ours - truth) ** 2 / (truth ** 2 + 0.01)).mean())}
