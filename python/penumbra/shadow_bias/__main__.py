# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m penumbra.shadow_bias SCENE.py -o FOLDER: shadow maps with more and more bias, beside the true shadow."""
import argparse
import importlib.util
import json
import pathlib
import sys

import numpy as np

from .. import images, vtkRenderingGI
from .bench import Bench
from .study import bias_kinds, notes, study, summary

MOST_STEPS = 1000


def load_scene(name):
    """The renderer that FILE.py:FUNCTION gives, "scene" where no function is named."""
    path, _, function = name.partition(":")
    path = pathlib.Path(path)
    if not path.is_file():
        raise ValueError(f"there is no file '{path}': name a Python file with a function that gives a vtkRenderer")
    sys.path.insert(0, str(path.parent))
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None:
        raise ValueError(f"'{path}' is no Python file: its name must end in .py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    if not hasattr(module, function or "scene"):
        raise ValueError(f"'{path}' has no function '{function or 'scene'}': name another as {path}:FUNCTION")
    return getattr(module, function or "scene")()


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="penumbra.shadow_bias", description=__doc__.split(": ")[1], allow_abbrev=False)
    maps = vtkRenderingGI.vtkGIShadowMaps()  # for what it declares
    ranges = {maps.GetParameterName(i): (maps.GetParameterMinimum(i), maps.GetParameterMaximum(i))
              for i in range(maps.GetNumberOfParameters())}
    kinds = bias_kinds(maps)
    parser.add_argument("scene", metavar="SCENE.py[:FUNCTION]", help="gives a vtkRenderer; function scene by default")
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path, help="folder for pictures and numbers")
    parser.add_argument("--bias", choices=[*kinds, "all"], default="all", help="one kind, or all, each alone")
    parser.add_argument("--from", dest="low", type=float, default=0.0, help="smallest bias, texels [%(default)s]")
    parser.add_argument("--to", dest="high", type=float, default=4.0, help="greatest bias, texels [%(default)s]")
    parser.add_argument("--steps", type=int, default=17, help="biases to try [%(default)s]")
    parser.add_argument("--resolution", type=int, help="texels a side of the map [such that they are seen]")
    parser.add_argument("--size", default="640x400", metavar="WxH", help="of the picture [%(default)s]")
    parser.add_argument("--set", action="append", default=[], metavar="TECHNIQUE.PARAMETER=VALUE")
    parser.add_argument("--stats", action="store_true", help="print the numbers as JSON instead of the summary")
    options = parser.parse_args(arguments)
    options.kinds = kinds if options.bias == "all" else [options.bias]
    for kind in options.kinds:
        least, most = ranges[kind + "-bias"]
        if not least <= options.low < options.high <= most:
            parser.error(f"the bias cannot be swept from {options.low:g} to {options.high:g} texels: --from must be less "
                         f"than --to, and both from {least:g} to {most:g}")
    if not 2 <= options.steps <= MOST_STEPS:
        parser.error(f"--steps is {options.steps}: it must be from 2 to {MOST_STEPS}")
    least, most = ranges["resolution"]
    if options.resolution is not None and not least <= options.resolution <= most:
        parser.error(f"--resolution is {options.resolution}: it must be from {least:g} to {most:g}")
    try:
        options.size = tuple(int(side) for side in options.size.split("x"))
        width, height = options.size
        if not (0 < width <= 16384 and 0 < height <= 16384):
            raise ValueError
    except ValueError:
        parser.error("--size must be WIDTHxHEIGHT, such as 640x400")
    options.parameters = dict(pair.partition("=")[::2] for pair in options.set)
    return parser, options


def run(options):
    renderer = load_scene(options.scene)
    try:
        options.output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(f"the folder '{options.output}' cannot be made: {error.strerror}") from None
    window = images.window(renderer, size=options.size, multisamples=0)
    window.Render()
    bench = Bench(window, renderer, **options.parameters)
    biases = [float(bias) for bias in np.linspace(options.low, options.high, options.steps)]
    numbers, pictures = study(bench, biases, options.kinds, options.resolution)
    numbers = {"input": options.scene, "size": list(options.size), **numbers}
    for note in notes(bench, numbers):
        print("note:", note, file=sys.stderr)
    from . import figures  # Matplotlib is slow to load
    figures.write(options.output, numbers, pictures)
    (options.output / "numbers.json").write_text(json.dumps(numbers, indent=2) + "\n", encoding="utf-8")
    print(json.dumps(numbers, indent=2) if options.stats else summary(numbers))


def main(arguments=None):
    parser, options = parse(arguments)
    try:
        run(options)
    except (ValueError, RuntimeError, OSError, ImportError) as error:
        parser.exit(1, f"{parser.prog}: {error}\n")


if __name__ == "__main__":
    main()
