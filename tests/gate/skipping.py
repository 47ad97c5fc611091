# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What test_gate.py has ctest run: cases that are skipped, and one that is not."""
import unittest


class Absent(unittest.TestCase):
    @unittest.skip("not installed: a thing")
    def test_one(self):
        pass

    def test_other(self):
        self.skipTest("no other thing")


@unittest.skip("none of this")
class Nothing(unittest.TestCase):
    def test_nothing(self):
        pass


class Present(unittest.TestCase):
    def test_present(self):
        pass
