#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills every hole of a mesh by MeshLib's fillHoleNicely, for `loopmend_real_scans --peer`. Needs PyPI's meshlib, which is
used for measuring only. Call: peers_meshlib.py INPUT OUTPUT"""
import sys

import meshlib.mrmeshpy as mm


def main(source, target):
    mesh = mm.loadMesh(source)
    for edge in mesh.topology.findHoleRepresentiveEdges():
        settings = mm.FillHoleNicelySettings()
        settings.triangulateParams.metric = mm.getUniversalMetric(mesh)
        settings.subdivideSettings.maxEdgeLen = float(mesh.averageEdgeLength())
        settings.subdivideSettings.maxEdgeSplits = 20000
        settings.smoothCurvature = True
        mm.fillHoleNicely(mesh, edge, settings)
    mm.saveMesh(mesh, target)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
