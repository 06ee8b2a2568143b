"""Tables as data frames."""

from __future__ import annotations

import io
import re
from typing import TYPE_CHECKING, Any

from . import _core

if TYPE_CHECKING:
    import pandas


# Columns of names, which stay as they are written: 02 is no number, NA and nothing are no NaN.
_WORDS = ("run", "routing", "held", "direction")


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

    # Only above the header: further down it may be the name of a run that begins with #.
    comments = re.match(r"(?:#[^\n]*\n)*", csv)[0]  # type: ignore[index]
    rows = io.StringIO(csv[len(comments) :])
    frame = pandas.read_csv(rows, converters=dict.fromkeys(_WORDS, str))
    frame.attrs["simulated"] = "simulated" in comments.lower()
    return frame
