# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the benchmarks, and the arguments that choose among them."""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples"))

import scenes  # noqa: E402
from isosurface_ddgi import Room  # noqa: E402

DEMO = list(scenes.SCENES)
SCENES = {name: function for name, (_, function) in scenes.SCENES.items()}
SCENES["isosurface"] = lambda: Room().renderer


class Parser(argparse.ArgumentParser):
    """A command line with scenes, the size of pictures and parameters."""

    def __init__(self, description, size, chosen=tuple(SCENES), parameter="TECHNIQUE.PARAMETER=VALUE"):
        super().__init__(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
        self.add_argument("scenes", nargs="*", metavar="SCENE", default=list(chosen), help="any of " + ", ".join(SCENES))
        self.add_argument("--size", default=size, type=_size, metavar="WxH", help=f"size of the pictures (default {size})")
        self.add_argument("--set", action="append", default=[], type=_setting, metavar=parameter, help="a parameter")

    def parse(self):
        """The arguments; `set` is a dictionary. Ends the program with a sentence at a mistake."""
        args = self.parse_args()
        for name in args.scenes:
            if name not in SCENES:
                self.error(f"there is no scene '{name}': choose from {', '.join(SCENES)}")
        args.set = dict(args.set)
        return args


def _size(text):
    width, _, height = text.partition("x")
    if not (width.isdigit() and height.isdigit() and int(width) > 0 and int(height) > 0):
        raise argparse.ArgumentTypeError(f"'{text}' is no size such as 320x180")
    return int(width), int(height)


def _setting(text):
    name, equals, value = text.partition("=")
    if not (name and equals):
        raise argparse.ArgumentTypeError(f"'{text}' must be NAME=VALUE")
    return name, value
