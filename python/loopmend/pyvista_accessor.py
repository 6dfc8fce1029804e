# SPDX-License-Identifier: GPL-3.0-or-later
"""mesh.loopmend of PyVista's PolyData: PyVista 0.48 and later finds this by the entry point pyvista.accessors, or after
`import loopmend.pyvista_accessor`."""
from __future__ import annotations

from typing import Any, List

import pyvista

from loopmend._api import boundary_loops, check, fill
from loopmend.results import BoundaryLoop, Check, FillResult


@pyvista.register_dataset_accessor("loopmend", pyvista.PolyData)
class LoopmendAccessor:
    """fill(), check() and boundary_loops() of this mesh."""

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh

    def fill(self, **options: Any) -> FillResult:
        """As loopmend.fill(mesh, ...); `.mesh` of the result is a PolyData."""
        return fill(self._mesh, **options)

    def check(self) -> Check:
        """As loopmend.check(mesh)."""
        return check(self._mesh)

    def boundary_loops(self) -> List[BoundaryLoop]:
        """As loopmend.boundary_loops(mesh)."""
        return boundary_loops(self._mesh)
