#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Make random public calls (api_calls.py) for many seeds, each in a separate process.

    tests/fuzz/test_api.py 1 200 --calls 300 --jobs 2

A seed fails if the process crashes or hangs, or if OpenGL or VTK reports an error. The output of failed seeds is written
to the folder --logs.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import time

CALLS = pathlib.Path(__file__).with_name("api_calls.py")


def run(seed, arguments):
    """Run a seed. Returns a description of the failure, or an empty text."""
    command = [sys.executable, str(CALLS), str(seed), str(arguments.calls)] + ["--stock"] * arguments.stock
    try:
        process = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=arguments.patience,
                              text=True, errors="replace", check=False)
        output, status = process.stdout, process.returncode
    except subprocess.TimeoutExpired as error:
        output, status = (error.stdout or b"").decode(errors="replace"), "none: it hung"
    lines = re.findall(r"^.*(?:ERR\||WARN\||GL error|FAILED).*$", output, re.M)
    if status == 0 and not lines and re.search(r"^done,", output, re.M):
        return ""
    log = arguments.logs / f"seed_{seed}.txt"
    log.write_text(output)
    last = lines[0] if lines else (output.strip().splitlines() or ["nothing"])[-1]
    return f"status {status}, {len(lines)} error lines, e.g. {last[:160]!r}; see {log}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--calls", type=int, default=100, help="number of calls per seed (default: 100)")
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time (default: 1)")
    parser.add_argument("--patience", type=float, default=1800.0, help="seconds after which a seed counts as hung (default: 1800)")
    parser.add_argument("--logs", type=pathlib.Path, default=pathlib.Path("out/fuzz"))
    parser.add_argument("--stock", action="store_true", help="never set a pass")
    arguments = parser.parse_args()
    arguments.logs.mkdir(parents=True, exist_ok=True)
    seeds = range(arguments.first, arguments.last + 1)
    started, failed = time.monotonic(), 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        runs = {pool.submit(run, seed, arguments): seed for seed in seeds}
        for done, future in enumerate(concurrent.futures.as_completed(runs), 1):
            if future.result():
                failed += 1
                print(f"seed {runs[future]}: {future.result()}", flush=True)
            if sys.stdout.isatty():
                left = (time.monotonic() - started) / done * (len(seeds) - done)
                print(f"\r{done} of {len(seeds)}, {failed} failed, {left / 60:.0f} min left ", end="", flush=True)
    print(f"{len(seeds)} seeds of {arguments.calls} calls: {failed} failed")
    return 1 if failed or not seeds else 0


if __name__ == "__main__":
    sys.exit(main())
