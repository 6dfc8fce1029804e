# SPDX-License-Identifier: GPL-3.0-or-later
"""What the engine says names options as the command line does; here it names those of the functions."""
from __future__ import annotations

import re
from contextlib import contextmanager
from typing import Iterator

from loopmend import _core

_FLAGS = {"include-outer-rim", "repair", "stitch", "auto", "turn-around", "trim-crossing", "cut-intersections", "union", "cut-handles", "cut-no-data",
          "mirror", "weld", "open", "patches-only", "keep-partial"}
_NAMES = {"at-vertex": "at_vertices", "bridge": "bridges", "draw-edge": "drawn_edges", "stop-edge": "stopped_edges", "double": "all_digits=True"}
_OPTION = re.compile(r"--([a-z]+(?:-[a-z]+)*)(?: (exact|robust|auto|round|smooth|continued|mmcvf|wf|sdf|mcf|none|steady|steps|"
                     r"\d+(?:\.\d+)?(?![\d:,])))?")


def _option(match: re.Match[str]) -> str:
    name, value = match[1], match[2]
    if name in _FLAGS and value is None:
        return name.replace("-", "_") + "=True"
    named = _NAMES.get(name, name.replace("-", "_"))
    if value is None:
        return named
    return f"{named}={value}" if value[0].isdigit() else f'{named}="{value}"'


def in_python(text: str) -> str:
    """The same sentence with the names of Python: --max-time is max_time, --repair is repair=True."""
    text = re.sub(r"'loopmend info' lists", "boundary_loops() lists", text)
    text = re.sub(r"'loopmend blend --loops 1:(\d+),1:(\d+)'", r"blend([mesh], loops=[(1, \1), (1, \2)])", text)
    return _OPTION.sub(_option, text)


@contextmanager
def errors_in_python() -> Iterator[None]:
    """Errors of the engine leave this with the names of Python."""
    try:
        yield
    except _core.Error as error:
        said = in_python(str(error))
        if said == str(error):
            raise
        raise type(error)(said) from None
