"""Planned experiments: simulated, and how often a diagnosis would find what is hidden."""

from __future__ import annotations

import inspect
from collections.abc import Mapping, Sequence
from typing import Any, Optional, Union

from . import _core
from ._arguments import HardwareLike, Numbers, RoutingLike, check_types, options_of
from ._progress import Progress
from ._reading_results import Power, Simulation
from ._request import Request
from ._results import run


def simulate(
    routings: Union[RoutingLike, Sequence[RoutingLike]],
    *,
    grasps: Optional[str] = None,
    directions: Optional[str] = None,
    channels: Optional[str] = None,
    motor_tension: Optional[Numbers] = None,
    speed: Optional[Numbers] = None,
    cycles: Optional[Numbers] = None,
    temperature: Optional[Numbers] = None,
    sheath_angle: Optional[Numbers] = None,
    noise_relative: Optional[float] = None,
    noise_absolute: Optional[float] = None,
    noise_motor: Optional[float] = None,
    runs: Optional[int] = None,
    rows: Optional[int] = None,
    repeats: Optional[int] = None,
    cause: Optional[Mapping[str, Optional[Mapping[str, float]]]] = None,
    hardware: Optional[HardwareLike] = None,
    seed: Optional[int] = None,
) -> Simulation:
    """Readings of a planned experiment on a rig with hidden causes. They are simulated.

    Parameters
    ----------
    routings : Routing or str, or a sequence of them
        Which are mounted, in turns.
    grasps : str
        single: none held and each one finger held; all; or held lists such as none/1/2.
        Default: single.
    directions : str
        pull, release, or pull,release. Default: pull.
    channels : str
        Where the sensors are: strands, all, or segments such as T1,T3,a. Default: strands.
    motor_tension : str, float or sequence of float
        In N: a range such as 5:60, or a list 5,10,20. Default: 5:60.
    speed : str, float or sequence of float
        In mm/s, likewise (default: no such column).
    cycles : str, float or sequence of float
        Rise over the whole experiment: a range or a list (default: no such column).
    temperature : str, float or sequence of float
        In C, likewise (default: no such column).
    sheath_angle : str, float or sequence of float
        Of all sheaths, in rad, likewise (default: the hardware's).
    noise_relative : float
        Standard deviation of a reading, as a share of the tension. Default: 0.02.
    noise_absolute : float
        … and besides that, in N. Default: 0.05.
    noise_motor : float
        Standard deviation of the motor tension that is written, as a share of the one that
        pulls. Default: 0.
    runs : int
        Mountings. Default: 12.
    rows : int
        Conditions that are set in each run. Default: 20.
    repeats : int
        Readings under each of them. Default: 1.
    cause : mapping
        Hidden causes and their parameters, such as {"sensor_gain[T3]": {"gain": 1.08}}.
    hardware : Hardware or path
        TOML file with friction coefficients, angles and lengths (default: the paper's; see
        catalog/hardware/example.toml).
    seed : int
        Seed of the conditions and the noise. Default: 1.

    Returns
    -------
    Simulation

    Raises
    ------
    InputError
        As the program would complain.
    """
    request = _request(locals())
    with request.arguments() as arguments:
        return Simulation(_core.simulate(arguments))


def power(
    experiments: int,
    routings: Union[RoutingLike, Sequence[RoutingLike]],
    *,
    progress: Progress = None,
    **options: Any,
) -> Power:
    """How often diagnoses of a planned experiment would find what is hidden: ``--power``.

    Parameters
    ----------
    experiments : int
        How many are simulated and diagnosed, of the seed and the next ones.
    routings : Routing or str, or a sequence of them
        Which are mounted, in turns.
    progress : callable or bool
        Called with stage, done and total; True: a bar of tqdm.
    **options
        Those of `simulate`.

    Returns
    -------
    Power

    Raises
    ------
    InputError
        As the program would complain.
    Interrupted
        On Ctrl-C; its result is None.
    """
    check_types(power, locals())
    given = inspect.signature(simulate).bind(routings, **options).arguments
    return run(Power, _core.power, _request(given, [f"--power={experiments}"]), progress)


def _request(given: Mapping[str, Any], last: Sequence[str] = ()) -> Request:
    """Of the arguments of `simulate`, each cause before its parameters."""
    options = options_of(simulate, given, "routings", "cause")
    causes = _cause_arguments(given.get("cause"))
    return Request(options={"routings": given["routings"], **options}, last=[*causes, *last])


def _cause_arguments(
    cause: Optional[Mapping[str, Optional[Mapping[str, float]]]],
) -> list[str]:
    """Each cause before its parameters."""
    arguments: list[str] = []
    for name, settings in (cause or {}).items():
        arguments.append(f"--cause={name}")
        arguments += [f"--set={key}={value}" for key, value in (settings or {}).items()]
    return arguments
