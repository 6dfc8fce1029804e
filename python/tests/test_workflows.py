# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflow of docs/user/workflows.md runs with Debian's snakemake, and does no work twice."""
import csv
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import loopmend
from conftest import icosphere, without

PAGE = Path(__file__).resolve().parents[2] / "docs/user/workflows.md"


@pytest.fixture
def folder(tmp_path, program):
    """Holds the page's Snakefile and two scans: the sample, and a sphere with a hole."""
    if shutil.which("snakemake") is None:
        pytest.skip("snakemake is not installed (Debian: snakemake)")
    text = PAGE.read_text(encoding="utf-8")
    (tmp_path / "Snakefile").write_text(re.search("<!-- file: Snakefile -->\n```python\n(.*?)^```$", text, re.M | re.S)[1])
    (tmp_path / "scans").mkdir()
    program("sample", "-o", tmp_path / "scans/a face.ply")
    loopmend.write(tmp_path / "scans/ball.ply", *without(*icosphere(3), lambda v: v[:, 2] > 0.9))
    return tmp_path


def snakemake(folder):
    """Runs the workflow. Returns its exit code and the scans that were filled."""
    programs = os.path.dirname(os.environ["LOOPMEND_PROGRAM"])
    environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "HOME": str(folder)}
    environment.pop("PYTHONPATH", None)
    done = subprocess.run(["snakemake", "--cores", "2", "--keep-going"], cwd=folder, env=environment, text=True, check=False,
                          capture_output=True, timeout=300)
    return done.returncode, sorted(re.findall(r"^ +wildcards: name=(.*)$", done.stderr, re.M)), done.stderr


def test_the_workflow_fills_each_scan_once(folder):
    code, filled, said = snakemake(folder)
    assert code == 0, said
    assert filled == ["a face", "ball"]
    rows = list(csv.reader((folder / "summary.csv").open()))
    assert rows[0] == ["scan", "loop", "status", "new vertices", "message"]
    assert [(row[0], row[1], row[2]) for row in rows[1:]] == [
        *(("a face", str(k), "early_stop") for k in range(2, 7)), ("ball", "1", "converged")]
    mesh = loopmend.read(folder / "filled/ball.ply")
    assert loopmend.boundary_loops(mesh.vertices, mesh.faces) == []

    assert snakemake(folder)[:2] == (0, [])
    loopmend.write(folder / "scans/ball.ply", *without(*icosphere(3), lambda v: v[:, 2] > 0.8))
    assert snakemake(folder)[:2] == (0, ["ball"])


def test_a_scan_that_cannot_be_read_leaves_the_others_alone(folder):
    (folder / "scans/notes.ply").write_text("This is not a mesh.\n")
    code, _, said = snakemake(folder)
    assert code == 1
    assert 'does not begin with "ply"' in said
    assert sorted(path.name for path in (folder / "filled").iterdir()) == ["a face.ply", "ball.ply"]
    assert not (folder / "summary.csv").exists()
