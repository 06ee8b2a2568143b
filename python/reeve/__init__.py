"""reeve: tendon routings of soft wearable robots, explored, ranked, sized and diagnosed.

The functions are the program's subcommands, with its names and defaults; `tensions` and
`Routing.tensions` are the friction model itself, for loops and arrays.
"""

from collections.abc import Mapping as _Mapping

from . import _methods
from ._commands import (
    catalogue, check, compare, count, diagnose, explore, import_log, merge, power, rank, show,
    simulate, size,
)
from ._core import Hardware, Routing, Tensions, __commit__, __version__
from ._design_results import (
    Catalogue, Check, Counts, Exploration, Ranking, Shown, Sizing, StoredRanking,
)
from ._model import Model
from ._reading_results import Comparison, Diagnosis, Power, Simulation, SteadyReadings
from ._results import Result
from ._tensions import NamedArray, tensions
from .errors import InputError, Interrupted, Notice, OutOfRange

# It has what a mapping has, and these methods from it.
for _name in ("keys", "items", "values", "get", "__contains__", "__eq__"):
    setattr(Tensions, _name, getattr(_Mapping, _name))
_Mapping.register(Tensions)
for _method in (_methods.tensions, _methods.to_mjcf):
    setattr(Routing, _method.__name__, _method)

__all__ = [
    "Catalogue",
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
    "Power",
    "Ranking",
    "Result",
    "Routing",
    "Shown",
    "Simulation",
    "Sizing",
    "SteadyReadings",
    "StoredRanking",
    "Tensions",
    "catalogue",
    "check",
    "compare",
    "count",
    "diagnose",
    "explore",
    "import_log",
    "merge",
    "power",
    "rank",
    "show",
    "simulate",
    "size",
    "tensions",
]
