#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random public calls (api_calls.py) for many seeds, each in a process of its own.

    tests/fuzz/test_api.py 1 200 --calls 300 --jobs 2

A seed fails where the process crashes or hangs, where OpenGL or VTK reports an error, and where it does not end. The
output of failed seeds is kept in the folder of --logs.
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
    """What was wrong with a seed, or an empty text."""
    command = [sys.executable, str(CALLS), str(seed), str(arguments.calls)] + ["--stock"] * arguments.stock
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=arguments.patience,
                              text=True, errors="replace", check=False)
        output, status = done.stdout, done.returncode
    except subprocess.TimeoutExpired as slow:
        output, status = (slow.stdout or b"").decode(errors="replace"), "none: it hangs"
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
    parser.add_argument("--calls", type=int, default=100, help="of each seed (default: 100)")
    parser.add_argument("--jobs", type=int, default=1, help="processes at a time (default: 1)")
    parser.add_argument("--patience", type=float, default=1800.0, help="seconds until a seed hangs (default: 1800)")
    parser.add_argument("--logs", type=pathlib.Path, default=pathlib.Path("out/fuzz"))
    parser.add_argument("--stock", action="store_true", help="never set a pass")
    arguments = parser.parse_args()
    arguments.logs.mkdir(parents=True, exist_ok=True)
    seeds = range(arguments.first, arguments.last + 1)
    started, bad = time.monotonic(), 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = {pool.submit(run, seed, arguments): seed for seed in seeds}
        for done, future in enumerate(concurrent.futures.as_completed(work), 1):
            if future.result():
                bad += 1
                print(f"seed {work[future]}: {future.result()}", flush=True)
            if sys.stdout.isatty():
                left = (time.monotonic() - started) / done * (len(seeds) - done)
                print(f"\r{done} of {len(seeds)}, {bad} bad, {left / 60:.0f} min left ", end="", flush=True)
    print(f"{len(seeds)} seeds of {arguments.calls} calls: {bad} bad")
    return 1 if bad or not seeds else 0


if __name__ == "__main__":
    sys.exit(main())
