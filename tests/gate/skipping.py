# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cases for test_gate.py: some that are skipped, and one that passes."""
import unittest


class Absent(unittest.TestCase):
    @unittest.skip("not installed: a package")
    def test_one(self):
        pass

    def test_other(self):
        self.skipTest("nothing else")


@unittest.skip("none of this")
class Nothing(unittest.TestCase):
    def test_nothing(self):
        pass


class Present(unittest.TestCase):
    def test_present(self):
        pass
