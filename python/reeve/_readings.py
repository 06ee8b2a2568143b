"""Readings: compared, diagnosed, taken out of a log."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Integral
from typing import Optional, Union

from . import _core
from ._arguments import (
    DataLike,
    HardwareLike,
    ModelLike,
    RoutingLike,
    Texts,
    options_of,
)
from ._progress import Progress
from ._reading_results import Comparison, Diagnosis, SteadyReadings
from ._request import Request
from ._results import made, run


def diagnose(
    data: DataLike,
    *,
    alpha: Optional[float] = None,
    hold_out: Optional[float] = None,
    seed: Optional[int] = None,
    replicates: Optional[int] = None,
    mounting_scatter: Optional[float] = None,
    as_readings: bool = False,
    explore: bool = False,
    threads: Optional[int] = None,
    map: Optional[Texts] = None,
    unit: Optional[Texts] = None,
    group: Optional[str] = None,
    noise: Optional[Texts] = None,
    exact: Optional[Texts] = None,
    hardware: Optional[HardwareLike] = None,
    progress: Progress = None,
) -> Diagnosis:
    """What the model gets wrong about measured tensions, which cause, and what to measure next.

    Parameters
    ----------
    data : pandas.DataFrame or path
        Readings; docs/data.md has the columns.
    alpha : float
        Chance of naming a cause where there is none, over the whole search. Default: 0.02.
    hold_out : float
        Share of the runs that no fit sees, on which the gain is measured. Default: 0.3.
    seed : int
        Seed: which runs are held out, and what chance draws. Default: 1.
    replicates : int
        Simulated data sets that a finding is judged by; at least 8 / alpha, which is also
        the default where it is more. Default: 1000.
    mounting_scatter : float
        How far friction exponents differ from mounting to mounting, as a share such as
        0.05; 0: not at all (default: as the readings tell, or assumed).
    as_readings : bool
        Take each row as a reading even where the file looks like a time series.
    explore : bool
        Choose the next measurement from generated routings too, not only from those of the
        catalogue and of the data.
    threads : int
        Threads; 0: all. The result does not depend on it. Default: 0.
    map : str or sequence of str
        A column of the data and what it means, such as 'Kraft Motor=motor_tension_N'; once
        for each column.
    unit : str or sequence of str
        Unit of all tensions in the data, such as lbf, or of one column, such as T1=kgf; may
        be given again.
    group : str
        A column of the data whose words group the rows: a winch, an operator.
    noise : str or sequence of str
        What readings of a column, or of the motor tension, are known to scatter by: T1=2%,
        motor=0.5N, T1=2%+0.3N; may be given again.
    exact : str or sequence of str
        A column of tensions that do not scatter, such as a dead weight's; may be given
        again.
    hardware : Hardware or path
        TOML file with friction coefficients, angles and lengths (default: the paper's; see
        catalog/hardware/example.toml).
    progress : callable or bool
        Called with stage, done and total; True: a bar of tqdm.

    Returns
    -------
    Diagnosis

    Raises
    ------
    InputError
        As the program would complain.
    Interrupted
        On Ctrl-C, with the result as far as it came.
    """
    request = Request({"data": [data]}, options_of(diagnose, locals(), "data"))
    return run(Diagnosis, _core.diagnose, request, progress)


def compare(
    data: DataLike,
    *,
    map: Optional[Texts] = None,
    unit: Optional[Texts] = None,
    group: Optional[str] = None,
    hardware: Optional[HardwareLike] = None,
    model: Optional[ModelLike] = None,
) -> Comparison:
    """Measured tensions beside the model's, as it stands: nothing is fitted.

    Parameters
    ----------
    data : pandas.DataFrame or path
        Readings; docs/data.md has the columns.
    map : str or sequence of str
        A column of the data and what it means, such as 'Kraft Motor=motor_tension_N'; once
        for each column.
    unit : str or sequence of str
        Unit of all tensions in the data, such as lbf, or of one column, such as T1=kgf; may
        be given again.
    group : str
        A column of the data whose words group the rows: a winch, an operator.
    hardware : Hardware or path
        TOML file with friction coefficients, angles and lengths (default: the paper's; see
        catalog/hardware/example.toml).
    model : Model or path
        TOML file with a hardware and with effects beyond the plain friction model; see
        catalog/model/example.toml.

    Returns
    -------
    Comparison

    Raises
    ------
    InputError
        As the program would complain.
    """
    request = Request({"data": [data]}, options_of(compare, locals(), "data"))
    return made(Comparison, _core.compare, request)


def import_log(
    log: DataLike,
    *,
    map: Optional[Texts] = None,
    unit: Optional[Texts] = None,
    run: Optional[Union[str, int]] = None,
    routing: Optional[RoutingLike] = None,
    held: Union[None, str, int, Sequence[int]] = None,
    direction: Optional[str] = None,
    least_time: Optional[float] = None,
    tolerance: Optional[float] = None,
    per_sweep: Optional[int] = None,
    reverse: bool = False,
) -> SteadyReadings:
    """Steady readings out of a logger's time series: the program's import, which Python keeps.

    Parameters
    ----------
    log : pandas.DataFrame or path
        A row for each sample; docs/data.md has the columns.
    map : str or sequence of str
        A column of the data and what it means, such as 'Kraft Motor=motor_tension_N'; once
        for each column.
    unit : str or sequence of str
        Unit of all tensions in the data, such as lbf, or of one column, such as T1=kgf; may
        be given again.
    run : str or int
        Run of all readings, if the log has no column run (default: 1).
    routing : Routing or str
        Routing of all readings, if the log has no column routing.
    held : str, int or sequence of int
        Held fingers of all readings, such as 1 or '1;2', if the log has no column held
        (default: none).
    direction : str
        pull or release, where neither position nor speed nor load say.
    least_time : float
        Seconds that a reading lasts at least. Default: 0.5.
    tolerance : float
        Share within which a steady tension stays, beside its noise. Default: 0.02.
    per_sweep : int
        Readings at most of one stroke along which the load grows or falls. Default: 5.
    reverse : bool
        Position and speed of the log fall while the carriage pulls.

    Returns
    -------
    SteadyReadings

    Raises
    ------
    InputError
        As the program would complain.
    """
    options = options_of(import_log, locals(), "log")
    if held is not None and not isinstance(held, (str, int, Integral)):
        options["held"] = ";".join(str(finger) for finger in held) or "none"
    return made(SteadyReadings, _core.import_log, Request({"log": [log]}, options))
