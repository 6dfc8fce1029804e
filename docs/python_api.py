#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the page of the Python functions and classes from their docstrings, without importing them.

Usage: python_api.py PACKAGE_FOLDER OUTPUT
"""
import ast
import pathlib
import re
import sys

HEAD = """# Python reference

This page lists the functions and classes of the Python module, as `help(loopmend)` does. [Python](python.md) shows how they are used.
`Path` is a `str` or an `os.PathLike`. Lengths are in the unit of the mesh.
"""
SECTION = re.compile(r"(Parameters|Returns|Raises|Warns|Example):$")
ENTRY = re.compile(r"([A-Za-z_][\w, ]*): (.*)$")


def definitions(folder):
    """Functions and classes by name."""
    found = {}
    for path in sorted(folder.glob("*.py")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
                found[node.name] = node
    return found


def public_names(folder):
    for node in ast.parse((folder / "__init__.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return ast.literal_eval(node.value)
    raise SystemExit("python_api: __init__.py has no __all__")


def list_of(lines):
    """"name: what it is" with lines that go on further in, as a list."""
    out, margin = [], None
    for line in lines:
        match = ENTRY.match(line.strip())
        indent = len(line) - len(line.lstrip())
        if match and (margin is None or indent <= margin):
            margin = indent if margin is None else margin
            out.append(f"- `{match[1]}`: {match[2]}")
        elif line.strip():
            out.append(("  " if out else "") + line.strip())
    return out


def escaped(line):
    return line.replace("<", "&lt;").replace("``", "`")


def markdown_of(docstring, level):
    """The docstring with its sections as headings, its lists as lists, its examples as code."""
    out, kind, block = [], None, []

    def close():
        text = [line for line in block if line.strip()] if kind != "Example" else block
        if kind == "Example":
            out.extend(["```pycon", *(line.strip() for line in text if line.strip()), "```", ""])
        elif kind:
            out.extend([*map(escaped, list_of(text)), ""])
        block.clear()

    lines = docstring.splitlines()
    for k, line in enumerate(lines):
        if match := SECTION.match(line.strip()):
            close()
            kind = match[1]
            out += [f"**{kind}**", ""]
        elif kind and line.strip() and not line.startswith(" "):
            close()
            kind = None
            out.append(escaped(line))
        elif kind:
            block.append(line)
        elif ENTRY.match(line) and level == 3:  # the fields of a class
            fields = [one for one in lines[k:]]
            out += ["", *map(escaped, list_of(fields)), ""]
            break
        else:
            out.append(escaped(line))
    close()
    return "\n".join(out).strip() + "\n"


def signature(node):
    arguments = ast.unparse(node.args)
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    text = f"{node.name}({arguments}){returns}"
    if len(text) > 100:
        text = re.sub(r", (?=\w+:|\*,|\*\*)", ",\n    ", text)
    return f"```python\n{text}\n```\n"


def members(node):
    for child in node.body:
        if isinstance(child, ast.FunctionDef) and not child.name.startswith("_"):
            is_property = any(getattr(d, "id", "") == "property" for d in child.decorator_list)
            name = child.name if is_property else child.name + "(" + ast.unparse(child.args).replace("self, ", "").replace("self", "") + ")"
            yield f"- `.{name}`: {escaped(' '.join(ast.get_docstring(child).split()))}"


def page(folder):
    known = definitions(folder)
    names = [name for name in public_names(folder) if name in known]
    missing = [name for name in names if not ast.get_docstring(known[name])]
    if missing:
        raise SystemExit(f"python_api: no docstring: {', '.join(missing)}")
    out = [HEAD, "## Functions\n"]
    for name in (n for n in names if isinstance(known[n], ast.FunctionDef)):
        out += [f"### {name}()\n", signature(known[name]), markdown_of(ast.get_docstring(known[name]), 2)]
    out.append("## Classes\n")
    for name in (n for n in names if isinstance(known[n], ast.ClassDef)):
        out += [f"### {name}\n", markdown_of(ast.get_docstring(known[name]), 3)]
        if listed := list(members(known[name])):
            out += ["Methods and properties:\n", "\n".join(listed) + "\n"]
    out.append("## Errors\n\n`Error` is the base of `InvalidArgument`, which is a `ValueError`, and of `ReadError` and `WriteError`, "
               "which are `OSError`s.\n")
    return "\n".join(out)


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    pathlib.Path(sys.argv[2]).write_text(page(pathlib.Path(sys.argv[1])), encoding="utf-8")


if __name__ == "__main__":
    main()
