#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""notebook.png: what a notebook shows of a result, drawn by Chromium.

Usage: make_notebook.py FOLDER   (in a Python that has loopmend; needs Debian's chromium)
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import loopmend

STYLE = """body { font: 15px sans-serif; margin: 10px; } table { border-collapse: collapse; font-size: 15px; }
td, th { padding: 4px 5px; text-align: left; } td:last-child { overflow-wrap: anywhere; } tr:nth-child(even) { background: #f2f3f4; }"""


def main():
    target = Path(sys.argv[1]).resolve() / "notebook.png"
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page.html"
        page.write_text(f"<!doctype html><meta charset='utf-8'><style>{STYLE}</style>{loopmend.fill(loopmend.sample())._repr_html_()}",
                        encoding="utf-8")
        subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--window-size=640,690",
                        f"--user-data-dir={folder}/settings", f"--screenshot={target}", page.as_uri()], check=True, stderr=subprocess.DEVNULL)


if __name__ == "__main__":
    main()
