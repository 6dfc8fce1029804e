# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of loopmend."""
from __future__ import annotations

import os
import warnings
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from loopmend import _core
from loopmend._meshes import given, surface
from loopmend._meshes import read as _read
from loopmend._progress import shown
from loopmend._types import Boundary, Continuity, Edges, Flow, Islands, Mode, OnProgress, OnStep, Path, Relief, Solver
from loopmend._words import errors_in_python, in_python
from loopmend.results import (
    BoundaryLoop, Check, Curvatures, ExpectedDeviation, FillResult, Finding, HoleResult, Mesh, MirrorFit, PatchResult, Seam, Verdict,
)

Loops = Union[None, int, BoundaryLoop, Sequence[Union[int, BoundaryLoop]], Mapping[Any, Optional[str]], str]


def _loop(figures: Dict[str, Any]) -> Dict[str, Any]:
    figures["center"] = np.array(figures["center"])
    return figures


def _seam(figures: Optional[Dict[str, float]]) -> Optional[Seam]:
    return None if figures is None else Seam(**figures)


def _hole(figures: Dict[str, Any]) -> HoleResult:
    for name in ("seam_before", "seam_after"):
        figures[name] = _seam(figures[name])
    if figures["verdict"] is not None:
        figures["verdict"]["sentence"] = in_python(figures["verdict"]["sentence"])
        figures["verdict"]["findings"] = tuple(Finding(**{**finding, "text": in_python(finding["text"])})
                                               for finding in figures["verdict"]["findings"])
        figures["verdict"] = Verdict(**figures["verdict"])
    if figures["expected_deviation"] is not None:
        figures["expected_deviation"] = ExpectedDeviation(**figures["expected_deviation"])
    if figures["mirror"] is not None:
        figures["mirror"] = MirrorFit(**figures["mirror"])
    for name in ("message", "reason"):
        figures[name] = in_python(figures[name])
    return HoleResult(**_loop(figures))


def _numbers(numbers: Union[None, int, Iterable[int]]) -> Optional[List[int]]:
    if numbers is None:
        return None
    array = np.atleast_1d(np.asarray(numbers))
    if array.size and array.dtype.kind not in "iu":
        raise TypeError(f"whole numbers are needed, not {numbers!r}")
    return [int(n) for n in array.ravel()]


def _loops(loops: Loops) -> Optional[str]:
    """As --loops takes them. BoundaryLoop and HoleResult stand for their numbers."""
    if loops is None or isinstance(loops, str):
        return loops
    several: List[Any] = list(loops) if isinstance(loops, Iterable) else [loops]
    numbers = _numbers([getattr(loop, "number", loop) for loop in several]) or []
    shapes = list(loops.values()) if isinstance(loops, Mapping) else [None] * len(numbers)
    return ",".join(str(number) + (f":{shape}" if shape else "") for number, shape in zip(numbers, shapes))


def _rgba(colors: Any) -> Any:
    """Colours with alpha: the engine takes four numbers."""
    if colors is None:
        return None
    array = np.asarray(colors)
    if array.ndim == 2 and array.shape[1] == 3:
        return np.column_stack([array, np.full(len(array), 255, array.dtype)])
    return array


def _flow(flow: str, boundary: str, continuity: str, density: float, mode: str, steps: Optional[int], sigma: float,
          solver: str, relief: str = "smooth", relief_seed: int = 1, edges: str = "auto") -> Dict[str, Any]:
    return {"flow": flow, "boundary": boundary, "continuity": continuity, "density": density, "mode": mode, "steps": steps,
            "sigma": sigma, "solver": solver, "relief": relief, "relief_seed": relief_seed, "edges": edges}


def fill(
    mesh: Any,
    faces: Optional[ArrayLike] = None,
    *,
    loops: Loops = None,
    at_vertices: Union[None, int, Sequence[int]] = None,
    max_edges: Optional[int] = None,
    max_diameter: Optional[float] = None,
    all_but_largest: int = 0,
    include_outer_rim: bool = False,
    islands: Islands = "join",
    mirror: bool = False,
    mirror_plane: Optional[Sequence[float]] = None,
    flow: Flow = "mmcvf",
    boundary: Boundary = "auto",
    continuity: Continuity = "curvature",
    relief: Relief = "smooth",
    relief_seed: int = 1,
    edges: Edges = "auto",
    drawn_edges: Sequence[Tuple[int, int]] = (),
    stopped_edges: Sequence[int] = (),
    density: float = 1.0,
    mode: Mode = "steady",
    steps: Optional[int] = None,
    sigma: float = 10.0,
    solver: Solver = "auto",
    stitch: Union[bool, float, str] = False,
    auto: bool = False,
    turn_around: bool = False,
    repair: bool = False,
    cut_intersections: bool = False,
    union: bool = False,
    cut_handles: bool = False,
    cut_no_data: bool = False,
    cut_plane: Optional[Sequence[float]] = None,
    base: Union[None, float, Tuple[int, float]] = None,
    bridges: Sequence[Tuple[int, int]] = (),
    trim_boundary: int = 0,
    trim_crossing: bool = False,
    max_time: Optional[float] = None,
    max_memory: Optional[float] = None,
    keep_partial: bool = False,
    patches_only: bool = False,
    threads: int = 0,
    colors: Optional[ArrayLike] = None,
    progress: Union[None, bool, OnProgress] = None,
) -> FillResult:
    """Fills the holes of a mesh with smooth patches.

    Every hole is filled unless loops or vertices are named; the outer rim of an open sheet is left. The options are those of
    `loopmend fill`, and give the same bits. The result does not depend on the number of threads.

    Parameters:
        mesh: a Mesh, trimesh.Trimesh, pyvista.PolyData, meshio.Mesh, open3d.geometry.TriangleMesh, the path of a file, an earlier
            result; or vertices, (n, 3), real numbers, in any unit of length.
        faces: with vertices: (m, 3), whole numbers from 0 to n − 1, counter-clockwise seen from outside.
        loops: the loops to fill, as boundary_loops() gives them, or their numbers; None: all holes. A mapping such as {3: "flat",
            7: "tangent", 8: None}, or the text "3:flat,7:tangent,8", also says how the patch meets the scan there: "flat" is a
            plane or minimal surface, "smooth" has the curvature of the scan; the text "all:flat" says it for all holes.
        at_vertices: vertex numbers; the loops through them are filled, beside those that `loops` names.
        max_edges: leaves loops with more edges, 1 or more.
        max_diameter: leaves wider loops; a length greater than 0.
        all_but_largest: leaves so many of the largest loops, those of outer rims among them.
        include_outer_rim: fills the outer rims of open sheets as well.
        islands: "join" joins the islands within a hole, parts of the surface, to its patch, and walls that end in one plane
            by one face; "cover" gives each hole a patch of its own.
        mirror: closes holes by a copy of the other side, mirrored, where the surface around them fits its image; the planes of
            symmetry are looked for.
        mirror_plane: the same with this plane: x, y, z of a point in it and of its normal.
        flow: what makes the patch smooth: "mmcvf" (minimal variation of mean curvature), "wf" (Willmore flow), "sdf"
            (surface diffusion), "mcf" (mean curvature flow), or "none", which leaves the initial patch.
        boundary: curvature around the hole, for "mmcvf": "auto" that of the smooth surface under relief and noise, "exact"
            as it is, "robust" hardly.
        continuity: what runs through the seam, for "mmcvf": "position", "tangent" or "curvature".
        relief: "smooth": the patch continues the smooth surface under the scan; "continued": and has random relief as strong
            as that around the hole. For flows in the mode "steady".
        relief_seed: 0 or more; another seed gives other relief of the same strength.
        edges: sharp edges that end at a hole, for "mmcvf": "auto" they run on across it where both sides say how, "round" one
            smooth patch.
        drawn_edges: pairs of boundary vertices of one hole between which a sharp edge runs, whatever the surface around shows.
        stopped_edges: boundary vertices; sharp edges that end there are not continued.
        density: vertices along a length, relative to the mesh around; 0.1 to 10.
        mode: "steady" goes straight to the steady state, "steps" takes the flow's own steps.
        steps: at most so many, 1 or more; None: 60.
        sigma: size of a step in the mode "steps", no unit; 1e-6 to 1e8.
        solver: of the steps: "auto", "direct" or "gmres".
        stitch: joins boundaries that lie within a tenth of their edges of each other first; within a length, as in
            ``stitch=0.5``, where tiles that overlap within it are joined as well; or within a part of the edges, as in
            ``stitch="5%"``.
        auto: does first what this mesh needs, and nothing else: cut_no_data where vertices mark missing data, stitch where
            boundaries nearly coincide, repair where loops run along edges of more than two faces, trim_crossing where no patch
            could be valid.
        turn_around: turns all faces round first, as those of a scan that is inside out.
        repair: makes an oriented manifold of the mesh first, and turns bodies that are inside out.
        cut_intersections: the same, and removes faces that cut others; the holes that this leaves are filled. Bodies that are
            closed but for small holes stay whole where they overlap.
        union: the same as repair, and makes one body of closed ones that overlap; cavities stay. Open components and bodies
            that cross themselves are left: `prepared["repaired"]["union"]` counts them.
        cut_handles: the same as repair, and cuts open handles of at most eight edges and a 25th of
            the extent of their component, for their holes to be filled.
        cut_no_data: removes the faces at vertices that mark missing data first, such as heights of -9999.
        cut_plane: cuts by a plane first: x, y, z of a point in it and of its normal. What lies on the side of the normal is removed,
            and the section is closed by plane faces.
        base: builds a base first under the largest loop, a straight wall to a plane so far below it, as ``base=5.0``; or under
            another loop, as ``base=(2, 5.0)``.
        bridges: pairs of boundary vertices between which a strip is laid first, to part a complex hole.
        trim_boundary: removes up to so many rings of bad boundary faces first; 0 to 100.
        trim_crossing: removes the boundary faces that run through the surface first, where no patch could be valid; nothing else.
        max_time: seconds; what is not finished then is left open. None: no limit.
        max_memory: megabytes of the whole process; a hole whose patch would need more is left open. None: nine tenths of what
            is free.
        keep_partial: Ctrl-C hands back the patches that are finished, and raises nothing; a second one raises KeyboardInterrupt.
        patches_only: hands back the patches alone, with the vertices of the mesh that they use.
        threads: holes worked on at once, 0 to 1024; 0: one for each core.
        colors: (n, 3) or (n, 4) uint8, red, green, blue, alpha of each vertex: they run on over the patches. None: those of the
            mesh.
        progress: True: a bar by tqdm. Or called as progress(loops done, loops in all, number of the loop just worked on) on the
            calling thread. What it raises stops the work and is raised by this function.

    Returns:
        FillResult; its `mesh` is of the type that was given, with the attributes of the mesh continued. What became of a hole stands there: a hole that cannot be filled raises nothing.

    Raises:
        InvalidArgument: an argument is of another shape, out of its range or names no such loop or vertex; no face can be
            used.
        KeyboardInterrupt: Ctrl-C, unless keep_partial=True. Of work given up nothing is left behind.
        MemoryError: there is not enough memory.

    Example:
        >>> import loopmend
        >>> scan = loopmend.sample()
        >>> result = loopmend.fill(scan, loops=[6])
        >>> [hole.status for hole in result.holes]
        ['skipped', 'skipped', 'skipped', 'skipped', 'skipped', 'early_stop']
    """
    options = {
        **_flow(flow, boundary, continuity, density, mode, steps, sigma, solver, relief, relief_seed, edges), "loops": _loops(loops),
        "at_vertices": _numbers(at_vertices), "max_edges": max_edges, "max_diameter": max_diameter,
        "all_but_largest": all_but_largest,
        "include_outer_rim": include_outer_rim, "islands": islands, "mirror": mirror,
        "mirror_plane": None if mirror_plane is None else [float(x) for x in mirror_plane], "stitch": stitch, "auto": auto,
        "turn_around": turn_around, "repair": repair,
        "cut_intersections": cut_intersections, "union": union, "cut_handles": cut_handles, "cut_no_data": cut_no_data,
        "cut_plane": None if cut_plane is None else [float(x) for x in cut_plane],
        "base": None if base is None else f"{base[0]}:{base[1]}" if isinstance(base, tuple) else str(base),
        "bridges": [(int(a), int(b)) for a, b in bridges],
        "drawn_edges": [(int(a), int(b)) for a, b in drawn_edges], "stopped_edges": [int(v) for v in stopped_edges],
        "trim_boundary": trim_boundary, "trim_crossing": trim_crossing, "max_time": max_time, "max_memory": max_memory,
        "keep_partial": keep_partial, "patches_only": patches_only, "threads": threads,
    }
    taken = surface(mesh, faces, colors)
    narrow = taken.colors is not None and np.ndim(taken.colors) == 2 and np.shape(taken.colors)[1] == 3
    with errors_in_python(), shown(progress) as on_progress:
        result = _core.fill(taken.vertices, taken.faces, _rgba(taken.colors), options, on_progress, taken.carried)
    result["holes"] = tuple(_hole(hole) for hole in result["holes"])
    result["trimmed_faces"] = tuple(result["trimmed_faces"])
    if narrow and result["colors"] is not None:
        result["colors"] = np.ascontiguousarray(result["colors"][:, :3])
    return FillResult(**result, _back=taken.back)


def _called(function: Any, mesh: Any, faces: Optional[ArrayLike]) -> Any:
    taken = surface(mesh, faces)
    with errors_in_python():
        return function(taken.vertices, taken.faces)


def check(mesh: Any, faces: Optional[ArrayLike] = None) -> Check:
    """Whether a mesh could be printed: closed, consistently turned, without faces that cut each other, and right side out.

    Parameters:
        mesh, faces: as in fill(). Vertices at exactly the same place count as one.

    Raises:
        InvalidArgument: an array is of another shape.
        KeyboardInterrupt: Ctrl-C.

    Example:
        >>> import loopmend
        >>> scan = loopmend.sample()
        >>> loopmend.check(scan).against_it
        ('6 open boundaries',)
    """
    return Check(**_called(_core.check, mesh, faces))


def boundary_loops(mesh: Any, faces: Optional[ArrayLike] = None) -> List[BoundaryLoop]:
    """The boundary loops of a mesh, by decreasing perimeter. A closed mesh has none.

    Parameters:
        mesh, faces: as in fill().

    Raises:
        InvalidArgument: an array is of another shape, or no face can be used.

    Example:
        >>> import loopmend
        >>> scan = loopmend.sample()
        >>> [(loop.number, loop.kind, loop.edges) for loop in loopmend.boundary_loops(scan)][:2]
        [(1, 'outer rim', 409), (2, 'hole', 81)]
    """
    return [BoundaryLoop(**_loop(figures)) for figures in _called(_core.boundary_loops, mesh, faces)]


def curvatures(mesh: Any, faces: Optional[ArrayLike] = None) -> Curvatures:
    """Mean and Gaussian curvature and the normal at each vertex, from local fits.

    Parameters:
        mesh, faces: as in fill(). Faces that disagree with their neighbours are taken as turned round.

    Returns:
        Curvatures: H (n,) in 1/length, K (n,) in 1/length², normals (n, 3). NaN where no fit is possible and at vertices
        without a face.

    Raises:
        InvalidArgument: an array is of another shape, or no face can be used.
    """
    return Curvatures(**_called(_core.curvatures, mesh, faces))


def read(path: Path, *, weld: bool = False, all_digits: bool = False) -> Mesh:
    """Reads a mesh: PLY, STL, OBJ, OFF, glTF, 3MF or VTK polydata, also compressed with gzip. All of a file, or an error.

    Parameters:
        path: of the file.
        weld: joins vertices at exactly the same place, such as along the seams of a texture. STL is always welded.
        all_digits: keeps all digits of a text PLY that declares single precision (``float``); without it, coordinates are
            the nearest single-precision numbers, as every other reader gets them.

    Raises:
        ReadError: the file is missing, no mesh, malformed or damaged.
    """
    return _read(path, weld, all_digits)


def write(path: Path, mesh: Any, faces: Optional[ArrayLike] = None, *, colors: Optional[ArrayLike] = None,
          ascii: bool = False) -> None:
    """Writes a mesh. The format follows the extension: .ply, .stl, .obj, .off, .glb, .gltf, .3mf, .vtp or .vtk, with .gz after it compressed.

    The file appears when it is complete; what stood there before stays until then. PLY holds float64, OBJ and OFF text with
    17 digits; binary STL and glTF round to float32.

    Parameters:
        path: of the file; its folder must exist.
        mesh, faces: as in fill(). Of a Mesh that read() gave, and of a result made from it or from its path, all that the file
            carried goes along, as `loopmend fill` writes it: attributes, materials, and its texture, which is painted on over the
            patches.
        colors: (n, 3) or (n, 4) uint8, red, green, blue, alpha; None: those of the mesh. STL does not hold them.
        ascii: writes PLY or STL as text.

    Warns:
        UserWarning: a picture or a material file of the scan cannot be used.

    Raises:
        WriteError: an unknown extension, no such folder, no permission, a full disk.
        InvalidArgument: an array is of another shape.
    """
    taken = given(mesh, faces, colors)
    with errors_in_python():
        remarks = _core.write(os.fspath(path), taken.vertices, taken.faces, _rgba(taken.colors), ascii, taken.carried)
    for remark in remarks:
        warnings.warn(in_python(remark), stacklevel=2)


def sample() -> Mesh:
    """The embedded sample: a scan-like relief in millimetres with an outer rim and five holes. The same bits on every call."""
    return Mesh(**_core.sample())


def _patch(figures: Dict[str, Any]) -> PatchResult:
    for name in ("seams_before", "seams_after"):
        figures[name] = tuple(Seam(**seam) for seam in figures[name])
    return PatchResult(**figures)


def blend(
    parts: Sequence[Any],
    *,
    loops: Optional[Sequence[Tuple[int, int]]] = None,
    flow: Flow = "mmcvf",
    boundary: Boundary = "auto",
    continuity: Continuity = "curvature",
    density: float = 1.0,
    mode: Mode = "steady",
    steps: Optional[int] = None,
    sigma: float = 10.0,
    solver: Solver = "auto",
    progress: Optional[OnStep] = None,
) -> PatchResult:
    """Joins boundary loops of one or several meshes by one smooth patch, as `loopmend blend` does.

    Parameters:
        parts: meshes as fill() takes them, or for each its vertices (n, 3) and faces (m, 3). Their vertices and faces come first in the result, part
            after part.
        loops: (part, loop) for each loop to join, both from 1; loops as boundary_loops() numbers them. None: of each part the
            loop that faces the others most; of a single part its two loops.
        flow, boundary, continuity, density, mode, steps, sigma, solver: as in fill().
        progress: called as progress(step, energy) after each accepted step; an exception that it raises stops the work.

    Raises:
        InvalidArgument: no such loop, parts that cut each other, loops that no two-sided surface joins, arrays or options as
            in fill().
        KeyboardInterrupt: Ctrl-C.
    """
    words = "" if loops is None else ",".join(f"{int(part)}:{int(loop)}" for part, loop in loops)
    options = _flow(flow, boundary, continuity, density, mode, steps, sigma, solver)
    taken = [surface(part) for part in parts]
    with errors_in_python():
        return _patch(_core.blend([(part.vertices, part.faces) for part in taken], words, options, progress))


def interpolate(
    mesh: Any,
    faces: Optional[ArrayLike] = None,
    *,
    fixed: Optional[Sequence[int]] = None,
    subdivide: int = 3,
    open: bool = False,
    flow: Flow = "mmcvf",
    boundary: Boundary = "auto",
    continuity: Continuity = "curvature",
    mode: Mode = "steady",
    steps: Optional[int] = None,
    sigma: float = 10.0,
    solver: Solver = "auto",
    progress: Optional[OnStep] = None,
) -> PatchResult:
    """Finds a smooth surface through the vertices of a polyhedron, as `loopmend interpolate` does.

    The vertices that it goes through come first in the result, in their order, bit for bit.

    Parameters:
        mesh, faces: the polyhedron, as in fill().
        fixed: vertex numbers: the surface goes through these alone, at least 4; None: through all.
        subdivide: k, 1 to 8: each face into 4^k.
        open: takes a polyhedron with boundary; its loops become smooth curves through their vertices.
        flow, boundary, continuity, mode, steps, sigma, solver: as in fill().
        progress: called as progress(step, energy) after each accepted step; an exception that it raises stops the work.

    Raises:
        InvalidArgument: a polyhedron that is open, no manifold, or flat; arrays or options out of range.
        KeyboardInterrupt: Ctrl-C.
    """
    options = _flow(flow, boundary, continuity, 1.0, mode, steps, sigma, solver)
    if fixed is not None and len(fixed) == 0:
        raise _core.InvalidArgument("fixed names no vertex; None means all")
    taken = surface(mesh, faces)
    with errors_in_python():
        return _patch(_core.interpolate(taken.vertices, taken.faces, _numbers(fixed) or [], subdivide,
                                        "smooth" if open else "refuse", options, progress))


def evolve(
    mesh: Any,
    faces: Optional[ArrayLike] = None,
    region: Optional[ArrayLike] = None,
    *,
    flow: Flow = "mmcvf",
    boundary: Boundary = "auto",
    continuity: Continuity = "curvature",
    mode: Mode = "steady",
    steps: Optional[int] = None,
    sigma: float = 10.0,
    solver: Solver = "auto",
    progress: Optional[OnStep] = None,
) -> PatchResult:
    """Evolves a region of a mesh with its neighborhood fixed, as `loopmend evolve` does.

    Vertices and faces keep their numbers, and all outside the region are bit-identical. Where the region had to be remeshed
    (`remeshed`), its new vertices come last. A result that is refused is the mesh as it was.

    Parameters:
        mesh, faces: as in fill().
        region: vertex numbers, or (n,) bool, True in the region.
        flow, boundary, continuity, mode, steps, sigma, solver: as in fill(); "none" is no flow here.
        progress: called as progress(step, energy) after each accepted step; an exception that it raises stops the work.

    Raises:
        InvalidArgument: no vertex that could move, a whole component of the surface, arrays or options out of range.
        KeyboardInterrupt: Ctrl-C.
    """
    if region is None:
        raise TypeError("evolve() needs a region: vertex numbers, or one bool for each vertex")
    chosen, taken = np.asarray(region), surface(mesh, faces)
    if chosen.dtype == bool:
        if chosen.shape != (len(taken.vertices),):
            raise _core.InvalidArgument(f"region must have one bool for each of the {len(taken.vertices)} vertices, not the shape "
                                        f"{chosen.shape}")
        chosen = np.flatnonzero(chosen)
    options = _flow(flow, boundary, continuity, 1.0, mode, steps, sigma, solver)
    with errors_in_python():
        return _patch(_core.evolve(taken.vertices, taken.faces, _numbers(chosen) or [], options, progress))
