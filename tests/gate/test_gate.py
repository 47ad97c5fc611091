# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""./run test reports skipped cases, even those of programs whose other cases passed.

environment: PENUMBRA_BUILD, the build folder; PENUMBRA_SKIPPING, the program built from Skipping.cxx.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
RUN_CASES = HERE.parent / "support" / "run_cases.py"
SKIPPING = os.environ["PENUMBRA_SKIPPING"]
SKIP_CODE = 77


class Counting(unittest.TestCase):
    def run_tests(self, **tests):
        """Run tests, each given as the words of a command, with ./run's own function. Returns its status and output lines."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "build").mkdir()
            commands = []
            for test, words in tests.items():
                quoted = " ".join(f'"{word}"' for word in words)
                commands += [f"add_test({test} {quoted})",
                             f"set_tests_properties({test} PROPERTIES SKIP_RETURN_CODE {SKIP_CODE})"]
            (folder / "build" / "CTestTestfile.cmake").write_text("\n".join(commands))
            functions = (ROOT / "run").read_text().partition("-- commands\n")[0]
            (folder / "functions").write_text(functions)
            process = subprocess.run(["bash", "-c", "source ./functions && run_tests"], cwd=folder, capture_output=True,
                                   text=True, env={**os.environ, "PENUMBRA_BUILD_DIR": "build"})
            return process.returncode, process.stdout.splitlines()

    def program(self, pattern):
        return [SKIPPING, f"--gtest_filter={pattern}"]

    def cases(self, *names):
        return [sys.executable, "-B", str(RUN_CASES), str(HERE / "skipping.py"), *names]

    def test_a_program_with_only_skipped_cases(self):
        status, lines = self.run_tests(fine=self.program("Present.Talkative"), gone=self.program("Absent.*"))
        self.assertEqual(status, 0, lines)
        self.assertEqual(lines[-3:], ["skipped: gone: Absent.One: nothing of this kind here",
                                     "skipped: gone: Absent.Other: nothing else", "1 passed, 0 failed, 2 skipped"])

    def test_a_program_with_a_skipped_case_among_others(self):
        status, lines = self.run_tests(mixed=self.program("Absent.One:Present.Talkative"))
        self.assertEqual(status, 0, lines)
        self.assertEqual(lines[-2:], ["skipped: mixed: Absent.One: nothing of this kind here", "1 passed, 0 failed, 1 skipped"])

    def test_a_program_with_a_skipped_case_and_a_failed_one(self):
        status, lines = self.run_tests(mixed=self.program("Absent.One:Present.*"))
        self.assertNotEqual(status, 0)
        self.assertEqual(lines[-1], "0 passed, 1 failed, 1 skipped")

    def test_scripts(self):
        status, lines = self.run_tests(some=self.cases("Absent", "Present"), none=self.cases("-v", "Absent"),
                                    nothing=self.cases("Nothing"), fine=self.cases("Present"))
        self.assertEqual(status, 0, lines)
        self.assertEqual(lines[-1], "2 passed, 0 failed, 5 skipped")
        listed = sorted(line for line in lines if line.startswith("skipped: "))
        self.assertEqual(listed, [
            "skipped: none: skipping.Absent.test_one: not installed: a package",
            "skipped: none: skipping.Absent.test_other: nothing else",
            "skipped: nothing: skipping.Nothing.test_nothing: none of this",
            "skipped: some: skipping.Absent.test_one: not installed: a package",
            "skipped: some: skipping.Absent.test_other: nothing else"])

    def test_a_test_that_names_no_cases(self):
        status, lines = self.run_tests(fine=["true"], gone=["bash", "-c", f"exit {SKIP_CODE}"])
        self.assertEqual((status, lines[-2:]), (0, ["skipped: gone: all of it", "1 passed, 0 failed, 1 skipped"]))

    def test_nothing_skipped(self):
        self.assertEqual(self.run_tests(fine=["true"])[1][-1], "1 passed, 0 failed")


class Registered(unittest.TestCase):
    """Each test of the build declares the status by which it reports that it skipped everything."""

    def test_every_test_declares_the_status(self):
        listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=os.environ["PENUMBRA_BUILD"], capture_output=True,
                                text=True, check=True)
        tests = json.loads(listed.stdout)["tests"]
        self.assertGreater(len(tests), 10)
        for test in tests:
            words = [pathlib.Path(word).name for word in test.get("command", [])]
            program = bool(words) and words[0].startswith("penumbra_") and words[0].endswith("_tests")
            script = any(word.startswith("test_") and word.endswith(".py") for word in words)
            if not program and not script:
                continue
            with self.subTest(test["name"]):
                if script and "if __name__" in self.text_of(test) and "unittest.main" in self.text_of(test):
                    self.assertIn("run_cases.py", words)
                if program or "run_cases.py" in words:
                    codes = [entry["value"] for entry in test["properties"] if entry["name"] == "SKIP_RETURN_CODE"]
                    self.assertEqual([int(code) for code in codes], [SKIP_CODE])

    def text_of(self, test):
        return next(pathlib.Path(word).read_text() for word in test["command"]
                    if pathlib.Path(word).name.startswith("test_") and word.endswith(".py"))


if __name__ == "__main__":
    unittest.main()
