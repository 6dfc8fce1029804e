#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures one page of docs/benchmarks again: runs the programs below and puts what they write between the page's marks.

Usage: measure.py PAGE             needs the programs in build/release; `packaging/bootstrap measure PAGE` builds them first
       measure.py --targets PAGE   prints what has to be built

Scans come from LOOPMEND_SHARED_DIR, ../shared by default. MeshLib must be in the Python that runs this (real_scans, speed),
and valgrind on the machine (speed).
"""
import datetime
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHARED = pathlib.Path(os.environ.get("LOOPMEND_SHARED_DIR", ROOT.parent / "shared"))
BESIDE_MESHLIB = ["data/bunny.ply", "data/demosthenes.obj", "data/head_holes.ply", "data/plane_holes.obj", "scans2/face_raw.ply",
                  "scans2/facial_skeleton.ply", "scans2/photo_wall.ply", "scans2/range_bun090.ply"]
# MeshLib reads other coordinates from these than Loopmend, or welds them.
ALONE = ["scans2/adonis.obj", "scans2/beetle-alt.obj", "data/cycloidal.ply", "data/doll.obj", "data/dragon.ply", "scans2/mri_head.ply",
         "scans2/skull_scp1.ply", "scans2/snowden_bust.obj"]
TIMED = [*BESIDE_MESHLIB, "data/doll.obj", "scans2/adonis.obj", "scans2/beetle-alt.obj", "scans2/snowden_bust.obj"]
COUNTED = ["data/bunny.ply", "data/demosthenes.obj", "scans2/face_raw.ply", "scans2/photo_wall.ply"]

# For each page what has to be built, and the commands of each section. The last command of a section makes its table: in the file
# {table} where it names that, at the standard output otherwise; in a box where the section's name begins with "box_".
PAGES = {
    "accuracy": (["loopmend_accuracy", "loopmend_rough_rims", "loopmend_cut_models", "loopmend_error_bar", "loopmend-stress"], {
        "accuracy": ["{bin}/loopmend_accuracy --markdown {table}"],
        "rough_rims": ["{bin}/loopmend_rough_rims --markdown {table}"],
        "cut_models": ["{bin}/loopmend_cut_models --half tuning --csv {work}/tuning.csv --markdown {table} {data} {closed}"],
        "error_bar": ["{bin}/loopmend_cut_models --half test --count 20 --methods auto --csv {work}/test.csv {data} {scans} {closed}",
                      "{bin}/loopmend_error_bar {work}/tuning.csv {work}/test.csv --markdown {table}"],
        "stress": ["{bin}/loopmend-stress --count 200 --jobs 2 --markdown {table}"],
    }),
    "blends": (["loopmend", "loopmend_blends"], {
        "sets": ["{bin}/loopmend_blends --count 32"],
        "refinement": ["{bin}/loopmend_blends --count 0 --refine 3"],
        "rings": ["{bin}/loopmend_blends --count 0 --rings"],
        "solids": ["{bench}/platonic_solids.py {bin}/loopmend"],
    }),
    "large_scans": (["loopmend", "loopmend_large_scans"], {
        "large_scans": ["{bench}/large_scans.py --programs {bin} --folder {work}"],
    }),
    "many_scans": (["loopmend", "loopmend_python"], {
        "many_scans": ["env LOOPMEND_PROGRAM={bin}/loopmend PYTHONPATH={bin}/../python "
                       "{python} {root}/python/tests/many_scans.py 60 {work}/many"],
    }),
    "real_scans": (["loopmend", "loopmend_real_scans"], {
        "beside_meshlib": ["{bin}/loopmend_real_scans --program {bin}/loopmend --markdown {table} "
                           "--peer '{python} {bench}/peers_meshlib.py' " + " ".join("{shared}/" + scan for scan in BESIDE_MESHLIB)],
        "alone": ["{bin}/loopmend_real_scans --program {bin}/loopmend --markdown {table} "
                  + " ".join("{shared}/" + scan for scan in ALONE)],
        "preparation": ["{bench}/preparation.py {bin}/loopmend {scans} {data} --largest 18 --folder {work}"],
    }),
    "reliability": (["loopmend", "fault_tests", "app_tests", "loopmend_polyhedra"], {
        "interruptions": ["{bench}/interruptions.py {bin}/loopmend --times 40"],
        "box_faults": ["env LOOPMEND_FAULTS=100 {bin}/fault_tests --gtest_brief=1 --gtest_print_time=0"],
        "box_cycles": ["env LOOPMEND_CYCLES=100 QT_QPA_PLATFORM=offscreen "
                       "{bin}/app_tests --gtest_brief=1 --gtest_print_time=0 --gtest_filter=Cycles.Leave*"],
        "box_polyhedra": ["{bin}/loopmend_polyhedra --every 29"],
    }),
    "speed": (["loopmend", "loopmend_speed"], {
        "speed": ["{bin}/loopmend_speed --cpu --markdown {table}"],
        "whole": ["{bench}/whole_commands.py {bin}/loopmend " + " ".join("{shared}/" + scan for scan in TIMED)],
        "stages": ["{bench}/whole_commands.py --stages {bin}/loopmend " + " ".join("{shared}/" + scan for scan in COUNTED)],
    }),
    "window": (["measure_window", "loopmend_large_scans"], {
        "box_first": ["{screen} env MESA_SHADER_CACHE_DIR={work}/first {bin}/measure_window {data}/dragon.ply {data}/bunny.ply opening gaps"],
        "box_window": ["{screen} env MESA_SHADER_CACHE_DIR={work}/first {bin}/measure_window {data}/dragon.ply {data}/bunny.ply"],
        "box_torus": ["{bin}/loopmend_large_scans write {work}/torus.ply 14000000",
                      "{screen} {bin}/measure_window {work}/torus.ply opening"],
    }),
}


def put_between(page, mark, text):
    """Replaces what stands between the page's comments "MARK begins" and "MARK ends"."""
    content = page.read_text(encoding="utf-8")
    begin, end = f"<!-- {mark} begins -->\n", f"<!-- {mark} ends -->\n"
    if content.count(begin) != 1 or content.count(end) != 1:
        sys.exit(f"{page} has no place for '{mark}'. Restore the comments '{begin.strip()}' and '{end.strip()}' in it.")
    before, rest = content.split(begin)
    page.write_text(before + begin + "\n" + text.strip() + "\n\n" + end + rest.split(end)[1], encoding="utf-8")


def git(*words):
    return subprocess.run(["git", "-C", str(ROOT), *words], check=True, capture_output=True, text=True).stdout.strip()


def measured_on():
    """Where, when and of which programs. Of a commit that leaves the programs as they are, the one before counts."""
    commit = git("log", "-1", "--format=%h", "--", "engine", "app") + ("-dirty" if git("status", "--short", "engine", "app") else "")
    model = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    today = datetime.date.today()
    return (f"Measured {today.day} {today:%B %Y} with {commit} on {os.cpu_count()} cores of {model[1] if model else 'this machine'}, "
            f"load {os.getloadavg()[0]:.1f} at the start.")


def run(section, commands, work):
    """What the section's last command wrote."""
    table, output = work / f"{section}.md", ""
    names = {"root": ROOT, "bin": ROOT / "build/release/bin", "bench": ROOT / "tests/bench", "python": sys.executable, "work": work,
             "table": table, "shared": SHARED, "data": SHARED / "data", "scans": SHARED / "scans2", "closed": SHARED / "scans2/closed",
             "screen": 'xvfb-run -a -s "-screen 0 1400x900x24"'}
    for command in commands:
        words = shlex.split(command.format(**names))
        if words[0].endswith(".py"):
            words.insert(0, sys.executable)
        print("==", shlex.join(words), flush=True)
        # One thread of the BLAS, so that the figures of a busy machine are those of an idle one.
        done = subprocess.run(words, stdout=subprocess.PIPE, text=True, check=False, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        output = done.stdout
        if done.returncode != 0:
            sys.exit(f"{output}\n{words[0]} ended with {done.returncode}")
    if table.exists():
        return table.read_text(encoding="utf-8")
    return f"```text\n{output.rstrip()}\n```" if section.startswith("box_") else output


def main():
    asked = sys.argv[1:]
    if asked[:1] == ["--targets"] and asked[1:] and asked[1] in PAGES:
        print(" ".join(PAGES[asked[1]][0]))
        return
    if len(asked) != 1 or asked[0] not in PAGES:
        sys.exit(f"{__doc__}\nPages: {', '.join(PAGES)}")
    page = ROOT / f"docs/benchmarks/{asked[0]}.md"
    when = measured_on()
    with tempfile.TemporaryDirectory() as folder:
        # The page changes as a whole, or not at all.
        measured = {section: run(section, commands, pathlib.Path(folder)) for section, commands in PAGES[asked[0]][1].items()}
    for section, text in {"measured": when, **measured}.items():
        put_between(page, section, text)


if __name__ == "__main__":
    main()
