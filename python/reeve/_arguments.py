"""What functions are given: of which types, and how the command line would say it."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from numbers import Integral, Real
from os import PathLike
from typing import TYPE_CHECKING, Any, Optional, Union, get_args, get_origin, get_type_hints

import numpy as np

from . import _core
from ._model import Model, Place

if TYPE_CHECKING:
    import pandas

Texts = Union[str, Sequence[str]]
Numbers = Union[str, float, Sequence[float]]
Angle = Union[str, float]
Weights = Union[str, Mapping[str, float]]
Causes = Mapping[str, Optional[Mapping[str, float]]]
RunLike = Union[str, int]
RoutingLike = Union[str, "_core.Routing"]
RoutingsLike = Union[RoutingLike, Sequence[RoutingLike]]
HardwareLike = Union[Place, "_core.Hardware"]
ModelLike = Union[Place, Model]
DataLike = Union[Place, "pandas.DataFrame"]
Fingers = Union[str, int, Sequence[int]]
Held = Union[int, str, Sequence[Union[int, str, Sequence[int]]]]


def options_of(
    function: Callable[..., Any], local: Mapping[str, Any], *positionals: str
) -> dict[str, Any]:
    """The options among what a function was given, which is of the types that it says."""
    check_types(function, local)
    return {
        "constraint" if name == "constraints" else name: value
        for name, value in local.items()
        if name not in positionals and name != "progress"
    }


def check_types(function: Callable[..., Any], local: Mapping[str, Any]) -> None:
    """Raises TypeError that names the first argument of another type."""
    variadic = function.__code__.co_flags & inspect.CO_VARARGS
    several = function.__code__.co_varnames[_named(function)] if variadic else None
    for name, hint in _hints(function).items():
        if name not in local:
            continue
        for value in local[name] if name == several else [local[name]]:
            if not _fits(value, hint):
                raise TypeError(f"{name}: expected {_words(hint)}, not {_shown(value)}")


def _named(function: Callable[..., Any]) -> int:
    return function.__code__.co_argcount + function.__code__.co_kwonlyargcount


@cache
def _hints(function: Callable[..., Any]) -> dict[str, Any]:
    import pandas

    return get_type_hints(function, localns={"pandas": pandas})


def _fits(value: Any, hint: Any) -> bool:
    kind = get_origin(hint) or hint
    inner = get_args(hint)
    if hint is Any:
        return True
    if kind is Union:
        return any(_fits(value, one) for one in inner)
    if kind is bool:
        return isinstance(value, (bool, np.bool_))
    if kind in (int, float):
        is_number = isinstance(value, Integral if kind is int else Real)
        return is_number and not isinstance(value, bool)
    if kind is Callable:
        return callable(value)
    if kind is Mapping:
        return isinstance(value, Mapping) and all(_fits(one, inner[1]) for one in value.values())
    if kind is Sequence:
        is_list = isinstance(value, (Sequence, np.ndarray)) and not isinstance(value, str)
        return is_list and all(_fits(one, inner[0]) for one in value)
    return isinstance(value, kind)


def _words(hint: Any) -> str:
    """A type for people: "int", "str, path or DataFrame", "sequence of float"."""
    kind = get_origin(hint) or hint
    inner = get_args(hint)
    if kind is Union:
        *others, last = dict.fromkeys(_words(one) for one in inner if one is not type(None))
        return f"{', '.join(others)} or {last}" if others else last
    if kind is Sequence:
        return "sequence" if inner[0] is Any else f"sequence of {_words(inner[0])}"
    known = {PathLike: "path", Mapping: "mapping", Callable: "callable"}
    return known.get(kind) or str(kind.__name__)


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else type(value).__name__


def held_texts(held: Optional[Held]) -> Optional[list[str]]:
    """Each grasp as the command line has it."""
    if held is None:
        return None
    if isinstance(held, (str, int, Integral)):
        return [str(held)]
    if all(isinstance(finger, Integral) for finger in held):
        return [_grasp_text(held)]
    return [_grasp_text(grasp) for grasp in held]


def held_text(held: Optional[Fingers]) -> Optional[str]:
    """One grasp as a data file has it."""
    if held is None:
        return None
    if isinstance(held, (str, int, Integral)):
        return str(held)
    return ";".join(map(str, held)) or "none"


def cause_arguments(causes: Optional[Causes]) -> list[str]:
    """Each cause before its parameters."""
    arguments: list[str] = []
    for name, settings in (causes or {}).items():
        arguments.append(f"--cause={name}")
        arguments += [f"--set={key}={value}" for key, value in (settings or {}).items()]
    return arguments


def _grasp_text(grasp: Any) -> str:
    if isinstance(grasp, (str, Integral)):
        return str(grasp)
    return ",".join(map(str, grasp)) or "none"
