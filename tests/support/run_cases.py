# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a file of unittest cases and says which it skipped.

usage: run_cases.py FILE [ARGUMENT...], the arguments of unittest. A line "Skipped: NAME: REASON" tells of each case that
was skipped, for ./run test to list and count; status 77 that there were no others.
"""
import importlib
import pathlib
import sys
import unittest

ALL_SKIPPED = 77  # as in Skips.h


def main():
    path = pathlib.Path(sys.argv[1]).resolve()
    sys.path[0] = str(path.parent)
    result = unittest.main(importlib.import_module(path.stem), argv=sys.argv[1:], exit=False).result
    sys.stderr.flush()
    for case, reason in result.skipped:
        print(f"Skipped: {case.id()}: {' '.join(reason.split())}")
    if not result.wasSuccessful():
        return 1
    # A class that is skipped as a whole counts no run.
    return ALL_SKIPPED if result.skipped and result.testsRun <= len(result.skipped) else 0


if __name__ == "__main__":
    sys.exit(main())
