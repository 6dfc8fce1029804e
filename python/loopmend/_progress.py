# SPDX-License-Identifier: GPL-3.0-or-later
"""progress=True: a bar of tqdm."""
from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Union

from loopmend._types import package


@contextmanager
def shown(progress: Union[None, bool, Callable[..., Any]]) -> Iterator[Optional[Callable[..., Any]]]:
    """What the engine calls: the caller's function, or one that moves a bar, which is closed in the end."""
    if progress is None or progress is False:
        yield None
        return
    if progress is not True:
        yield progress
        return
    tqdm = package("tqdm.auto", "progress=True").tqdm
    with tqdm(total=0, unit=" loops") as bar:

        def move(done: int, total: int, _number: int) -> None:
            bar.total = total
            bar.update(done - bar.n)

        yield move
