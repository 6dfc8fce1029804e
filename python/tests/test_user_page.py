# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/user/python.md: each block of Python runs, and prints what the block of text after it shows.

The blocks share their names, from top to bottom, in a folder of their own. A block that imports a package which is not
installed is skipped. A block after <!-- file: NAME --> is that file.
"""
import contextlib
import doctest
import importlib.util
import io
import os
import re
import sys
from pathlib import Path

import pytest

import loopmend._api

PAGE = Path(__file__).resolve().parents[2] / "docs/user/python.md"
BLOCK = re.compile(r"^(?:<!-- file: (?P<file>\S+) -->\n)?```python\n(?P<code>.*?)^```$(?:\n\n```text\n(?P<text>.*?)^```$)?",
                   re.M | re.S)


def examples():
    page = PAGE.read_text(encoding="utf-8")
    return [(page[:m.start()].count("\n") + 1, m["file"], m["code"], m["text"]) for m in BLOCK.finditer(page)]


@pytest.fixture(scope="module")
def shared(tmp_path_factory):
    """The folder, and the names that the blocks share."""
    folder, before = tmp_path_factory.mktemp("page"), Path.cwd()
    for _, file, code, _ in examples():
        if file:
            (folder / file).write_text(code)
    os.chdir(folder)
    sys.path.insert(0, str(folder))
    yield {"__name__": "__main__"}
    sys.path.remove(str(folder))
    os.chdir(before)


def test_the_page_has_examples():
    assert len(examples()) == len(re.findall("^```python$", PAGE.read_text(encoding="utf-8"), re.M)) > 10


@pytest.mark.parametrize("line, code, text", [pytest.param(line, code, text, id=f"line {line}")
                                              for line, file, code, text in examples() if not file])
def test_example(shared, line, code, text):
    for package in re.findall(r"^(?:import|from) (\w+)", code, re.M):
        if importlib.util.find_spec(package) is None:
            pytest.skip(f"the package {package} is not installed")
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile("\n" * line + code, str(PAGE), "exec"), shared)
    if text is not None:
        assert said.getvalue() == text


def test_the_examples_of_the_docstrings():
    failed, ran = doctest.testmod(loopmend._api, verbose=False)
    assert ran > 5 and failed == 0
