"""Tables as data frames."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

from . import _core

if TYPE_CHECKING:
    import pandas


def frame_of(columns: Any) -> "pandas.DataFrame":
    """With the objectives' units in its ``attrs``."""
    import pandas

    frame = pandas.DataFrame(columns)
    units = _core.objective_units()
    frame.attrs["units"] = {name: units[name] for name in frame.columns if name in units}
    return frame


def read_csv(csv: str) -> "pandas.DataFrame":
    """A file of the program; ``attrs["simulated"]`` as its comments say."""
    import pandas

    frame = pandas.read_csv(io.StringIO(csv), comment="#")
    comments = [line for line in csv.splitlines() if line.startswith("#")]
    frame.attrs["simulated"] = any("simulated" in line.lower() for line in comments)
    return frame
