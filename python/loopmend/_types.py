# SPDX-License-Identifier: GPL-3.0-or-later
"""The words and kinds of arguments that the functions of loopmend take."""
from __future__ import annotations

import importlib
import os
from typing import Any, Callable, Literal, Union

Path = Union[str, "os.PathLike[str]"]

Flow = Literal["mmcvf", "wf", "sdf", "mcf", "none"]
Boundary = Literal["auto", "exact", "robust"]
Continuity = Literal["position", "tangent", "curvature"]
Mode = Literal["steady", "steps"]
Solver = Literal["auto", "direct", "gmres"]
Relief = Literal["smooth", "continued"]
Edges = Literal["auto", "round"]
Islands = Literal["join", "cover"]

Status = Literal["converged", "early_stop", "faired", "filled", "step_limit", "stalled", "failed", "skipped"]
LoopKind = Literal["hole", "outer rim", "crack", "cut"]
Grade = Literal["good", "look", "bad"]

OnProgress = Callable[[int, int, int], Any]
OnStep = Callable[[int, float], Any]


def package(name: str, what: str) -> Any:
    """An optional package. @raises ImportError that says what needs it."""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name.partition(".")[0] and error.name != name:
            raise
        raise ImportError(f"{what} needs the package {name.partition('.')[0]}: pip install {name.partition('.')[0]}") from None
