"""reeve: tendon routings of soft wearable robots, explored, ranked, sized and diagnosed.

The functions are the program's subcommands, with its names and defaults; `tensions` and
`Routing.tensions` are the friction model itself, for loops and arrays.
"""

from collections.abc import Mapping as _Mapping

from ._commands import (
    Counts,
    check,
    compare,
    count,
    diagnose,
    explore,
    rank,
    show,
    simulate,
    size,
)
from ._core import Hardware, Routing, Tensions, __commit__, __version__
from ._model import Model
from ._results import (
    Check,
    Comparison,
    Diagnosis,
    Exploration,
    Ranking,
    Result,
    Shown,
    Simulation,
    Sizing,
)
from ._tensions import NamedArray, tensions
from .errors import InputError, Interrupted, Notice, OutOfRange

# It has what a mapping has, and these methods from it.
for _name in ("keys", "items", "values", "get", "__contains__", "__eq__"):
    setattr(Tensions, _name, getattr(_Mapping, _name))
_Mapping.register(Tensions)

__all__ = [
    "Check",
    "Comparison",
    "Counts",
    "Diagnosis",
    "Exploration",
    "Hardware",
    "InputError",
    "Interrupted",
    "Model",
    "NamedArray",
    "Notice",
    "OutOfRange",
    "Ranking",
    "Result",
    "Routing",
    "Shown",
    "Simulation",
    "Sizing",
    "Tensions",
    "check",
    "compare",
    "count",
    "diagnose",
    "explore",
    "rank",
    "show",
    "simulate",
    "size",
    "tensions",
]
