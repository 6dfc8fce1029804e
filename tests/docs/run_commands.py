#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of the documentation as a reader would.

Usage: run_commands.py BIN_FOLDER PAGE...

Each line of a block marked `sh` is run by bash, page by page, in a folder of its own that holds the files which the
page names in a comment such as `<!-- needs: scan.ply left.ply -->`. A line that ends in `# exits with N` must exit with N,
any other with 0. A block marked `text` right after it shows lines of what the commands printed, in their order: `…` alone
stands for any lines, at the end of a line for its rest. Times may differ, and numbers with a fraction a little. Blocks
marked `console` are for a reader's machine (installing, opening a window) and are not run.
"""
import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "docs/user/pictures"))
import make_cases  # noqa: E402, the models of the page "Which option for my case"


def off(points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, p)) for p in points]
    lines += [f"{len(f)} " + " ".join(map(str, f)) for f in faces]
    return "\n".join(lines) + "\n"


def dodecahedron():
    """A regular dodecahedron as OFF."""
    g = (1 + 5**0.5) / 2
    points = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    points += [p for s in (-1, 1) for t in (-1, 1) for p in ((0, s / g, t * g), (s / g, t * g, 0), (t * g, 0, s / g))]
    normals = [p for s in (-1, 1) for t in (-1, 1) for p in ((0, s * g, t), (s * g, t, 0), (t, 0, s * g))]

    def dot(a, b):
        return sum(x * y for x, y in zip(a, b))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    faces = []
    for n in normals:
        best = max(dot(p, n) for p in points)
        ring = [i for i, p in enumerate(points) if dot(p, n) > best - 1e-9]
        center = tuple(sum(points[i][k] for i in ring) / 5 for k in range(3))
        u = tuple(points[ring[0]][k] - center[k] for k in range(3))
        v = cross(n, u)
        ring.sort(key=lambda i: math.atan2(
            dot(tuple(points[i][k] - center[k] for k in range(3)), v) / dot(v, v)**0.5,
            dot(tuple(points[i][k] - center[k] for k in range(3)), u) / dot(u, u)**0.5))
        faces.append(ring)
    return off(points, faces)


def tube(begin, end, around=32, along=16):
    """An open cylinder of radius 1 round the x axis, its outside facing out, as OFF."""
    points, faces = [], []
    for i in range(along + 1):
        x = begin + (end - begin) * i / along
        for j in range(around):
            a = 2 * math.pi * j / around
            points.append((x, math.cos(a), math.sin(a)))
    for i in range(along):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            faces += [(a, b, b + around), (a, b + around, a + around)]
    return off(points, faces)


def terrain(across=60):
    """A sheet with a hill, as OFF."""
    points = [(i / across, j / across, 0.8 * math.exp(-8 * ((i / across - 0.5)**2 + (j / across - 0.5)**2)))
              for j in range(across + 1) for i in range(across + 1)]
    faces = []
    for j in range(across):
        for i in range(across):
            a = j * (across + 1) + i
            faces += [(a, a + 1, a + across + 2), (a, a + across + 2, a + across + 1)]
    return off(points, faces)


def make_file(name, folder, run):
    """The files that a page may need; the tubes and the terrain are made from OFF by the program itself."""
    if name == "scan.ply":
        return run("loopmend sample -o scan.ply")
    if name in make_cases.MODELS:
        return make_cases.write_ply(folder / name, *make_cases.MODELS[name]())
    if name == "dodecahedron.off":
        return (folder / name).write_text(dodecahedron())
    texts = {"left.ply": tube(-4, -1), "right.ply": tube(1, 4), "terrain.ply": terrain()}
    if name not in texts:
        raise SystemExit(f"no recipe for {name}")
    (folder / "made.off").write_text(texts[name])
    run(f"loopmend fill made.off -o {name} --quiet --max-edges 3 || true")
    (folder / "made.off").unlink()


def same_word(shown, printed):
    """Numbers with a fraction may differ by a hundredth, or one in the last digit: processors round differently."""
    try:
        a, b = float(shown), float(printed)
    except ValueError:
        return shown == printed
    digits = re.fullmatch(r"-?\d+\.(\d+)", shown)
    last_digit = 1.01 * 10.0**-len(digits[1]) if digits else 0
    return shown == printed or ("." in shown and abs(a - b) <= max(1e-6, 0.01 * abs(a), last_digit))


def same_line(shown, printed):
    """Whether a line of a block marked `text` is one that was printed; spaces do not count, and any time will do."""
    words, others = ([word.rstrip(",;") for word in re.sub(r"\b[\d.]+ s\b", "TIME", line).split()]
                     for line in (shown, printed))
    if shown.endswith("…"):
        words = re.sub(r"…$", "", " ".join(words)).split()
        others = others[:len(words)]
    return len(words) == len(others) and all(map(same_word, words, others))


def missing_line(text, printed):
    """The first line of a block marked `text` that was not printed after the lines before it; None if all were."""
    rest = printed.splitlines()
    for line in text.splitlines():
        if line.strip() in ("", "…"):
            continue
        while rest and not same_line(line, rest[0]):
            rest.pop(0)
        if not rest:
            return line
        rest.pop(0)
    return None


def main():
    programs, pages = Path(sys.argv[1]).resolve(), [Path(p).resolve() for p in sys.argv[2:]]
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", QT_QPA_PLATFORM="offscreen")
    wrong = ran = 0
    for page in pages:
        text = page.read_text()
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)

            def run(line):
                return subprocess.run(["bash", "-c", line], cwd=folder, env=environment, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, text=True, timeout=120, stdin=subprocess.DEVNULL)

            for needs in re.findall(r"<!-- needs: ([^>]*) -->", text):
                for needed in needs.split():
                    make_file(needed, folder, run)
                    if not (folder / needed).exists():
                        raise SystemExit(f"{page.name}: {needed} could not be made")
            for block, shown in re.findall(r"^```sh\n(.*?)^```$(?:\n\n```text\n(.*?)^```$)?", text, re.M | re.S):
                printed = ""
                for line in re.sub(r"\\\n\s*", " ", block).splitlines():
                    if not line.strip() or line.lstrip().startswith("#"):
                        continue
                    said = re.search(r"# exits with (\d+)\s*$", line)
                    wanted, result = int(said.group(1)) if said else 0, run(line)
                    ran += 1
                    printed += result.stdout
                    if result.returncode != wanted:
                        wrong += 1
                        print(f"{page.name}: exit code {result.returncode}, not {wanted}: {line}\n{result.stdout}")
                line = missing_line(shown, printed)
                if line is not None:
                    wrong += 1
                    print(f"{page.name}: not printed: {line}\nThe commands printed:\n{printed}")
    print(f"{ran} commands of {len(pages)} pages, {wrong} wrong")
    return 1 if wrong or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
