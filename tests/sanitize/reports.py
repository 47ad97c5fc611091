# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Print the reports of sanitizers that are not in known.txt.

usage: reports.py FOLDER, with the sanitizers' log files. Exits with 1 if there are such reports.
"""
import collections
import pathlib
import re
import sys

KNOWN = pathlib.Path(__file__).with_name("known.txt")
BEGIN = re.compile(r"^(?:==\d+==\s*ERROR: \w+: (?P<address>[\w-]+)|\S+:\d+:\d+: runtime error: (?P<undefined>.*))", re.M)
LEAK = re.compile(r"^(?:Direct|Indirect) leak of .*", re.M)
MOST_SHOWN = 20
LINES_SHOWN = 40


def known():
    """Rows of known.txt: (kind, name in the stack). Each line of the file must give a reason."""
    rows = []
    for line in KNOWN.read_text().splitlines():
        row, _, reason = line.partition("#")
        if row.strip():
            if not reason.strip():
                raise SystemExit(f"{KNOWN.name}: the reason is missing in: {line}")
            rows.append(tuple(row.split()))
    return rows


def reports(text):
    """(kind, text) of each report in a log. Leaks give one report for each allocating stack."""
    begins = [found.start() for found in BEGIN.finditer(text)] + [len(text)]
    for begin, end in zip(begins, begins[1:]):
        report = text[begin:end]
        kind = BEGIN.match(report)["address"] or "undefined"
        if kind != "detected":
            yield kind, report
            continue
        leaks = [found.start() for found in LEAK.finditer(report)] + [len(report)]
        for first, last in zip(leaks, leaks[1:]):
            yield "leak", report[first:last]


def main():
    folder = pathlib.Path(sys.argv[1])
    rows, unknown, skipped = known(), [], collections.Counter()
    for path in sorted(folder.glob("*")):
        text = path.read_text(errors="replace")
        found = list(reports(text))
        if text.strip() and not found:
            found = [("other", text)]
        for kind, report in found:
            row = next((row for row in rows if row[0] == kind and row[1] in report), None)
            if row:
                skipped[row] += 1
            else:
                unknown.append(report)
    for (kind, name), count in sorted(skipped.items()):
        print(f"known: {count} of {kind} in {name}")
    counts = collections.Counter(re.sub(r"==\d+==|0x[0-9a-f]+", "", report) for report in unknown)
    for report, count in counts.most_common(MOST_SHOWN):
        print(f"---- {count} times")
        print("\n".join(report.splitlines()[:LINES_SHOWN]))
    print(f"{len(unknown)} reports")
    return 1 if unknown else 0


if __name__ == "__main__":
    sys.exit(main())
