#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Leaves out of VTK's sources the classes that no program here can reach, in the modules where they are most of the work.

Usage: packaging/windows/leave_out_classes.py VTK SOURCES...
A class stays where a file of SOURCES includes its header, where it stands in for another at run time (overrides), or where a file of one that stays
includes it. Each module keeps one class at least. Safe to repeat.
"""
import pathlib
import re
import sys

SHORTENED = ("Common/Color", "Common/ComputationalGeometry", "Filters/Core", "Filters/General", "Filters/Geometry", "Filters/Sources",
             "GUISupport/Qt", "IO/Image", "Imaging/Color", "Imaging/Core", "Rendering/Core", "Rendering/OpenGL2")
WHOLE = ("Interaction/Style", "Rendering/FreeType", "Rendering/UI")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)', re.MULTILINE)
CLASS = re.compile(r"^\s*([A-Za-z]\w*)(\)?)\s*(?:#.*)?$")


def included(path):
    return {pathlib.Path(name).name for name in INCLUDE.findall(path.read_text(errors="replace"))}


def classes_of(module):
    for line in (module / "CMakeLists.txt").read_text().splitlines():
        name = CLASS.match(line)
        if name and (module / (name[1] + ".cxx")).exists():
            yield name[1]


def reached(files, roots):
    todo, seen = list(roots), set()
    while todo:
        name = todo.pop()
        if name in seen or name not in files:
            continue
        seen.add(name)
        todo += included(files[name])
        if name.endswith(".h"):
            todo.append(name[:-2] + ".cxx")
    return seen


def overriding(module):
    """Classes that the factory of the module makes on Windows."""
    text = (module / "CMakeLists.txt").read_text()
    yield from re.findall(r"OVERRIDE (vtk(?:Win32|Dummy)\w+)", text)
    for block in re.findall(r"set\(opengl_overrides\s+([^)]*)\)", text):
        yield from ("vtkOpenGL" + word for word in block.split())


def shorten(module, kept):
    lines = []
    for line in (module / "CMakeLists.txt").read_text().splitlines():
        name = CLASS.match(line)
        if name and (module / (name[1] + ".cxx")).exists() and name[1] + ".cxx" not in kept:
            line = name[2]
            if not line:
                continue
        lines.append(line)
    (module / "CMakeLists.txt").write_text("\n".join(lines) + "\n")


def main(vtk, *sources):
    vtk = pathlib.Path(vtk)
    every = [path.parent for path in vtk.glob("*/*/vtk.module")]
    modules = [vtk / name for name in SHORTENED + WHOLE]
    files = {path.name: path for module in every for path in module.iterdir() if path.suffix in (".h", ".cxx", ".txx")}
    roots = {"vtkStringOutputWindow.h"}
    for source in sources:
        for path in pathlib.Path(source).rglob("*"):
            if path.suffix in (".h", ".cpp"):
                roots |= included(path)
    whole = [module for module in modules if str(module.relative_to(vtk)) in WHOLE]
    for module in whole:
        roots |= {name + ".cxx" for name in classes_of(module)}
    for module in modules:
        roots |= {name + ".h" for name in overriding(module)}
    for module in modules:
        kept = reached(files, roots)
        names = list(classes_of(module))
        if names and not any(name + ".cxx" in kept for name in names):
            roots.add(names[0] + ".h")
    kept = reached(files, roots)
    for module in modules:
        if module not in whole:
            shorten(module, kept)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
