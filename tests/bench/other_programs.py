#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts holes into whole models and fills them by Loopmend and by other programs: which comes closest to what was cut away?

Needs, in a virtual environment: numpy, scipy, trimesh, open3d, meshlib, pymeshlab, pymeshfix, pyvista, cgal (all from PyPI). They are used for
measuring only.

Usage: other_programs.py PROGRAM --at edges|anywhere --count N --seed S --csv FILE MODEL...
       other_programs.py --table FILE      prints the tables of a CSV

At edges: the center of each hole is the end of an edge that bends by more than 30°. Anywhere: any vertex, and Loopmend fills with
`--mirror`, too. A hole is a disc of 8 to 300 boundary edges, at least six rings from any boundary. The distance is two-sided, rms: points of
what was cut away from the filled mesh, and points of the new faces from the whole model. It is given in diameters of the hole;
distances below 1e-5 count as that. A program that fails, or leaves the hole open, counts as not filled.
"""
import argparse
import csv
import math
import multiprocessing
import os
import subprocess
import tempfile
from pathlib import Path

FLOOR = 1e-5
LIMIT_S = 60
SAMPLES = 4000
MOST_EDGES = 300


def write_ply(path, points, faces):
    import numpy as np
    with open(path, "wb") as out:
        out.write((f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\n"
                   f"property double z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n").encode())
        out.write(np.ascontiguousarray(points, "<f8").tobytes())
        rows = np.empty(len(faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
        rows["n"], rows["v"] = 3, faces
        out.write(rows.tobytes())


# ---- the programs: vertices and faces in, vertices and faces out ----

def by_meshlib(points, faces):
    """fillHoleNicely: triangulated by the universal metric, subdivided, smoothed in curvature."""
    import meshlib.mrmeshnumpy as mn
    import meshlib.mrmeshpy as mm
    mesh = mn.meshFromFacesVerts(faces, points)
    for edge in mesh.topology.findHoleRepresentiveEdges():
        settings = mm.FillHoleNicelySettings()
        settings.triangulateParams.metric = mm.getUniversalMetric(mesh)
        settings.subdivideSettings.maxEdgeLen = float(mesh.averageEdgeLength())
        settings.subdivideSettings.maxEdgeSplits = 20000
        settings.smoothCurvature = True
        mm.fillHoleNicely(mesh, edge, settings)
    mesh.pack()
    return mn.getNumpyVerts(mesh), mn.getNumpyFaces(mesh.topology)


def by_cgal(points, faces, continuity):
    """triangulate_refine_and_fair_hole."""
    import numpy as np
    from CGAL import CGAL_Polygon_mesh_processing as processing
    from CGAL.CGAL_Kernel import Point_3
    from CGAL.CGAL_Polyhedron_3 import Polyhedron_3
    mesh = Polyhedron_3()
    soup = processing.Point_3_Vector()
    for p in points:
        soup.append(Point_3(*map(float, p)))
    polygons = processing.Polygon_Vector()
    for f in faces:
        polygon = processing.Int_Vector()
        for v in f:
            polygon.append(int(v))
        polygons.append(polygon)
    processing.polygon_soup_to_polygon_mesh(soup, polygons, mesh)
    holes, seen = [], set()
    for h in mesh.halfedges():
        if not h.is_border():
            continue
        place = h.vertex().point()
        if (place.x(), place.y(), place.z()) in seen:
            continue
        around, k = [], h
        while not around or k != h:
            around.append((k.vertex().point().x(), k.vertex().point().y(), k.vertex().point().z()))
            k = k.next()
        seen.update(around)
        if len(around) <= MOST_EDGES:
            holes.append(h)
    for h in holes:
        processing.triangulate_refine_and_fair_hole(mesh, h, [], [], math.sqrt(2), continuity)
    number, places, corners = {}, [], []
    for f in mesh.facets():
        h, corner = f.halfedge(), []
        for _ in range(3):
            p = h.vertex().point()
            place = (p.x(), p.y(), p.z())
            if place not in number:
                number[place] = len(places)
                places.append(place)
            corner.append(number[place])
            h = h.next()
        corners.append(corner)
    return np.array(places), np.array(corners)


def by_pymeshlab(points, faces):
    """MeshLab's filter Close Holes."""
    import pymeshlab
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(points, faces))
    meshes.meshing_close_holes(maxholesize=1000, refinehole=True)
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix()


def by_pymeshfix(points, faces):
    import pymeshfix
    fix = pymeshfix.PyTMesh()
    fix.load_array(points, faces)
    fix.fill_small_boundaries(refine=True)
    return fix.return_arrays()


def by_vtk(points, faces):
    import numpy as np
    import pyvista
    mesh = pyvista.PolyData(points, np.column_stack([np.full(len(faces), 3), faces]).ravel())
    filled = mesh.fill_holes(float(mesh.length))
    return np.array(filled.points), filled.faces.reshape(-1, 4)[:, 1:]


def by_open3d(points, faces):
    import numpy as np
    import open3d
    mesh = open3d.t.geometry.TriangleMesh(open3d.core.Tensor(points), open3d.core.Tensor(np.asarray(faces, dtype=np.int64)))
    filled = mesh.fill_holes(float(np.ptp(points, axis=0).max()) * 10)
    return np.array(filled.vertex.positions.numpy()), np.array(filled.triangle.indices.numpy())  # else views of what is freed here


OTHERS = {
    "MeshLib": by_meshlib,
    "CGAL C1": lambda p, f: by_cgal(p, f, 1),
    "CGAL C2": lambda p, f: by_cgal(p, f, 2),
    "MeshLab": by_pymeshlab,
    "MeshFix": by_pymeshfix,
    "VTK": by_vtk,
    "Open3D": by_open3d,
}


def work(name, points, faces, target):
    import numpy as np
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)
    p, f = OTHERS[name](points, faces)
    np.savez(target, p=np.asarray(p, dtype=float), f=np.asarray(f, dtype=int))


def guarded(name, points, faces):
    """One of OTHERS in a new process: some of them end the process, or do not end. A fork of this one has no threads, and they wait for them."""
    import numpy as np
    with tempfile.TemporaryDirectory() as folder:
        target = os.path.join(folder, "out.npz")
        process = multiprocessing.get_context("spawn").Process(target=work, args=(name, points, faces, target))
        process.start()
        process.join(LIMIT_S)
        if process.is_alive():
            process.kill()
            process.join()
        if not os.path.exists(target):
            return None
        data = np.load(target)
        return (data["p"], data["f"]) if len(data["f"]) and np.isfinite(data["p"]).all() else None


def alone(function, *given):
    """The number that the function returns, from a process of its own: threads of a library do not survive a fork of this one."""
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    process = context.Process(target=lambda: queue.put(function(*given)))
    process.start()
    try:
        return queue.get(timeout=LIMIT_S)
    finally:
        process.join(1)
        process.kill()


def by_loopmend(program, points, faces, options):
    import trimesh
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "in.ply", Path(folder) / "out.ply"
        write_ply(source, points, faces)
        try:
            subprocess.run([program, "fill", source, "-o", target, "--quiet", "--threads", "1", *options], timeout=LIMIT_S,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return None
        if not target.exists():
            return None
        mesh = trimesh.load(target, process=False)
        return mesh.vertices.view(), mesh.faces.view()


# ---- holes ----

def load(path):
    import trimesh
    mesh = trimesh.load(path, force="mesh", process=True)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    mesh.update_faces(mesh.nondegenerate_faces())
    mesh.update_faces(mesh.unique_faces())
    parts = mesh.split(only_watertight=False, repair=False)
    return max(parts, key=lambda part: len(part.faces)) if len(parts) > 1 else mesh


def boundary(faces):
    """Directed boundary edges, from corner to corner."""
    import numpy as np
    edges = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    _, index, count = np.unique(np.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    return edges[index[count == 1]], count.max()


def make_hole(mesh, centers, chance, near_boundary):
    """Faces that a disc takes away, or nothing."""
    import numpy as np
    h = mesh.edges_unique_length.mean()
    edges = 8 * (MOST_EDGES / 8)**chance.random()
    radius = edges * h / (2 * math.pi)
    if radius > 0.3 * mesh.extents.max():
        return None
    center = chance.choice(centers)
    inside = np.linalg.norm(mesh.triangles_center - mesh.vertices[center], axis=1) < radius
    if not inside.any():
        return None
    import trimesh
    pairs = mesh.face_adjacency[inside[mesh.face_adjacency].all(axis=1)]
    seeds = np.flatnonzero(inside & (mesh.faces == center).any(axis=1))
    if len(seeds) == 0:
        return None
    for part in trimesh.graph.connected_components(pairs, nodes=np.flatnonzero(inside)):
        if seeds[0] in part:
            removed = np.zeros(len(mesh.faces), bool)
            removed[part] = True
            break
    gone = mesh.faces[removed]
    if near_boundary[gone].any():
        return None
    rim, most = boundary(gone)
    if most > 2 or len(np.unique(rim[:, 0])) != len(rim) or not 8 <= len(rim) <= MOST_EDGES:
        return None
    vertices = np.unique(gone)
    undirected = len(np.unique(np.sort(np.vstack([gone[:, [0, 1]], gone[:, [1, 2]], gone[:, [2, 0]]]), axis=1), axis=0))
    if len(vertices) - undirected + len(gone) != 1 or len(vertices) == len(rim) or len(vertices) - len(rim) > 0.37 * len(rim)**2:
        return None
    left = trimesh.graph.connected_components(mesh.face_adjacency[~removed[mesh.face_adjacency].any(axis=1)], nodes=np.flatnonzero(~removed))
    return (removed, rim) if len(left) == 1 else None


def sampled(points, faces, chance):
    import numpy as np
    a, b, c = (points[faces[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    if not area.sum() > 0:
        return None
    pick = chance.choice(len(faces), SAMPLES, p=area / area.sum())
    u, v = chance.random(SAMPLES), chance.random(SAMPLES)
    flip = u + v > 1
    u[flip], v[flip] = 1 - u[flip], 1 - v[flip]
    return a[pick] + u[:, None] * (b[pick] - a[pick]) + v[:, None] * (c[pick] - a[pick])


def scene_of(points, faces):
    import numpy as np
    import open3d
    scene = open3d.t.geometry.RaycastingScene()
    scene.add_triangles(open3d.core.Tensor(points.astype(np.float32)), open3d.core.Tensor(faces.astype(np.uint32)))
    return lambda q: scene.compute_distance(open3d.core.Tensor(q.astype(np.float32))).numpy()


def distance(mesh, removed, rim, filled, chance):
    """Two-sided rms distance in diameters; nothing where the hole is still open."""
    import numpy as np
    from scipy.spatial import cKDTree
    from scipy.spatial.distance import pdist
    loop = mesh.vertices[np.unique(rim)]
    diameter, middle = pdist(loop).max(), loop.mean(axis=0)
    points = (filled[0] - middle) / diameter
    faces = filled[1][(np.abs(points[filled[1]]) < 3).all(axis=(1, 2))]
    truth = (mesh.vertices - middle) / diameter
    gone, kept = mesh.faces[removed], mesh.faces[~removed]
    kept = kept[(np.abs(truth[kept]) < 4).all(axis=(1, 2))]
    if len(faces) == 0:
        return None
    # The hole counts as open where a boundary edge of what was written lies at the loop.
    _, first = np.unique(np.round(points, 7), axis=0, return_inverse=True)
    rest, _ = boundary(first.reshape(-1)[faces])
    place = np.empty((first.max() + 1, 3))
    place[first.reshape(-1)] = points
    near = cKDTree((loop - middle) / diameter)
    if len(rest) and (near.query(place[rest[:, 0]])[0] < 1e-6).any():
        return None
    to_kept = scene_of(truth, kept)
    centers = points[faces].mean(axis=1)
    corner = np.maximum.reduce([to_kept(points[faces[:, k]]) for k in range(3)])
    new = faces[(to_kept(centers) > 2e-6) | (corner > 2e-6)]
    new = new[np.linalg.norm(points[new].mean(axis=1), axis=1) < 2.5]
    away = sampled(truth, gone, chance)
    one = scene_of(points, faces)(away)
    other = []
    if len(new):
        other = scene_of(truth, np.vstack([gone, kept]))(sampled(points, new, chance))
    both = [np.mean(np.square(side)) for side in (one, other) if len(side)]
    return math.sqrt(np.mean(both))


def centers_of(mesh, at):
    import numpy as np
    if at == "anywhere":
        return np.arange(len(mesh.vertices))
    return np.unique(mesh.face_adjacency_edges[mesh.face_adjacency_angles > math.pi / 6])


def run(arguments):
    import numpy as np
    rows = []
    with open(arguments.csv, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["hole", "model", "edges", "method", "d"])
        for path in arguments.models:
            name = Path(path).stem
            mesh = load(path)
            centers = centers_of(mesh, arguments.at)
            near = np.zeros(len(mesh.vertices), bool)
            edge, _ = boundary(mesh.faces)
            near[edge.ravel()] = True
            for _ in range(6):
                near[mesh.faces[near[mesh.faces].any(axis=1)].ravel()] = True
            if len(centers) == 0:
                continue
            for k in range(arguments.count):
                chance = np.random.default_rng([arguments.seed, k, *name.encode()])
                hole = next((h for h in (make_hole(mesh, centers, chance, near) for _ in range(200)) if h), None)
                if hole is None:
                    continue
                removed, rim = hole
                kept = mesh.faces[~removed]
                used = np.unique(kept)
                number = np.full(len(mesh.vertices), -1)
                number[used] = np.arange(len(used))
                points, faces = np.array(mesh.vertices[used]), number[kept].astype(np.int32)
                results = {"Loopmend": by_loopmend(arguments.program, points, faces, [])}
                if arguments.at == "anywhere":
                    results["Loopmend --mirror"] = by_loopmend(arguments.program, points, faces, ["--mirror"])
                for other in OTHERS:
                    results[other] = guarded(other, points, faces)
                line = []
                for method, filled in results.items():
                    d = None if filled is None else alone(distance, mesh, removed, rim, filled, np.random.default_rng(5))
                    out.writerow([f"{name} {k}", name, len(rim), method, "-" if d is None else f"{d:.4g}"])
                    line.append(f"{method} {'-' if d is None else f'{d:.3g}'}")
                file.flush()
                print(f"{name} {k}: {len(rim)} edges; " + ", ".join(line), flush=True)
    return rows


def table(path):
    holes = {}
    for row in csv.DictReader(open(path, encoding="utf-8")):
        holes.setdefault(row["hole"], {"model": row["model"]})[row["method"]] = None if row["d"] == "-" else max(float(row["d"]), FLOOR)
    others = [m for m in OTHERS if any(m in h for h in holes.values())]
    ours = "Loopmend --mirror" if any("Loopmend --mirror" in h for h in holes.values()) else "Loopmend"

    def mean(values):
        values = list(values)
        return math.exp(sum(map(math.log, values)) / len(values)) if values else float("nan")
    print("| method | filled | rms distance, geometric mean | divided by the best other, geometric mean | farther by 10 % |")
    print("| --- | ---: | ---: | ---: | ---: |")
    chosen = [h for h in holes.values() if h.get(ours)]
    for method in dict.fromkeys(["Loopmend", ours, *others]):
        both = [(h[method], min((h[o] for o in others if o != method and h.get(o)), default=None)) for h in chosen if h.get(method)]
        both = [(d, best) for d, best in both if best]
        print(f"| {method} | {sum(bool(h.get(method)) for h in holes.values())} of {len(holes)} | {mean(d for d, _ in both):.4f} | {mean(d / best for d, best in both):.2f} "
              f"| {sum(d > 1.1 * best for d, best in both)} |")
    print("\n| model | holes | Loopmend, divided by the best other | by MeshLib | farther than the best by 10 % |")
    print("| --- | ---: | ---: | ---: | ---: |")
    for model in [*dict.fromkeys(h["model"] for h in holes.values()), "all"]:
        group = [h for h in chosen if model in (h["model"], "all")]
        best = [h[ours] / min(h[o] for o in others if h.get(o)) for h in group]
        lib = [h[ours] / h["MeshLib"] for h in group if h.get("MeshLib")]
        print(f"| {model} | {len(group)} | {mean(best):.2f} | {mean(lib):.2f} | {sum(r > 1.1 for r in best)} |")
    if ours != "Loopmend":
        copied = [h for h in chosen if abs(h[ours] / h["Loopmend"] - 1) > 1e-3]
        print(f"\nCopied: {len(copied)}; copy / default {mean(h[ours] / h['Loopmend'] for h in copied):.2f}; copy / best other "
              f"{mean(h[ours] / min(h[o] for o in others if h.get(o)) for h in copied):.2f}; copy / MeshLib "
              f"{mean(h[ours] / h['MeshLib'] for h in copied if h.get('MeshLib')):.2f}; farther than the best other by 10 %: "
              f"{sum(h[ours] > 1.1 * min(h[o] for o in others if h.get(o)) for h in copied)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?")
    parser.add_argument("models", nargs="*")
    parser.add_argument("--at", choices=["edges", "anywhere"], default="edges")
    parser.add_argument("--count", type=int, default=16)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--csv", default="other_programs.csv")
    parser.add_argument("--table")
    arguments = parser.parse_intermixed_args()
    if arguments.table:
        return table(arguments.table)
    if not arguments.program or not arguments.models:
        parser.error("name the program and the models")
    run(arguments)
    table(arguments.csv)


if __name__ == "__main__":
    main()
