#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time and memory of `loopmend info` and `loopmend fill` on large scans, beside a plain loop that parses the same file.

Writes the tables of docs/benchmarks/large_scans.md to the standard output. The scans are made and removed one after the other.
Needs the programs loopmend and loopmend_large_scans, and disk space of 40 bytes a triangle.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile


def measured(command):
    """Processor seconds, and peak memory in bytes, of a command that must succeed."""
    child = os.posix_spawnp(command[0], command, os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)])
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)} ended with status {os.waitstatus_to_exitcode(status)}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def seconds_beside_loop(scans, scan):
    """Triangles; processor seconds of the plain loop and of Loopmend's reader."""
    text = subprocess.run([scans, "compare", scan], check=True, capture_output=True, text=True).stdout
    found = re.match(r"(\d+) triangles.*of a processor ([\d.]+) s.*all [\d.]+ s \(([\d.]+) s\)", text)
    return int(found[1]), float(found[2]), float(found[3])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", required=True, help="folder with loopmend and loopmend_large_scans")
    parser.add_argument("--scans", nargs="+", default=["1000000", "14000000", "14000000t", "100000000"],
                        help="triangles of each; with a t behind it, PLY as text instead of binary")
    parser.add_argument("--folder", default=tempfile.gettempdir(), help="where the scans are made")
    options = parser.parse_args()
    loopmend, scans = (os.path.join(options.programs, name) for name in ("loopmend", "loopmend_large_scans"))
    beside = []
    print("| triangles | command | processor, s | peak memory, MB | bytes a triangle |")
    print("| --- | --- | ---: | ---: | ---: |")
    for asked in options.scans:
        with tempfile.TemporaryDirectory(dir=options.folder) as folder:
            scan, filled = os.path.join(folder, "scan.ply"), os.path.join(folder, "filled.ply")
            form = ["--text"] if asked.endswith("t") else []
            subprocess.run([scans, "write", scan, asked.rstrip("t"), *form], check=True)
            triangles, plain, ours = seconds_beside_loop(scans, scan)
            name = f"{triangles:,}".replace(",", " ") + (", as text" if form else "")
            beside.append(f"| {name} | {plain:.2f} | {ours:.2f} | {ours / plain:.1f} |")
            for task, command in (("info", [loopmend, "info", scan]), ("fill", [loopmend, "fill", scan, "-o", filled, "--quiet"])):
                seconds, memory = measured(command)
                print(f"| {name} | `{task}` | {seconds:.1f} | {memory / 1e6:.0f} | {memory / triangles:.0f} |", flush=True)
    print("\n| triangles | plain loop, s | Loopmend, s | times |\n| --- | ---: | ---: | ---: |")
    print("\n".join(beside))


if __name__ == "__main__":
    main()
