#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Interrupts `loopmend fill` at random moments, and counts what became of its files and exit codes.

  interruptions.py PROGRAM [--times 200] [--seed 1] [--kinds SIGINT ...] [--folder FOLDER]

Each fill replaces a file. Afterwards that file must be the old one or the new one, in every byte; no temporary file may be left
(after SIGKILL: none after the next fill); and the exit code must fit. Kinds:

  SIGHUP SIGINT SIGTERM SIGXCPU   the signal, within the time that a fill takes and a little longer: 128 + its number with the old
                                  or the new file, 0 with the new one; killed by it before main() began, with the old file
  SIGKILL                         the same: killed, or 0 with the new file
  SIGPIPE SIGXFSZ                 the signal, which does nothing: 0 with the new file
  reader gone                     who reads the report at the standard output closes it: 0 or 141, with the new file
  size limit                      ulimit -f of random size: 4 with the old file, 0 with the new one

Prints a table. Exit code: 0 where all held, 1 otherwise (with what did not).
"""
import argparse
import collections
import math
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

ENDING = ["SIGHUP", "SIGINT", "SIGTERM", "SIGXCPU"]
SIGNALS = ENDING + ["SIGKILL", "SIGPIPE", "SIGXFSZ"]
KINDS = SIGNALS + ["reader gone", "size limit"]
OLD = b"the old file\n" * 1000


def write_scan(path, rings=60, sectors=80):
    """A bumpy sphere without its poles: two holes, some 10 000 triangles, as text."""
    points, faces = [], []
    for r in range(rings):
        for s in range(sectors):
            polar, angle = math.radians(14 + 152 * r / (rings - 1)), 2 * math.pi * s / sectors
            radius = 1 + 0.05 * math.sin(3 * angle) * math.sin(polar) ** 3
            points.append((radius * math.sin(polar) * math.cos(angle), radius * math.sin(polar) * math.sin(angle),
                           radius * math.cos(polar)))
            if r + 1 < rings:
                a, b = r * sectors + s, r * sectors + (s + 1) % sectors
                faces += [(a, a + sectors, b + sectors), (a, b + sectors, b)]
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += ["%.17g %.17g %.17g" % p for p in points] + ["3 %d %d %d" % f for f in faces]
    path.write_text("\n".join(lines) + "\n")


class Bench:
    def __init__(self, program, folder, seed):
        self.folder, self.random = folder, random.Random(seed)
        self.out = folder / "out.ply"
        write_scan(folder / "scan.off")
        self.command = [program, "fill", str(folder / "scan.off"), "-o", str(self.out), "--ascii"]
        start = time.monotonic()
        subprocess.run(self.command, check=True, capture_output=True, timeout=600)
        self.seconds = time.monotonic() - start
        self.new = self.out.read_bytes()
        self.faults = []

    def leftovers(self):
        return sorted(p.name for p in self.folder.iterdir() if p.name.startswith(".loopmend-"))

    def start(self, limit=None, report=False):
        self.out.write_bytes(OLD)

        def prepare():
            for name in ENDING + ["SIGPIPE", "SIGXFSZ"]:
                signal.signal(getattr(signal, name), signal.SIG_DFL)
            if limit is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        return subprocess.Popen(self.command + (["--report", "-"] if report else []), preexec_fn=prepare,
                                stdout=subprocess.PIPE if report else subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def once(self, kind):
        """Returns exit code and "old" or "new"; notes what should not be."""
        if kind == "size limit":
            limit = self.random.randrange(0, int(1.2 * len(self.new)))
            child = self.start(limit=limit)
        elif kind == "reader gone":
            child = self.start(report=True)
            child.stdout.read(self.random.choice([0, 1, 100, 3000]))
            child.stdout.close()
        else:
            child = self.start()
            time.sleep(self.random.uniform(0, 1.1 * self.seconds))
            child.send_signal(getattr(signal, kind))
        code = child.wait(timeout=600)
        content = self.out.read_bytes()
        state = {OLD: "old", self.new: "new"}.get(content, "damaged")
        left = self.leftovers()
        if kind in ENDING:
            wanted = {128 + getattr(signal, kind): {"old", "new"}, 0: {"new"}}
        elif kind == "size limit":
            wanted = {4: {"old"}, 0: {"new"}}
        elif kind == "reader gone":
            wanted = {0: {"new"}, 141: {"new"}}
        else:
            wanted = {0: {"new"}}
        if kind == "SIGKILL":
            wanted[-signal.SIGKILL] = {"old", "new"}
        elif kind in SIGNALS:
            wanted[-getattr(signal, kind)] = {"old"}  # before main() began, by the system
        if state not in wanted.get(code, set()):
            self.faults.append(f"{kind}: exit code {code} with the {state} file")
        if left and kind != "SIGKILL":
            self.faults.append(f"{kind}: left {left}")
        return code, state, len(left)

    def run(self, kind, times):
        seen, left = collections.Counter(), 0
        for _ in range(times):
            code, state, remaining = self.once(kind)
            seen[code, state] += 1
            left += remaining
        if kind == "SIGKILL":
            subprocess.run(self.command, check=True, capture_output=True, timeout=600)
            if self.leftovers():
                self.faults.append(f"SIGKILL: left {self.leftovers()} after the next fill")
        return seen, left


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--times", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=KINDS)
    parser.add_argument("--folder", type=pathlib.Path, help="where the files are made, on the file system to be tried")
    arguments = parser.parse_args()
    os.environ["LC_ALL"] = "C"
    with tempfile.TemporaryDirectory(dir=arguments.folder) as folder:
        bench = Bench(str(pathlib.Path(arguments.program).resolve()), pathlib.Path(folder), arguments.seed)
        print(f"One fill takes {bench.seconds:.2f} s and writes {len(bench.new)} bytes.\n")
        print("| kind | times | old file | new file | exit codes |\n| --- | ---: | ---: | ---: | --- |")
        for kind in arguments.kinds:
            seen, left = bench.run(kind, arguments.times)
            by_state, by_code = collections.Counter(), collections.Counter()
            for (code, state), count in seen.items():
                by_state[state] += count
                by_code[code] += count
            codes = ", ".join(f"{code}: {count}" for code, count in sorted(by_code.items()))
            if left:
                codes += f"; {left} temporary files, removed by the next fill"
            print(f"| {kind} | {arguments.times} | {by_state['old']} | {by_state['new']} | {codes} |", flush=True)
        for fault in bench.faults:
            print(fault, file=sys.stderr)
        print(f"\n{len(bench.faults)} faults.")
        return int(bool(bench.faults))


if __name__ == "__main__":
    sys.exit(main())
