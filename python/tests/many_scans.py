# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills many scans in four ways, with workers killed on the way: `loopmend batch`, the Snakemake workflow of
docs/user/workflows.md, the same on a Slurm cluster of one node, and the Dask example of docs/user/python.md. All must come to the
same bits.

Usage: many_scans.py COUNT FOLDER   (FOLDER must not exist; LOOPMEND_PROGRAM names the program, PYTHONPATH leads to the module)

Prints the table of docs/benchmarks/many_scans.md. A way whose tool is missing is left out, and said so. test_many_scans.py runs
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
import unittest
from pathlib import Path

import numpy as np

import loopmend
from conftest import icosphere, without

PAGES = Path(__file__).resolve().parents[2] / "docs/user"
PROGRAM = os.environ.get("LOOPMEND_PROGRAM", "")
SYSTEM_PATH = f"{os.environ['PATH']}:/usr/sbin"


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


def workers_in(folder):
    """Processes of the program with this working folder."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            if (entry / "comm").read_text() == "loopmend\n" and (entry / "cwd").readlink() == folder:
                found.append(int(entry.name))
        except OSError:
            continue  # it has just ended
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
        for worker in workers_in(folder):
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
    if words[0] != PROGRAM:
        environment.pop("PYTHONPATH", None)  # Snakemake's own Python, maybe another one
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


def write_workflow(scans, folder):
    """The files that workflows.md shows, and the scans beside them."""
    folder.mkdir()
    page = (PAGES / "workflows.md").read_text(encoding="utf-8")
    for name, text in re.findall("<!-- file: (.*?) -->\n```\\w+\n(.*?)^```$", page, re.M | re.S):
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
    (folder / "scans").symlink_to(scans)


def fill_by_snakemake(scans, folder):
    """One worker is killed; the next run makes what it left."""
    write_workflow(scans, folder)
    words = ["snakemake", "--cores", "2", "--keep-going"]
    run = start(words, folder)
    wait_for(lambda: files(folder / "filled", "*.ply"), run)
    kill_a_worker(run, folder)
    assert run.wait() != 0, "the worker that was killed is missing nowhere"
    finish(words, folder)
    return {path.stem: path for path in files(folder / "filled", "*.ply")}


def fill_by_slurm(scans, folder):
    """The profile of workflows.md on a cluster of one node. One worker is killed; its job is started once more."""
    write_workflow(scans, folder)
    words = [str(Path(__file__).with_name("slurm_node.sh")), str(folder / "node"), "sh", "-e", "start.sh"]
    run = start(words, folder)

    try:
        wait_for(lambda: files(folder / "filled", "*.ply"), run)
    except AssertionError:
        if run.returncode == 77:
            raise unittest.SkipTest((folder / "log.txt").read_text()) from None
        raise
    kill_a_worker(run, folder)
    assert run.wait() == 0, (folder / "log.txt").read_text()
    assert "Trying to restart" in (folder / "log.txt").read_text(), "no job was started again"
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
    if way in ("snakemake", "slurm") and shutil.which("snakemake") is None:
        return "snakemake is not installed (Debian: snakemake)"
    if way == "slurm":
        names = [name for name in ("slurmctld", "slurmd", "sbatch", "munged") if shutil.which(name, path=SYSTEM_PATH) is None]
        if names:
            return f"not installed: {', '.join(names)} (Debian: slurmctld slurmd slurm-client munge)"
        version = subprocess.run(["snakemake", "--version"], capture_output=True, text=True, check=True).stdout
        if not version.startswith("7."):
            return f"the profile is for Snakemake 7, not {version.strip()}"
    if way == "dask" and importlib.util.find_spec("distributed") is None:
        return "the package distributed is not installed"
    return ""


TITLES = {
    "batch": ("`loopmend batch --pictures none`", "a worker after a quarter, the batch itself after a third; the next run finished"),
    "snakemake": ("the Snakemake workflow of [Workflows](../user/workflows.md)", "a worker; the next run finished"),
    "slurm": ("the same on a Slurm cluster of one node, with the profile of that page", "a worker; its job was started again"),
    "dask": ("the Dask example of [Python](../user/python.md#many-scans)", "a worker; Dask gave its scans to the other"),
}
WAYS = {"batch": fill_by_batch, "snakemake": fill_by_snakemake, "slurm": fill_by_slurm, "dask": fill_by_dask}


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
    print(f"{count} scans with {make_scans(scans, count)} holes:\n")
    print("| method | scans | what was killed (`kill -9`) |\n| --- | ---: | --- |")
    for way, fill in WAYS.items():
        if reason := missing(way):
            print(f"| {TITLES[way][0]} | left out: {reason} | |")
            continue
        try:
            outputs[way] = fill(scans, folder / way)
        except unittest.SkipTest as reason:
            print(f"| {TITLES[way][0]} | left out: {reason} | |")
            continue
        print(f"| {TITLES[way][0]} | {len(outputs[way])} | {TITLES[way][1]} |", flush=True)
    assert_same(outputs, scans)
    print(f"\nEqual bits: {', '.join(outputs)}.")


if __name__ == "__main__":
    main()
