# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run a file of unittest cases and list the skipped ones.

usage: run_cases.py FILE [ARGUMENT...], with unittest's arguments. Prints a line "Skipped: NAME: REASON" for each skipped
case, which ./run test lists and counts. Exits with 77 if all cases were skipped.
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
    # The cases of a class that is skipped as a whole are not counted as run.
    return ALL_SKIPPED if result.skipped and result.testsRun <= len(result.skipped) else 0


if __name__ == "__main__":
    sys.exit(main())
