#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Copy the Python interpreter, the modules that the benchmarks of tests/bench import, their sources, and the data of the demo's
scenes as far as it is installed, to a folder. Prints the compiled modules, whose libraries the caller gathers.

Usage: gather_python.py SOURCE DESTINATION, with the package penumbra on PYTHONPATH.
"""
import importlib
import os
import pathlib
import shutil
import sys
import sysconfig

WHOLE = ("numpy", "PIL", "penumbra")  # import parts of themselves only when they are needed
LEFT_OUT = ("test", "tests", "idlelib", "tkinter", "lib2to3", "ensurepip", "turtledemo", "pydoc_data", "distutils", "dist-packages",
            "site-packages", "f2py", "config-*", "__pycache__", "*.a", "*.pyc", "*.exe", "_test*.so", "_tkinter*", "_imagingtk*")


def copy_tree(source, destination):
    shutil.copytree(source, destination, ignore=shutil.ignore_patterns(*LEFT_OUT), dirs_exist_ok=True)


def imported(source):
    """Names and files of all modules that are loaded after the import of every benchmark."""
    benches = source / "tests" / "bench"
    sys.path.insert(0, str(benches))
    for bench in sorted(benches.glob("*.py")):
        importlib.import_module(bench.stem)
    return {name: pathlib.Path(module.__file__) for name, module in sorted(sys.modules.items()) if getattr(module, "__file__", None)}


def copy_scene_data(destination):
    """Copy the files of examples/scenes.py, under the paths that they have here."""
    scenes = sys.modules["scenes"]
    for file in (*(scenes.MRICRON + name for name in scenes.VOLUMES), scenes.PROTEIN, scenes.ELEVATION):
        if os.path.exists(file):
            place = destination / os.path.relpath(file, "/")
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, place)


def main():
    source, destination = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    for folder in ("tests/bench", "examples", "tool/denoiser"):
        copy_tree(source / folder, destination / "source" / folder)
    standard = pathlib.Path(sysconfig.get_path("stdlib"))
    library = destination / "python" / "lib" / standard.name
    copy_tree(standard, library)
    packages = library / "site-packages"
    for name, file in imported(source).items():
        package = name.partition(".")[0]
        if package in WHOLE:
            if name == package:
                copy_tree(file.parent, packages / package)
        elif "dist-packages" in file.parts or "site-packages" in file.parts:
            place = packages.joinpath(*name.split("."))
            place = (place if file.name == "__init__.py" else place.parent) / file.name
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, place)
    copy_scene_data(destination / "data" / "scenes")
    interpreter = destination / "python" / "bin" / "python3"
    interpreter.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(os.path.realpath(sys.executable), interpreter)
    print(";".join(str(file) for file in [interpreter, *library.rglob("*.so")]), end="")


if __name__ == "__main__":
    main()
