#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws which folder of engine/ and app/ includes which, from the #include lines of the sources.

Usage: draw_architecture.py            writes architecture.svg beside this file; needs graphviz (dot)
       draw_architecture.py --check    tells whether the graph in architecture.svg is that of the sources; exit code 1 if not

An arrow goes from the folder that includes to the one that is included. Arrows that follow from others are left out. The
graph stands in architecture.svg as a comment, in graphviz's language: that is what --check compares, so that it needs no
graphviz and does not depend on its version.
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PICTURE = Path(__file__).resolve().with_name("architecture.svg")
BEGIN, END = "<!-- The graph:\n", "-->\n"
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)

# Libraries worth a word, in this order; Eigen and the standard library are everywhere.
LIBRARIES = [
    ("OpenMesh", r"OpenMesh/"),
    ("CGAL", r"CGAL/"),
    ("Boost.Geometry", r"boost/geometry"),
    ("SuiteSparse", r"(suitesparse/)?(cholmod|umfpack)|Eigen/(Cholmod|UmfPack)Support"),
    ("oneTBB", r"tbb/"),
    ("Qt", r"Q[A-Z]|Qt[A-Z]"),
    ("VTK", r"vtk|QVTK"),
    ("EGL", r"EGL/"),
    ("QCustomPlot", r"qcustomplot"),
    ("CLI11", r"CLI/"),
    ("nlohmann/json", r"nlohmann/"),
]


def folders_of(house):
    """The folders of engine or app that hold sources, each as "house/folder"."""
    found = {path.relative_to(ROOT).parts[1] for path in sources(ROOT / house) if path.parent != ROOT / house}
    return [f"{house}/{name}" for name in sorted(found)]


def sources(folder):
    return sorted(path for suffix in ("*.h", "*.cpp") for path in folder.rglob(suffix))


def read_includes():
    """Edges {folder: set of folders} and libraries {folder: set of names}; a folder within a folder counts as the outer."""
    folders = folders_of("engine") + folders_of("app")
    place = {}
    for folder in folders:
        name = folder.split("/")[1]
        if name in place:
            sys.exit(f"draw_architecture.py: engine and app both have a folder {name}; an include of it is ambiguous")
        place[name] = folder
    edges, libraries = {}, {}
    for folder in folders:
        texts = [path.read_text(encoding="utf-8") for path in sources(ROOT / folder)]
        included = [name for text in texts for name in INCLUDE.findall(text)]
        edges[folder] = {place[name.split("/")[0]] for name in included if name.split("/")[0] in place} - {folder}
        libraries[folder] = [word for word, pattern in LIBRARIES
                             if any(re.match(pattern, name) for name in included)]
    return edges, libraries


def reachable(edges, start):
    seen, todo = set(), list(edges[start])
    while todo:
        node = todo.pop()
        if node not in seen:
            seen.add(node)
            todo += edges[node]
    return seen


def merge_cycles(edges):
    """Folders that include one another, directly or not, become one node: a tuple of folders. @returns its edges."""
    reach = {node: reachable(edges, node) for node in edges}
    group = {node: tuple(sorted({node} | {other for other in reach[node] if node in reach[other]})) for node in edges}
    merged = {group[node]: set() for node in edges}
    for node, targets in edges.items():
        merged[group[node]] |= {group[target] for target in targets} - {group[node]}
    return merged


def reduce_transitively(edges):
    reach = {node: reachable(edges, node) for node in edges}
    return {node: {target for target in targets if not any(target in reach[other] for other in targets - {target})}
            for node, targets in edges.items()}


def layers_of(edges, nodes):
    """Layers of these nodes alone: 0 includes no other of them, k + 1 includes one of k and none above."""
    layer = {}

    def find(node):
        if node not in layer:
            layer[node] = 1 + max((find(target) for target in edges[node] if target in nodes), default=-1)
        return layer[node]

    for node in nodes:
        find(node)
    return [sorted(node for node in nodes if layer[node] == k) for k in range(1 + max(layer.values()))]


def label_of(node, libraries):
    names = " + ".join(folder.split("/")[1] for folder in node)
    words = [word for word, _ in LIBRARIES if any(word in libraries[folder] for folder in node)]
    small = f'<br/><font point-size="9" color="#555555">{", ".join(words)}</font>' if words else ""
    return f"<{names}{small}>"


def graph_text():
    edges, libraries = read_includes()
    reduced = reduce_transitively(merge_cycles(edges))
    name = {node: "_".join(folder.replace("/", "_") for folder in node) for node in reduced}
    houses = {house: {node for node in reduced if node[0].startswith(house + "/")} for house in ("app", "engine")}
    layers = {house: layers_of(reduced, nodes) for house, nodes in houses.items()}
    lines = ["digraph architecture {",
             '  graph [newrank=true, ranksep=0.42, nodesep=0.28, bgcolor="white", fontname="Helvetica", fontsize=13]',
             '  node [shape=box, style="rounded,filled", fontname="Helvetica", fontsize=12, margin="0.12,0.05"]',
             '  edge [color="#555555", arrowsize=0.6]']
    for house, place, color, ground in (("app", "t", "#dbe8f6", "#f5f9fd"), ("engine", "b", "#e3efda", "#f8fbf5")):
        lines += [f"  subgraph cluster_{house} {{",
                  f'    graph [label="{house}", labeljust=l, labelloc={place}, style=filled, color="{ground}"]']
        for layer in reversed(layers[house]):
            for node in layer:
                lines.append(f'    {name[node]} [label={label_of(node, libraries)}, fillcolor="{color}", color="#888888"]')
            lines.append("    {rank=same; " + "; ".join(name[node] for node in layer) + "}")
        lines.append("  }")
    for node in sorted(reduced):
        lines += [f"  {name[node]} -> {name[target]}" for target in sorted(reduced[node])]
    # All of app stands above all of engine.
    lines += [f"  {name[low]} -> {name[high]} [style=invis]" for low in layers["app"][0] for high in layers["engine"][-1]
              if high not in reduced[low]]
    return "\n".join(lines + ["}"]) + "\n"


def drawn_graph():
    """The graph in the comment of the picture; empty where there is none."""
    if not PICTURE.exists():
        return ""
    text = PICTURE.read_text(encoding="utf-8")
    begin = text.find(BEGIN)
    return text[begin + len(BEGIN):text.find(END, begin)] if begin >= 0 else ""


def draw(graph):
    svg = subprocess.run(["dot", "-Tsvg"], input=graph, capture_output=True, text=True, check=True).stdout
    svg = re.sub(r"<!--.*?-->\n?", "", svg, flags=re.DOTALL)  # graphviz's version, and a name for every part
    begin = svg.index("<svg")
    PICTURE.write_text(svg[:begin] + BEGIN + graph + END + svg[begin:], encoding="utf-8")


def main(arguments):
    graph = graph_text()
    if "--" in graph:
        sys.exit("draw_architecture.py: the graph holds two hyphens in a row, which no comment in XML may hold")
    if arguments == ["--check"]:
        if drawn_graph() == graph:
            return 0
        was, now = set(drawn_graph().splitlines()), set(graph.splitlines())
        print("docs/dev/architecture.svg is out of date; run docs/dev/draw_architecture.py. Lines of the graph that differ:")
        for mark, lines in (("-", was - now), ("+", now - was)):
            print("".join(f"  {mark} {line.strip()}\n" for line in sorted(lines)), end="")
        return 1
    if arguments:
        print(__doc__.strip())
        return 2
    draw(graph)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
