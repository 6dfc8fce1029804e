#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of `loopmend info` and `loopmend fill` on large scans, beside a plain loop that parses the same file.

Writes the table of docs/benchmarks/large_scans.md to the standard output. The scans are made anew, one after the other, and
removed. Needs the programs loopmend and loopmend_large_scans, and disk space of 40 bytes a triangle.
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time


def measured(command):
    """Seconds, and peak memory in bytes, of a command that must succeed; and what it printed."""
    read, write = os.pipe()
    start = time.monotonic()
    child = os.fork()
    if child == 0:
        os.close(read)
        os.dup2(write, 1)
        os.execvp(command[0], command)
    os.close(write)
    with os.fdopen(read) as output:
        text = output.read()
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)} ended with status {os.waitstatus_to_exitcode(status)}")
    return time.monotonic() - start, usage.ru_maxrss * 1024, text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", required=True, help="folder with loopmend and loopmend_large_scans")
    parser.add_argument("--triangles", type=int, nargs="+", default=[1_000_000, 14_000_000, 100_000_000])
    parser.add_argument("--text", action="store_true", help="PLY as text instead of binary")
    parser.add_argument("--folder", default=tempfile.gettempdir(), help="where the scans are made")
    options = parser.parse_args()
    loopmend, scans = (os.path.join(options.programs, name) for name in ("loopmend", "loopmend_large_scans"))
    print("| triangles | command | seconds | peak memory, MB | bytes a triangle |")
    print("| --- | --- | --- | --- | --- |")
    for asked in options.triangles:
        with tempfile.TemporaryDirectory(dir=options.folder) as folder:
            scan, filled = os.path.join(folder, "scan.ply"), os.path.join(folder, "filled.ply")
            text = ["--text"] if options.text else []
            subprocess.run([scans, "write", scan, str(asked), *text], check=True)
            compared = subprocess.run([scans, "compare", scan], check=True, capture_output=True, text=True).stdout
            triangles = int(compared.split()[0])
            for name, command in (("info", [loopmend, "info", scan]),
                                  ("fill", [loopmend, "fill", scan, "-o", filled, "--quiet"])):
                seconds, memory, _ = measured(command)
                print(f"| {triangles} | `{name}` | {seconds:.1f} | {memory / 1e6:.0f} | {memory / triangles:.0f} |", flush=True)
            print(f"<!-- {compared.strip()} -->", flush=True)


if __name__ == "__main__":
    main()
