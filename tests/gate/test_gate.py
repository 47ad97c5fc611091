# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""./run test counts what was skipped as skipped, in programs too that passed otherwise.

environment: PENUMBRA_BUILD, the build folder; PENUMBRA_SKIPPING, the program of Skipping.cxx.
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
    def counted(self, **tests):
        """What ./run test's own function makes of tests, each a command's words: its status and the lines it prints."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "build").mkdir()
            lines = []
            for test, words in tests.items():
                quoted = " ".join(f'"{word}"' for word in words)
                lines += [f"add_test({test} {quoted})",
                          f"set_tests_properties({test} PROPERTIES SKIP_RETURN_CODE {SKIP_CODE})"]
            (folder / "build" / "CTestTestfile.cmake").write_text("\n".join(lines))
            functions = (ROOT / "run").read_text().partition("-- commands\n")[0]
            (folder / "functions").write_text(functions)
            ended = subprocess.run(["bash", "-c", "source ./functions && run_tests"], cwd=folder, capture_output=True,
                                   text=True, env={**os.environ, "PENUMBRA_BUILD_DIR": "build"})
            return ended.returncode, ended.stdout.splitlines()

    def program(self, chosen):
        return [SKIPPING, f"--gtest_filter={chosen}"]

    def cases(self, *chosen):
        return [sys.executable, "-B", str(RUN_CASES), str(HERE / "skipping.py"), *chosen]

    def test_a_program_with_skipped_cases_alone(self):
        status, said = self.counted(fine=self.program("Present.Talkative"), gone=self.program("Absent.*"))
        self.assertEqual(status, 0, said)
        self.assertEqual(said[-3:], ["skipped: gone: Absent.One: no thing of this kind here",
                                     "skipped: gone: Absent.Other: no other thing", "1 passed, 0 failed, 2 skipped"])

    def test_a_program_with_a_skipped_case_among_others(self):
        status, said = self.counted(mixed=self.program("Absent.One:Present.Talkative"))
        self.assertEqual(status, 0, said)
        self.assertEqual(said[-2:], ["skipped: mixed: Absent.One: no thing of this kind here", "1 passed, 0 failed, 1 skipped"])

    def test_a_program_with_a_skipped_case_and_a_failed_one(self):
        status, said = self.counted(mixed=self.program("Absent.One:Present.*"))
        self.assertNotEqual(status, 0)
        self.assertEqual(said[-1], "0 passed, 1 failed, 1 skipped")

    def test_scripts(self):
        status, said = self.counted(some=self.cases("Absent", "Present"), none=self.cases("-v", "Absent"),
                                    nothing=self.cases("Nothing"), fine=self.cases("Present"))
        self.assertEqual(status, 0, said)
        self.assertEqual(said[-1], "2 passed, 0 failed, 5 skipped")
        listed = sorted(line for line in said if line.startswith("skipped: "))
        self.assertEqual(listed, [
            "skipped: none: skipping.Absent.test_one: not installed: a thing",
            "skipped: none: skipping.Absent.test_other: no other thing",
            "skipped: nothing: skipping.Nothing.test_nothing: none of this",
            "skipped: some: skipping.Absent.test_one: not installed: a thing",
            "skipped: some: skipping.Absent.test_other: no other thing"])

    def test_a_test_that_names_no_cases(self):
        status, said = self.counted(fine=["true"], gone=["bash", "-c", f"exit {SKIP_CODE}"])
        self.assertEqual((status, said[-2:]), (0, ["skipped: gone: all of it", "1 passed, 0 failed, 1 skipped"]))

    def test_nothing_skipped(self):
        self.assertEqual(self.counted(fine=["true"])[1][-1], "1 passed, 0 failed")


class Registered(unittest.TestCase):
    """Each test of the build can tell ctest that it skipped everything."""

    def test_every_test_knows_the_status(self):
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
