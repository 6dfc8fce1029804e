# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/user/first_hole.md, python.md and walkthrough.md: each block of Python runs, and prints what the block of
text after it shows.

The blocks of a page share their names, from top to bottom, in a folder of their own. A block that needs a package which is not
installed is skipped. A block after <!-- file: NAME --> is that file. The pictures that a page shows from pictures/ are made by its
code; with LOOPMEND_KEEP_PICTURES, the name of a folder, they are copied there.
"""
import contextlib
import doctest
import importlib.util
import io
import os
import re
import shutil
import sys
from pathlib import Path

import pytest

import loopmend._api

PAGES = Path(__file__).resolve().parents[2] / "docs/user"
LONG_NAMES = ["python.md", "walkthrough.md"]
NAMES = ["first_hole.md", *LONG_NAMES]
BLOCK = re.compile(r"^(?:<!-- file: (?P<file>\S+) -->\n)?```python\n(?P<code>.*?)^```$(?:\n\n```text\n(?P<text>.*?)^```$)?",
                   re.M | re.S)
PICTURE = re.compile(r"^!\[[^\]]+\]\(pictures/(\S+)\)$", re.M)


def text_of(name):
    return (PAGES / name).read_text(encoding="utf-8")


def examples(name):
    page = text_of(name)
    return [(page[:m.start()].count("\n") + 1, m["file"], m["code"], m["text"]) for m in BLOCK.finditer(page)]


def missing_package(code):
    packages = re.findall(r"^(?:import|from) (\w+)", code, re.M)
    return next((package for package in packages if importlib.util.find_spec(package) is None), None)


@pytest.fixture(scope="module")
def started(tmp_path_factory):
    """For each page: its folder, and the names that its blocks share."""
    pages, before = {}, Path.cwd()
    for name in NAMES:
        folder = tmp_path_factory.mktemp("page")
        for _, file, code, _ in examples(name):
            if file:
                (folder / file).write_text(code)
        sys.path.insert(0, str(folder))
        pages[name] = folder, {"__name__": "__main__"}
    yield pages
    for folder, _ in pages.values():
        sys.path.remove(str(folder))
    os.chdir(before)


@pytest.mark.parametrize("name", LONG_NAMES)
def test_the_page_has_examples(name):
    assert len(examples(name)) == len(re.findall("^```python$", text_of(name), re.M)) > 7


@pytest.mark.parametrize("name, line, code, text", [pytest.param(name, line, code, text, id=f"{name} line {line}")
                                                    for name in NAMES for line, file, code, text in examples(name) if not file])
def test_example(started, name, line, code, text):
    folder, shared = started[name]
    if package := shared.get("missing package") or missing_package(code):
        if name != "python.md":  # the blocks after it need what it brings
            shared["missing package"] = package
        pytest.skip(f"the package {package} is not installed")
    os.chdir(folder)
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile("\n" * line + code, name, "exec"), shared)
    if text is not None:
        assert said.getvalue() == text


@pytest.mark.parametrize("name", LONG_NAMES)
def test_the_pictures_are_what_the_code_makes(started, name):
    folder, shared = started[name]
    if package := shared.get("missing package"):
        pytest.skip(f"the package {package} is not installed")
    shown = PICTURE.findall(text_of(name))
    assert sorted(shown) == sorted(path.name for path in folder.glob("*.png"))
    for picture in shown:
        assert (PAGES / "pictures" / picture).exists()
        if keep := os.environ.get("LOOPMEND_KEEP_PICTURES"):
            shutil.copy(folder / picture, keep)


def test_the_examples_of_the_docstrings():
    failed, ran = doctest.testmod(loopmend._api, verbose=False)
    assert ran > 5 and failed == 0
