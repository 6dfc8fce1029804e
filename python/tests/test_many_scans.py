# SPDX-License-Identifier: GPL-3.0-or-later
"""loopmend batch, the Snakemake workflow, alone and under Slurm, and the Dask example come to the same bits, though workers are
killed on the way."""
import pytest

import many_scans


@pytest.fixture(scope="module")
def scans(tmp_path_factory):
    folder = tmp_path_factory.mktemp("many") / "scans"
    many_scans.make_scans(folder, 12)
    return folder


@pytest.fixture(scope="module")
def by_batch(scans):
    if reason := many_scans.missing("batch"):
        pytest.skip(reason)
    return many_scans.fill_by_batch(scans, scans.parent / "batch")


def test_a_batch_that_was_killed_fills_every_scan(scans, by_batch):
    many_scans.assert_same({"batch": by_batch}, scans)


@pytest.mark.parametrize("way", ["snakemake", "slurm", "dask"])
def test_others_come_to_the_same_bits(scans, by_batch, way):
    if reason := many_scans.missing(way):
        pytest.skip(reason)
    others = many_scans.WAYS[way](scans, scans.parent / way)
    many_scans.assert_same({"batch": by_batch, way: others}, scans)
