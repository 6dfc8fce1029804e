# SPDX-License-Identifier: GPL-3.0-or-later
"""Closes holes in scanned meshes with patches whose curvature runs through the seam.

    import loopmend
    result = loopmend.fill("scan.ply")
    result.save("filled.ply")

A mesh is a Mesh of this package, one of trimesh, PyVista, meshio or Open3D, a path, or two NumPy arrays: vertices of the shape
(n, 3) in any unit of length, faces of the shape (m, 3) with vertex numbers from 0, counter-clockwise seen from outside. The
functions call the engine of the command line `loopmend`; the same options give the same bits.

What cannot be used raises `loopmend.Error`, or one of its subclasses, with one line that says what, where, and what to do.
What becomes of a hole is a value in the result, never an exception. Nothing is printed. Work runs without the GIL; Ctrl-C
raises KeyboardInterrupt at the engine's next look, mostly within some tenths of a second; what only reads or looks at a mesh ends
first.
"""
from loopmend._api import blend, boundary_loops, check, curvatures, evolve, fill, interpolate, read, sample, write
from loopmend._core import Error, InvalidArgument, ReadError, WriteError, __version__
from loopmend._views import render
from loopmend.results import (
    BoundaryLoop, Check, Curvatures, ExpectedDeviation, FillResult, Finding, HoleResult, Mesh, MirrorFit, PatchResult, Seam, Verdict,
)

__all__ = [
    "BoundaryLoop", "Check", "Curvatures", "Error", "ExpectedDeviation", "FillResult", "Finding", "HoleResult", "InvalidArgument",
    "Mesh", "MirrorFit", "PatchResult", "ReadError", "Seam", "Verdict", "WriteError", "__version__", "blend", "boundary_loops", "check", "curvatures", "evolve", "fill",
    "interpolate", "read", "render", "sample", "write",
]
