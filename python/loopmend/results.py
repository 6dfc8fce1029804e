# SPDX-License-Identifier: GPL-3.0-or-later
"""What the functions of loopmend return. Lengths are in the unit of the mesh."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from loopmend._types import Grade, LoopKind, Path, Status

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Bytes = NDArray[np.uint8]


def _without_handles(state: Dict[str, Any]) -> Dict[str, Any]:
    """What pickle takes along: all but what only this process has."""
    return {**state, "carried": None, **({"_back": None, "_mesh": None} if "_back" in state else {})}


@dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh from a file.

    vertices: (n, 3) float64.
    faces: (m, 3) int32, vertex numbers from 0. Polygons come as triangles.
    colors: (n, 4) uint8, red, green, blue, alpha; None where the file has none.
    report: what was in the file, in numbers: format, vertices, faces, triangles, polygons_triangulated, vertices_welded,
        vertices_joined, unreferenced_vertices, coincident_vertices, degenerate_faces, duplicate_faces.
    carried: what else the file holds, such as attributes, materials and texture coordinates: fill() and write() hand it on. None
        where there is nothing, and after pickling. Leave it out where you change the arrays.
    """

    vertices: Floats
    faces: Ints
    colors: Optional[Bytes] = None
    report: Dict[str, Any] = field(default_factory=dict)
    carried: Any = None

    def __repr__(self) -> str:
        format = self.report.get("format")
        return f"<loopmend.Mesh: {len(self.vertices)} vertices, {len(self.faces)} faces{', ' + str(format) if format else ''}>"

    def __getstate__(self) -> Dict[str, Any]:
        return _without_handles(self.__dict__)

    def save(self, path: Path, *, ascii: bool = False) -> None:
        """As write(path, mesh)."""
        from loopmend._api import write  # noqa: PLC0415

        write(path, self, ascii=ascii)


@dataclass(frozen=True, eq=False)
class BoundaryLoop:
    """A closed chain of edges that have a face on one side only.

    number: from 1, by decreasing perimeter; `fill(loops=...)` takes it.
    kind: "hole", "outer rim", "crack" or "cut".
    edges: how many.
    perimeter, diameter: length; the diameter is the largest distance of two vertices.
    planarity: rms distance from the best plane, divided by the diameter; 0 is flat.
    area: of the projection to the best plane, length².
    center: (3,) float64, mean of the vertices.
    vertices: (edges,) int32, vertex numbers in their order along the loop.
    """

    number: int
    kind: LoopKind
    edges: int
    perimeter: float
    diameter: float
    planarity: float
    area: float
    center: Floats
    vertices: Ints

    def __repr__(self) -> str:
        return f"<loopmend.BoundaryLoop {self.number}: {self.kind}, {self.edges} edges, {self.diameter:.4g} wide>"


@dataclass(frozen=True)
class Check:
    """Whether a mesh could be printed.

    ready_to_print: whether nothing stands against it.
    against_it: what does, one phrase each, such as "2 open boundaries".
    pieces: number of components; components share no vertex.
    open_boundaries, open_edges: loops of open edges, two that touch are two; edges of one face.
    touching_edges: of more than two faces, in pairs that agree: where a body touches another, or itself. They may stay.
    non_manifold_edges: of more than two faces that are not in such pairs.
    reversed_edges: whose two faces do not agree which side is outside.
    intersecting_pairs: pairs of faces that cut each other, counted up to a million.
    volume: length³, negative where the mesh is inside out; None where it encloses none.
    """

    ready_to_print: bool
    against_it: Tuple[str, ...]
    pieces: int
    open_boundaries: int
    open_edges: int
    touching_edges: int
    non_manifold_edges: int
    reversed_edges: int
    intersecting_pairs: int
    volume: Optional[float]


@dataclass(frozen=True)
class Seam:
    """Do tangent plane and curvature run through the boundary of a hole? One-sided fits, patch against neighborhood.

    g1_rms_deg, g1_max_deg: angle between the normals, degrees.
    h_jump_rms, h_jump_max: jump of the mean curvature, 1/length.
    h_jump_rms_times_diameter: the same times the diameter of the loop; no unit.

    NaN where there are too few faces on one side to tell.
    """

    g1_rms_deg: float
    g1_max_deg: float
    h_jump_rms: float
    h_jump_max: float
    h_jump_rms_times_diameter: float


@dataclass(frozen=True)
class Finding:
    """One thing that a person should know of a patch.

    code: for scripts; one word that stays the same where the wording changes.
    arguments: its figures; lengths in diameters of the loop, angles in degrees.
    text: the sentence.
    """

    code: str
    arguments: List[float]
    text: str


@dataclass(frozen=True)
class Verdict:
    """What a person sees of a patch, apart from how the solver ended.

    grade: "good"; "look": sound, a person should look at it; "bad": it folds, crosses the surface, tears its seam or is a bubble.
    sentence: the most serious finding; empty where the patch is good.
    findings: all of them, the most serious first.
    crease_deg: bend of the seam that 8 % of its edges, at least two, have or exceed, degrees; None where an edge belongs
        there, as at a flat base.
    height: of the patch over the loop's best plane, beyond the loop itself, in loop diameters.
    folds: edges bent by more than 150 degrees.
    """

    grade: Grade
    sentence: str
    findings: Tuple[Finding, ...]
    crease_deg: Optional[float]
    height: float
    folds: int


@dataclass(frozen=True)
class ExpectedDeviation:
    """Bounds of the rms distance of a patch from the surface that was there, in mesh units.

    half: held for 50 % of the holes of the calibration.
    likely: held for 80 %.
    most: held for 90 %.
    """

    half: float
    likely: float
    most: float


@dataclass(frozen=True)
class MirrorFit:
    """How well the mirror image of the other side fits around a hole, and whether it was copied.

    answer: "proposed": it was copied; "misfit": the surface around fits it too badly; "no_gain": the ordinary patch
        is as near to it; "symmetric": the hole lies across the plane, and its patch was made symmetric; "across": and was not; "no_symmetry": no plane was found; "open_there": nothing is there; "no_disc",
        "faulty": what is there does not close the hole without a fault.
    is_taken: whether it was copied.
    misfit: rms distance of the surface around the hole from the image, in diameters of the hole; NaN without an image.
    difference: rms distance of the image from the ordinary patch, likewise; NaN where nothing was compared.
    text: the answer as a sentence, with its figures.
    plane_point, plane_normal: the mirror plane; the normal has length 1.
    plane_misfit: seven tenths of the surface lie within so much of the image, in diagonals of the box of the surface; 0 for a
        plane that was given.
    """

    answer: str
    is_taken: bool
    misfit: float
    difference: float
    text: str
    plane_point: Tuple[float, float, float]
    plane_normal: Tuple[float, float, float]
    plane_misfit: float


@dataclass(frozen=True, eq=False)
class HoleResult:
    """What became of one boundary loop.

    number, kind, edges, perimeter, diameter, planarity, area, center: as in BoundaryLoop.
    status: "converged", "early_stop", "faired", "filled", "step_limit" and "stalled" have a patch; "failed" and "skipped"
        have none.
    is_filled: whether there is a patch.
    message: what is to be known of it, or why there is none; empty when all is well.
    method: what shaped the patch, such as "mmcvf"; empty where there is none.
    reason: why that was not the flow that was asked for, and how to get it; empty if it was.
    verdict: what a person sees of the patch; None where there is none.
    expected_deviation: how far the patch is likely from what was there; None without an estimate: no patch, no flow that moved a new vertex,
        a cap over a cut, or options other than the default flow's.
    mirror: how well a mirror image fits; None where none was asked for.
    steps: accepted steps.
    energy_before, energy_after: of the flow, at the initial patch and at the end; MMCVF 1/length², WF none, SDF and MCF
        length².
    seam_before, seam_after: of the initial patch and of the final one; None where there is no patch.
    seconds: time on the wall.
    new_vertices, new_faces: int32, ascending: what the patch of this hole consists of in the arrays of the result. A hole and
        the islands joined to it share a patch: each names all of it.
    """

    number: int
    kind: LoopKind
    edges: int
    perimeter: float
    diameter: float
    planarity: float
    area: float
    center: Floats
    status: Status
    is_filled: bool
    message: str
    method: str
    reason: str
    verdict: Optional[Verdict]
    expected_deviation: Optional[ExpectedDeviation]
    mirror: Optional[MirrorFit]
    steps: int
    energy_before: float
    energy_after: float
    seam_before: Optional[Seam]
    seam_after: Optional[Seam]
    seconds: float
    new_vertices: Ints
    new_faces: Ints

    def __repr__(self) -> str:
        grade = "" if self.verdict is None else f", {self.verdict.grade}"
        return f"<loopmend.HoleResult {self.number}: {self.kind}, {self.edges} edges, {self.status}{grade}>"


@dataclass(frozen=True, eq=False)
class FillResult:
    """A mesh with its holes filled.

    vertices: (n, 3) float64. Those given come first, bit for bit.
    faces: (m, 3) int32. Those given come first, in their order; a face that disagreed with its neighbours is turned round.
    colors: uint8, as wide as those given, continued over the patches; None where none were given.
    holes: one HoleResult for each boundary loop, in the order of their numbers; also those that were left.
    given_vertices, given_faces: how many stand before the new ones. With stitch, repair, bridges or trim_boundary these
        are the vertices and faces of the mesh that was prepared so. With patches_only: the vertices of the mesh that the
        patches use, and no faces.
    expected_deviation: (k,) float64, one for each of new_vertices, mesh units: how far it is likely from what was there; NaN
        without an estimate.
    turned_faces: how many were turned round.
    stopped: whether max_time, or Ctrl-C with keep_partial, ended the work before all was done.
    prepared: what stitch and repair did, in numbers: {"joined_tiles": {...}, "stitched": {...}, "repaired": {...}, "joined_again": N}.
    trimmed_faces: what trim_boundary or trim_crossing removed: {"face": number before the trimming, "fault": a word, "ring": the round}.
    carried: as in Mesh, for the filled mesh.
    """

    vertices: Floats
    faces: Ints
    colors: Optional[Bytes]
    holes: Tuple[HoleResult, ...]
    given_vertices: int
    given_faces: int
    expected_deviation: Floats
    turned_faces: int
    stopped: bool
    prepared: Dict[str, Dict[str, int]]
    trimmed_faces: Tuple[Dict[str, Any], ...]
    carried: Any = None
    _back: Any = None
    _mesh: Any = None

    def __repr__(self) -> str:
        filled = sum(hole.is_filled for hole in self.holes)
        return (f"<loopmend.FillResult: {filled} of {len(self.holes)} {'loop' if len(self.holes) == 1 else 'loops'} filled, "
                f"{len(self.vertices)} vertices ({len(self.new_vertices)} new), {len(self.faces)} faces ({len(self.new_faces)} new)>")

    def _repr_html_(self) -> str:
        from loopmend._views import html_of  # noqa: PLC0415

        return html_of(self)

    def __getstate__(self) -> Dict[str, Any]:
        return _without_handles(self.__dict__)

    @property
    def mesh(self) -> Any:
        """The filled mesh in the type of what was given to fill(): of arrays and paths a Mesh. After pickling always a Mesh."""
        if self._mesh is None:
            made = Mesh(self.vertices, self.faces, self.colors, carried=self.carried) if self._back is None or self.carried is None else self._back(self)
            object.__setattr__(self, "_mesh", made)
        return self._mesh

    def save(self, path: Path, *, ascii: bool = False) -> None:
        """Writes the filled mesh, as write(path, result): with all that its file carried."""
        from loopmend._api import write  # noqa: PLC0415

        write(path, self, ascii=ascii)

    def render(self, path: Optional[Path] = None, *, size: Tuple[int, int] = (960, 720),
               direction: Optional[Sequence[float]] = None) -> Bytes:
        """As render(result): a picture with the patches in orange."""
        from loopmend._views import render  # noqa: PLC0415

        return render(self, path, size=size, direction=direction)

    def plot(self) -> Any:
        """Shows the filled mesh by PyVista, or its picture by Matplotlib."""
        from loopmend._views import show  # noqa: PLC0415

        return show(self)

    def to_trimesh(self) -> Any:
        """trimesh.Trimesh; face_attributes["hole"] is the number of the hole, 0 for faces that were given."""
        from loopmend._views import to_trimesh  # noqa: PLC0415

        return to_trimesh(self)

    def to_pyvista(self) -> Any:
        """pyvista.PolyData; cell_data["hole"] as in to_trimesh(), point_data["expected_deviation"] in mesh units."""
        from loopmend._views import to_pyvista  # noqa: PLC0415

        return to_pyvista(self)

    def to_frame(self) -> Any:
        """pandas.DataFrame with one row for each loop."""
        from loopmend._views import to_frame  # noqa: PLC0415

        return to_frame(self)

    @property
    def new_vertices(self) -> Ints:
        """(k,) int32: numbers of all new vertices."""
        return np.arange(self.given_vertices, len(self.vertices), dtype=np.int32)

    @property
    def new_faces(self) -> Ints:
        """(k,) int32: numbers of all new faces."""
        return np.arange(self.given_faces, len(self.faces), dtype=np.int32)


@dataclass(frozen=True, eq=False)
class Curvatures:
    """Curvatures and normals at the vertices of a mesh, from local fits; NaN where no fit was possible.

    H: (n,) float64, mean curvature, 1/length; −1/R on a sphere of radius R with outward normals.
    K: (n,) float64, Gaussian curvature, 1/length².
    normals: (n, 3) float64, of length 1.
    """

    H: Floats
    K: Floats
    normals: Floats


@dataclass(frozen=True, eq=False)
class PatchResult:
    """A surface with one patch that blend, interpolate or evolve made.

    vertices: (n, 3) float64.
    faces: (m, 3) int32.
    refusal: why the surface should not be used; empty where it may. The command line writes nothing then.
    status, message, method, reason, steps, energy_before, energy_after: as in HoleResult.
    folds, self_intersections: edges of the patch that fold by more than 90 degrees, faces that cut each other.
    min_angle_deg: smallest angle of a face of the patch, degrees.
    seams_before, seams_after: one Seam for each loop of the patch, before and after; empty where nothing lies beyond.
    given_vertices: so many of the first vertices are given, bit for bit. evolve: 0, see there.
    turned_faces: blend: how many faces were turned round, since their inside faced the gap.
    remeshed: evolve: the region has other vertices than it had; then its new ones come last.
    """

    vertices: Floats
    faces: Ints
    refusal: str
    status: str
    message: str
    method: str
    reason: str
    steps: int
    energy_before: float
    energy_after: float
    folds: int
    self_intersections: int
    min_angle_deg: float
    seams_before: Tuple[Seam, ...]
    seams_after: Tuple[Seam, ...]
    given_vertices: int
    turned_faces: int
    remeshed: bool
