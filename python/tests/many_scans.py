# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills many scans in three ways, with workers killed on the way: `loopmend batch`, the Snakemake workflow of
docs/user/workflows.md and the Dask example of docs/user/python.md. All must come to the same bits.

Usage: many_scans.py COUNT FOLDER   (FOLDER must not exist; LOOPMEND_PROGRAM names the program, PYTHONPATH leads to the module)

Prints a table for docs/benchmarks/many_scans.md. A way whose tool is missing is left out, and said so. test_many_scans.py runs
the same functions on few scans.
"""
import csv
import importlib.util
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import loopmend
from conftest import icosphere, without

PAGES = Path(__file__).resolve().parents[2] / "docs/user"
PROGRAM = os.environ.get("LOOPMEND_PROGRAM", "")


def make_scan(seed):
    """A bumpy sphere with one to four round holes and, every other time, noise. Returns vertices, faces and the number of holes."""
    rng = np.random.default_rng(seed)
    vertices, faces = icosphere(4)
    waves, phases = rng.normal(size=(6, 3)) * 2, rng.uniform(0, 6, 6)
    height = 1 + (rng.uniform(0.01, 0.05, 6) * np.sin(vertices @ waves.T + phases)).sum(axis=1)
    if seed % 2:
        height += rng.normal(size=len(vertices)) * rng.uniform(0.0005, 0.004)
    centers, chosen = [], np.zeros(len(vertices), bool)
    for _ in range(rng.integers(1, 5)):
        center = rng.normal(size=3)
        center /= np.linalg.norm(center)
        if all(center @ other < np.cos(1.0) for other in centers):  # no two share a boundary
            centers.append(center)
            chosen |= vertices @ center > np.cos(rng.uniform(0.12, 0.35))
    return *without(vertices * height[:, None] * 50, faces, lambda _: chosen), len(centers)


def make_scans(folder, count):
    """scan_000.ply, ... Returns how many holes they have in all."""
    folder.mkdir(parents=True)
    holes = 0
    for seed in range(count):
        vertices, faces, number = make_scan(seed)
        loopmend.write(folder / f"scan_{seed:03}.ply", vertices, faces)
        holes += number
    return holes


def workers_below(process, name="loopmend"):
    """Processes with this name among those that a process has started, and these in turn."""
    parents, names = {}, {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                words = (entry / "stat").read_text()
            except OSError:
                continue  # it has just ended
            names[int(entry.name)] = words[words.index("(") + 1:words.rindex(")")]
            parents[int(entry.name)] = int(words[words.rindex(")") + 2:].split()[1])
    found, front = [], [process]
    while front:
        below = [child for child, parent in parents.items() if parent == front[-1]]
        front.pop()
        front += below
        found += [child for child in below if names[child] == name]
    return found


def wait_for(holds, process):
    """Waits until holds() is true, while the process runs. Returns what holds() returned."""
    while process.poll() is None:
        if found := holds():
            return found
        time.sleep(0.001)
    raise AssertionError(f"ended with {process.returncode} before anything could be killed")


def kill_a_worker(process, folder):
    """One that has not written its report yet: it is held while we look."""

    def one():
        for worker in workers_below(process.pid):
            try:
                os.kill(worker, signal.SIGSTOP)
                words = Path(f"/proc/{worker}/cmdline").read_bytes().split(b"\0")
                if b"--report" in words and not (folder / os.fsdecode(words[words.index(b"--report") + 1])).exists():
                    os.kill(worker, signal.SIGKILL)
                    return worker
                os.kill(worker, signal.SIGCONT)
            except (OSError, IndexError):
                continue  # it has just ended
        return None

    wait_for(one, process)


def files(folder, pattern):
    return sorted(folder.rglob(pattern)) if folder.exists() else []


def start(words, folder):
    environment = {**os.environ, "PATH": f"{os.path.dirname(PROGRAM)}:{os.environ['PATH']}", "HOME": str(folder)}
    if words[0] == "snakemake":
        environment.pop("PYTHONPATH", None)  # its own Python, maybe another one
    with (folder / "log.txt").open("a") as log:
        return subprocess.Popen(words, cwd=folder, env=environment, stdout=log, stderr=log)


def finish(words, folder):
    code = start(words, folder).wait()
    assert code == 0, (folder / "log.txt").read_text()


def fill_by_batch(scans, folder):
    """One worker is killed, then the batch itself; a third run finishes. Returns the outputs by scan."""
    folder.mkdir()
    words = [PROGRAM, "batch", str(scans), "-o", "out", "--jobs", "2", "--pictures", "none"]
    count = len(files(scans, "*.ply"))
    run = start(words, folder)
    wait_for(lambda: len(files(folder / "out/reports", "*.json")) >= count // 4, run)
    kill_a_worker(run, folder)
    wait_for(lambda: len(files(folder / "out/reports", "*.json")) >= count // 3, run)
    run.kill()
    run.wait()
    done = len(files(folder / "out/reports", "*.json"))
    assert count // 3 <= done < count, "the batch was not killed on the way"
    finish(words, folder)
    with (folder / "out/summary.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["status"] for row in rows] == ["filled"] * count, rows
    assert sum(row["this_run"] == "no" for row in rows) >= done - 2, "what was complete was filled again"
    return {path.stem: path for path in files(folder / "out/filled", "*.ply")}


def fill_by_snakemake(scans, folder):
    """One worker is killed; the next run makes what it left."""
    folder.mkdir()
    page = (PAGES / "workflows.md").read_text(encoding="utf-8")
    (folder / "Snakefile").write_text(re.search("<!-- file: Snakefile -->\n```python\n(.*?)^```$", page, re.M | re.S)[1])
    (folder / "scans").symlink_to(scans)
    words = ["snakemake", "--cores", "2", "--keep-going"]
    run = start(words, folder)
    wait_for(lambda: files(folder / "filled", "*.ply"), run)
    kill_a_worker(run, folder)
    assert run.wait() != 0, "the worker that was killed is missing nowhere"
    finish(words, folder)
    return {path.stem: path for path in files(folder / "filled", "*.ply")}


def fill_by_dask(scans, folder):
    """The example of python.md, with as many scans; one worker is killed, and Dask gives its scans to the others."""
    from distributed import Client, LocalCluster  # pylint: disable=import-outside-toplevel

    shutil.copytree(scans, folder)
    page = (PAGES / "python.md").read_text(encoding="utf-8")
    (folder / "fill_one.py").write_text(re.search("<!-- file: fill_one.py -->\n```python\n(.*?)^```$", page, re.M | re.S)[1])
    sys.path.insert(0, str(folder))
    os.environ["PYTHONPATH"] = f"{folder}:{os.environ.get('PYTHONPATH', '')}"  # for the workers
    spec = importlib.util.spec_from_file_location("fill_one", folder / "fill_one.py")
    fill_one = sys.modules["fill_one"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(fill_one)
    paths = files(folder, "*.ply")
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        futures = client.map(fill_one.fill_one, paths)
        while not any(future.done() for future in futures):
            time.sleep(0.01)
        os.kill(client.run(os.getpid).popitem()[1], signal.SIGKILL)
        assert len(client.gather(futures)) == len(paths)
    return {path.name.split(".")[0]: path for path in files(folder, "*.filled.off")}


def missing(way):
    """Why a way cannot be taken here; empty where it can."""
    if not PROGRAM or not Path(PROGRAM).exists():
        return "LOOPMEND_PROGRAM names no program"
    if way == "snakemake" and shutil.which("snakemake") is None:
        return "snakemake is not installed (Debian: snakemake)"
    if way == "dask" and importlib.util.find_spec("distributed") is None:
        return "the package distributed is not installed"
    return ""


WAYS = {"batch": fill_by_batch, "snakemake": fill_by_snakemake, "dask": fill_by_dask}


def assert_same(outputs, scans):
    """Every scan has an output in each way, closed, and all have the same bits."""
    for scan in files(scans, "*.ply"):
        meshes = {way: loopmend.read(paths[scan.stem]) for way, paths in outputs.items()}
        first = next(iter(meshes.values()))
        assert loopmend.boundary_loops(first.vertices, first.faces) == [], f"{scan.stem} has an open loop"
        for way, mesh in meshes.items():
            assert mesh.vertices.tobytes() == first.vertices.tobytes(), f"{scan.stem}: other vertices by {way}"
            assert mesh.faces.tobytes() == first.faces.tobytes(), f"{scan.stem}: other faces by {way}"


def main():
    count, folder = int(sys.argv[1]), Path(sys.argv[2]).resolve()
    scans, outputs = folder / "scans", {}
    print(f"{count} scans with {make_scans(scans, count)} holes")
    for way, fill in WAYS.items():
        if reason := missing(way):
            print(f"{way}: left out: {reason}")
            continue
        begin = time.monotonic()
        outputs[way] = fill(scans, folder / way)
        print(f"| {way} | {len(outputs[way])} | {time.monotonic() - begin:.1f} |", flush=True)
    assert_same(outputs, scans)
    print("equal bits:", ", ".join(outputs))


if __name__ == "__main__":
    main()
