"""How far long work is: told to a function, or to tqdm."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any, Optional, Union

Progress = Union[None, bool, Callable[[str, int, int], object]]


class _Bar:
    def __init__(self, tqdm: Any) -> None:
        self._tqdm = tqdm
        self._stage = ""
        self._bar: Any = None

    def __call__(self, stage: str, done: int, total: int) -> None:
        if stage != self._stage:
            self.close()
            self._stage = stage
            self._bar = self._tqdm(desc=stage, total=total or None)
        self._bar.update(done - self._bar.n)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()


def close(hears: Optional[Callable[[str, int, int], object]]) -> None:
    """No more is to come."""
    if isinstance(hears, _Bar):
        hears.close()


def listener(
    progress: Progress, stacklevel: int = 3
) -> Optional[Callable[[str, int, int], object]]:
    """The function to call; None if nobody wants to know."""
    if progress is None or progress is False:
        return None
    if progress is not True:
        return progress
    try:
        from tqdm.auto import tqdm
    except ImportError:
        warnings.warn("progress=True needs tqdm, which is not installed", stacklevel=stacklevel)
        return None
    return _Bar(tqdm)
