"""Tensions of many routings, grasps and coefficients at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Optional, Union

import numpy as np

from . import _core
from ._arguments import check_types
from ._progress import Progress, close, listener
from .errors import Interrupted

Array = np.ndarray[Any, Any]
Held = Union[int, str, Sequence[Any]]
Routings = Union[str, "_core.Routing", Sequence[Union[str, "_core.Routing"]]]


@dataclass(frozen=True)
class NamedArray:
    """An array whose axes have names, where xarray is not installed.

    Attributes
    ----------
    values : ndarray
    dims : tuple of str
        The names of its axes.
    coords : dict
        What stands along them.
    """

    values: Array
    dims: tuple[str, ...]
    coords: Mapping[str, Any] = field(default_factory=dict)

    @property
    def shape(self) -> tuple[int, ...]:
        """How long its axes are."""
        return self.values.shape

    def __array__(self, dtype: Any = None) -> Array:
        return np.asarray(self.values, dtype=dtype)


def _is_one_grasp(held: Held) -> bool:
    if isinstance(held, (int, np.integer, str)):
        return True
    return all(isinstance(finger, (int, np.integer)) for finger in held)


def _held_text(held: Held) -> str:
    if isinstance(held, str):
        return held
    fingers = [held] if isinstance(held, (int, np.integer)) else held
    return ",".join(str(finger) for finger in fingers) or "none"


def _numbers(name: str, value: Any) -> Array:
    try:
        return np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected numbers, not {value!r:.60}") from None


def _broadcast(
    coefficients: Mapping[str, Any],
) -> tuple[list[str], tuple[int, ...], dict[str, Any]]:
    """Names of the common axes, their shape, and each coefficient along all of them."""
    if any(hasattr(value, "dims") for value in coefficients.values()):
        import xarray

        arrays = [
            value if hasattr(value, "dims") else xarray.DataArray(value)
            for value in coefficients.values()
        ]
        spread = xarray.broadcast(*arrays)
        names = [str(name) for name in spread[0].dims]
        return names, spread[0].shape, dict(zip(coefficients, (a.values for a in spread)))
    together = np.broadcast_arrays(*(_numbers(*item) for item in coefficients.items()))
    shape = together[0].shape if together else ()
    names = ["sample"] if len(shape) == 1 else [f"sample_{i}" for i in range(len(shape))]
    return names, shape, dict(zip(coefficients, together))


def tensions(
    routings: Routings,
    hardware: Optional["_core.Hardware"] = None,
    held: Held = (),
    *,
    direction: str = "pull",
    threads: int = 0,
    progress: Progress = None,
    named: bool = True,
    **coefficients: Any,
) -> Any:
    """Tensions by the plain friction model, over arrays of coefficients.

    Parameters
    ----------
    routings : Routing or str, or a sequence of them
        A sequence makes an axis ``routing``.
    hardware : Hardware, optional
        Of all coefficients that do not vary; the paper's if none is given.
    held : int, str or sequence
        The fingers that are held, as in `Routing.tensions`; a sequence of such, ``[[], [1]]`` or
        ``["none", "1"]``, makes an axis ``held``.
    direction : {"pull", "release"}
    threads : int
        0: all. The result does not depend on it.
    progress : callable or bool, optional
        Called with stage, done and total; True: a bar of tqdm.
    named : bool
        False: a plain ndarray.
    **coefficients : array_like
        ``tube_mu``, ``sheath_mu``, ``bearing_mu``, ``block_mu`` (``mu_tube`` is ``tube_mu``),
        ``tube_angle_rad``, … (rad): broadcast against each other. What the hardware says of one
        finger or contact stays.

    Returns
    -------
    xarray.DataArray, or NamedArray where xarray is not installed
        N per N of motor tension, of shape (routing, held, *samples, segment); axes that were not
        asked for are not there. NaN where a routing has no such segment.

    Raises
    ------
    Interrupted
        On Ctrl-C; its result is None.

    Examples
    --------
    >>> import numpy as np, reeve
    >>> mu = np.linspace(0.05, 0.2, 4)
    >>> table = reeve.tensions(["TR5", "TR7"], held=[1], tube_mu=mu, sheath_mu=mu)
    >>> table.dims
    ('routing', 'sample', 'segment')
    """
    check_types(tensions, locals())
    one_routing = isinstance(routings, (str, _core.Routing))
    given = [routings] if isinstance(routings, (str, _core.Routing)) else list(routings)
    bound = [r if isinstance(r, _core.Routing) else _core.Routing(r) for r in given]
    one_grasp = _is_one_grasp(held)
    grasps = [held] if one_grasp else list(held)  # type: ignore[arg-type]
    names, shape, columns = _broadcast(coefficients)
    flat = {name: np.ravel(column) for name, column in columns.items()}
    hears = listener(progress)
    try:
        table, segments, interrupted = _core.tension_table(
            bound, hardware, grasps, direction, flat, threads, hears
        )
    finally:
        close(hears)
    if interrupted:
        raise Interrupted()
    values = table.reshape((len(bound), len(grasps), *shape, len(segments)))
    coords: dict[str, Any] = {"segment": segments}
    if not one_routing:
        coords["routing"] = [routing.word for routing in bound]
    if not one_grasp:
        coords["held"] = [_held_text(grasp) for grasp in grasps]
    dims = ("routing", "held", *names, "segment")
    left_out = tuple(i for i, one in enumerate((one_routing, one_grasp)) if one)
    values = values.squeeze(axis=left_out)
    dims = tuple(name for i, name in enumerate(dims) if i not in left_out)
    return _with_names(values, dims, coords) if named else values


def _with_names(values: Array, dims: tuple[str, ...], coords: dict[str, Any]) -> Any:
    try:
        import xarray
    except ImportError:
        return NamedArray(values, dims, coords)
    attributes = {"units": "N/N", "long_name": "tension per motor tension"}
    return xarray.DataArray(values, dims=dims, coords=coords, name="tension", attrs=attributes)
