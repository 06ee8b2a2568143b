"""Methods of the library's classes that take several arguments, called as Python calls its own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Optional, Union

from . import _core


def tensions(
    self: _core.Routing,
    hardware: Optional[_core.Hardware] = None,
    held: Union[int, str, Sequence[int]] = (),
    direction: str = "pull",
) -> _core.Tensions:
    """Tensions in one grasp, by the plain friction model.

    Parameters
    ----------
    hardware : Hardware, optional
        The paper's if none is given.
    held : sequence of int, int or str
        The fingers that are held: ``[1]``, ``1``, ``"1,2"`` or ``"none"``.
    direction : {"pull", "release"}
        Which way the carriage moves.

    Returns
    -------
    Tensions

    Examples
    --------
    >>> import reeve
    >>> state = reeve.Routing("TR5").tensions(held=[1])
    >>> round(float(state["T1"]), 4)
    0.2802
    """
    return self._tensions(hardware, held, direction)


def to_mjcf(self: _core.Routing, hardware: Optional[_core.Hardware] = None) -> str:
    """The routing as a planar hand for MuJoCo, without friction.

    Parameters
    ----------
    hardware : Hardware, optional
        Joints and lengths of the fingers. Default: the paper's, without joints.

    Returns
    -------
    str
        The model's XML, as ``reeve export`` writes it; docs/mujoco.md says what is
        in it and what is not.

    Examples
    --------
    >>> import reeve
    >>> "no capstan friction" in reeve.Routing("TR7").to_mjcf()
    True
    """
    return self._to_mjcf(hardware)
