#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `loopmend batch` in a browser without a window: clicks on headers and pictures, and chooses rows.

Usage: batch_page.py LOOPMEND
Exit code: 0 all well, 1 something is not, 77 there is no Chromium (Debian: chromium), or it cannot start.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ACTIONS = """<script>
const names = () => [...document.querySelectorAll('tbody tr')].filter(row => !row.hidden).map(row => row.cells[1].querySelector('b').textContent);
const click = word => [...document.querySelectorAll('th button')].find(button => button.textContent === word).click();
const choose = (name, value) => { const field = document.querySelector(`form [name=${name}]`); field.value = value;
  field.dispatchEvent(new Event('input', {bubbles: true})); };
const seen = {first: names()};
click('faces'); seen.faces = names();
click('faces'); seen.faces_down = names();
seen.arrow = document.querySelector('th[aria-sort]').getAttribute('aria-sort');
click('status'); seen.status = names();
choose('status', 'nothing'); seen.nothing = names();
choose('status', ''); choose('word', 'DOES NOT BEGIN'); seen.word = names();
choose('word', ''); seen.all = names();
const picture = document.querySelector('tbody img'), small = getComputedStyle(picture).width;
picture.click(); seen.widths = [small, getComputedStyle(picture).width, picture.naturalWidth];
document.body.innerHTML = '<pre id=seen>' + JSON.stringify(seen) + '</pre>';
</script></body>"""


def ball(size):
    """A tetrahedron, subdivided, without one face: its lines for OFF."""
    points, faces = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
    for _ in range(size):
        number, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in number:
                p = [points[a][k] + points[b][k] for k in range(3)]
                length = sum(x * x for x in p) ** 0.5 / 3**0.5
                number[key] = len(points)
                points.append(tuple(x / length for x in p))
            return number[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    lines = [f"OFF\n{len(points)} {len(faces) - 1} 0"] + ["%r %r %r" % p for p in points] + ["3 %d %d %d" % f for f in faces[1:]]
    return "\n".join(lines) + "\n"


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if not browser:
        print("skipped: there is no Chromium (Debian: chromium)")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "scans").mkdir()
        for name, size in (("b.off", 2), ("c.off", 4), ("a.off", 3)):
            (work / "scans" / name).write_text(ball(size))
        (work / "scans/sheet.off").write_text("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n")
        (work / "scans/notes.ply").write_text("This is not a mesh.\n")
        subprocess.run([program, "batch", "scans", "-o", "results", "--fail-on", "never", "--quiet"], cwd=work, check=True,
                       stderr=subprocess.DEVNULL)
        page = (work / "results/summary.html").read_text(encoding="utf-8")
        assert page.count("</body>") == 1
        (work / "page.html").write_text(page.replace("</body>", ACTIONS), encoding="utf-8")
        done = subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1600,900", "--virtual-time-budget=2000",
                               f"--user-data-dir={work}/profile", "--dump-dom", f"file://{work}/page.html"],
                              capture_output=True, text=True, timeout=120, check=False)
        found = re.search(r'<pre id="seen">(.*?)</pre>', done.stdout, re.S)
        if not found and not done.stdout:
            print(f"skipped: the browser cannot start: {done.stderr[-300:]}")
            return 77
        assert found, done.stdout[-500:] + done.stderr[-500:]
        seen = json.loads(found[1])
    by_name = ["a.off", "b.off", "c.off", "notes.ply", "sheet.off"]
    expected = {
        "first": by_name,
        "faces": ["sheet.off", "b.off", "a.off", "c.off", "notes.ply"], "faces_down": ["c.off", "a.off", "b.off", "sheet.off", "notes.ply"],
        "arrow": "descending", "status": ["notes.ply", "c.off", "a.off", "b.off", "sheet.off"], "nothing": ["sheet.off"], "word": ["notes.ply"],
    }
    expected["all"] = expected["status"]
    for what, names in expected.items():
        assert seen[what] == names, f"{what}: {seen[what]}, not {names}"
    assert seen["widths"] == ["420px", "1200px", 1200], seen["widths"]
    print("sorted, chosen and enlarged as clicked")
    return 0


if __name__ == "__main__":
    sys.exit(main())
