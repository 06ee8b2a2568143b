"""The subcommands of the program as functions.

Names and defaults are the program's, from which they come: what is not given is left to it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from . import _core
from ._model import Model, Place
from ._progress import Progress, listener
from ._request import Request
from ._results import (
    Check,
    Comparison,
    Diagnosis,
    Exploration,
    Ranking,
    Shown,
    Simulation,
    Sizing,
    run,
)
from .errors import Interrupted

if TYPE_CHECKING:
    import pandas

Texts = Union[str, Sequence[str]]
RoutingLike = Union[str, "_core.Routing"]
HardwareLike = Union[Place, "_core.Hardware"]
ModelLike = Union[Place, Model]
DataLike = Union[Place, "pandas.DataFrame"]
Held = Union[int, str, Sequence[Union[int, str, Sequence[int]]]]


class Counts(NamedTuple):
    """How many routings there are."""

    all: int
    actuated: int
    one_tendon: int


def _options(local: dict[str, Any], *positionals: str) -> dict[str, Any]:
    """What was given to a function by keyword."""
    return {
        "constraint" if name == "constraints" else name: value
        for name, value in local.items()
        if name not in positionals and name != "progress"
    }


def _held_texts(held: Optional[Held]) -> Optional[list[str]]:
    """Each grasp as the command line has it."""
    if held is None:
        return None
    if isinstance(held, (int, str)):
        return [str(held)]
    if all(isinstance(finger, int) for finger in held):
        return [",".join(map(str, held)) or "none"]
    return [
        grasp if isinstance(grasp, str)
        else str(grasp) if isinstance(grasp, int)
        else ",".join(map(str, grasp)) or "none"
        for grasp in held
    ]


def explore(
    *,
    fingers: Optional[int] = None,
    parts: Optional[str] = None,
    tips: Optional[Texts] = None,
    joins: Optional[Texts] = None,
    ends: Optional[Texts] = None,
    anchored: bool = False,
    blocks: Optional[int] = None,
    distinct_fingers: bool = False,
    tendons: Optional[str] = None,
    grasps: Optional[str] = None,
    objectives: Optional[Texts] = None,
    score: Union[None, str, Mapping[str, float]] = None,
    uncertainty: bool = False,
    draws: Optional[int] = None,
    seed: Optional[int] = None,
    threads: Optional[int] = None,
    ladder: Optional[str] = None,
    within: Union[None, str, float, Sequence[float]] = None,
    cost: Optional[Place] = None,
    store: Optional[Place] = None,
    store_every: Optional[int] = None,
    keep: Optional[str] = None,
    sweep: Optional[str] = None,
    constraints: Optional[Texts] = None,
    top: Optional[int] = None,
    details: Optional[int] = None,
    hardware: Optional[HardwareLike] = None,
    model: Optional[ModelLike] = None,
    progress: Progress = None,
) -> Exploration:
    """Every routing that a set of parts allows: evaluated, ranked.

    Parameters
    ----------
    fingers : int
        Number of fingers. Default: 2.
    parts : str
        paper: tip tube, joins T,P, ends M,F; full: also tip bearing and join B; all: also
        anchored and blocks 1. Default: full.
    tips : str or sequence of str
        Fingertips instead of the set's: tube,bearing.
    joins : str or sequence of str
        Joins instead of the set's: T,B,P.
    ends : str or sequence of str
        Ends instead of the set's: M,F.
    anchored : bool
        Also tendons that are tied at a fingertip, such as M-1x.
    blocks : int
        Also routings with up to so many floating blocks, such as M-Y1+1x-Y1-2x (default: 0;
        of parts all 1).
    distinct_fingers : bool
        Tell fingers apart: M-1-P-2-F and M-2-P-1-F are two routings.
    tendons : str
        Routings with one tendon only, or with any number; tendons that blocks tie together
        count as one. Default: any.
    grasps : str
        single: none held and each one finger held; all; paper: finger 1 held; or held lists
        with weights, such as none:2/1/1,2:0.5. Default: single.
    objectives : str or sequence of str
        What spans the Pareto front; known are uniformity_mean uniformity_worst
        efficiency_mean efficiency_worst force_transmission jams sheaths pulleys knots
        travel round_trip_efficiency adaptability torsional_balance reliability
        authors_efficiency transmission score blocks finger_uniformity_mean
        finger_uniformity_worst parts cost motor_force fingertip_force_mean
        fingertip_force_worst stroke closure motor_power. Default: uniformity,efficiency.
    score : str or mapping
        Order designs by a weighted mean of objectives, such as
        uniformity=2,reliability=0.1; authors: the mean of adaptability, torsional_balance,
        reliability, authors_efficiency and transmission. Within the fronts of objectives if
        these are given, otherwise alone. Default: authors.
    uncertainty : bool
        Draw the friction coefficients from their ranges and give each design's rank as a
        distribution.
    draws : int
        Draws for uncertainty. Default: 1000.
    seed : int
        Seed of the draws. Default: 1.
    threads : int
        Threads; 0: all. The result does not depend on it. Default: 0.
    ladder : str
        What more of it buys is shown: the best design with at most one, two, …; cost where
        cost is given. Default: sheaths.
    within : str
        Name the design with least of the ladder's measure that loses no more than this in
        any ranked objective against the first. Default: 2%.
    cost : path
        TOML file with what each kind of part costs, in money, mass or volume: makes cost an
        objective; see catalog/prices/example.toml.
    store : path
        Keep what is found in this SQLite file, and go on from what it holds; see docs/store.md.
    store_every : int
        Seconds between two times that the store is written; 0: after every batch.
        Default: 60.
    keep : str
        What the store keeps: best, what is listed; all, every design with its objectives.
        Default: best.
    sweep : str
        Show the first design, those of the ladder and the front (up to 8) over a
        coefficient, and where the first place changes hands: mu (of tubes and sheaths),
        tube_mu, sheath_mu, bearing_mu or sheath_angle, such as mu=0.02..0.3; with
        uncertainty in bands of what else is uncertain.
    constraints : str or sequence of str
        Keep only designs with, such as 'sheaths<=2'.
    top : int
        How many of the best designs to keep; the front is always kept. Default: 1000.
    details : int
        Of how many of the best designs the page holds schematics and tensions, besides the
        known routings; by default as many as 170 schematics show in all grasps.
    hardware : Hardware or path
        TOML file with friction coefficients, angles and lengths (default: the paper's; see
        catalog/hardware/example.toml).
    model : Model or path
        TOML file with a hardware and with effects beyond the plain friction model; see
        catalog/model/example.toml.
    progress : callable or bool
        Called with stage, done and total; True: a bar of tqdm.

    Returns
    -------
    Exploration

    Raises
    ------
    InputError
        As the program would complain.
    Interrupted
        On Ctrl-C, with the result as far as it came.

    Examples
    --------
    >>> import reeve
    >>> found = reeve.explore(fingers=2, parts="paper", constraints=["sheaths<=2"])
    >>> found.designs["name"][0]
    'TR3'
    """
    return run(Exploration, _core.explore, Request(options=_options(locals())), progress)


def rank(
    *routings: RoutingLike,
    catalog: bool = False,
    family: Optional[str] = None,
    fingers: Optional[int] = None,
    margin: bool = False,
    data: Optional[DataLike] = None,
    map: Optional[Texts] = None,
    unit: Optional[Texts] = None,
    group: Optional[str] = None,
    mu: Optional[str] = None,
    grasps: Optional[str] = None,
    objectives: Optional[Texts] = None,
    score: Union[None, str, Mapping[str, float]] = None,
    uncertainty: bool = False,
    draws: Optional[int] = None,
    seed: Optional[int] = None,
    threads: Optional[int] = None,
    ladder: Optional[str] = None,
    within: Union[None, str, float, Sequence[float]] = None,
    cost: Optional[Place] = None,
    sweep: Optional[str] = None,
    hardware: Optional[HardwareLike] = None,
    model: Optional[ModelLike] = None,
    progress: Progress = None,
) -> Ranking:
    """Compares routings that you have in mind, best first.

    Parameters
    ----------
    routings : Routing or str
        Words, or names of the catalogue.
    catalog : bool
        All routings of one family of the catalogue with as many fingers as the routings
        given, or with fingers of them.
    family : str
        For catalog: the family, all with the same hardware; paper, which it is by default,
        or a folder of families/.
    fingers : int
        For catalog alone: number of fingers. Default: 2.
    margin : bool
        Search the ranges of the coefficients for where the first design's lead over each
        other one is least.
    data : pandas.DataFrame or path
        For the page: CSV file of readings, drawn beside the model's tensions; docs/data.md
        describes its columns.
    map : str or sequence of str
        A column of the data and what it means, such as 'Kraft Motor=motor_tension_N'; once
        for each column.
    unit : str or sequence of str
        Unit of all tensions in the data, such as lbf, or of one column, such as T1=kgf; may
        be given again.
    group : str
        A column of the data whose words group the rows: a winch, an operator.
    mu : str
        For the page: friction coefficients of tubes and sheaths, for each of which the
        tension distributions are drawn; 'model': as the hardware and the model have them.
        Default: 0.18,0.09.
    grasps : str
        single: none held and each one finger held; all; paper: finger 1 held; or held lists
        with weights, such as none:2/1/1,2:0.5. Default: single.
    objectives : str or sequence of str
        What spans the Pareto front; known are uniformity_mean uniformity_worst
        efficiency_mean efficiency_worst force_transmission jams sheaths pulleys knots
        travel round_trip_efficiency adaptability torsional_balance reliability
        authors_efficiency transmission score blocks finger_uniformity_mean
        finger_uniformity_worst parts cost motor_force fingertip_force_mean
        fingertip_force_worst stroke closure motor_power. Default: uniformity,efficiency.
    score : str or mapping
        Order designs by a weighted mean of objectives, such as
        uniformity=2,reliability=0.1; authors: the mean of adaptability, torsional_balance,
        reliability, authors_efficiency and transmission. Within the fronts of objectives if
        these are given, otherwise alone. Default: authors.
    uncertainty : bool
        Draw the friction coefficients from their ranges and give each design's rank as a
        distribution.
    draws : int
        Draws for uncertainty. Default: 1000.
    seed : int
        Seed of the draws. Default: 1.
    threads : int
        Threads; 0: all. The result does not depend on it. Default: 0.
    ladder : str
        What more of it buys is shown: the best design with at most one, two, …; cost where
        cost is given. Default: sheaths.
    within : str
        Name the design with least of the ladder's measure that loses no more than this in
        any ranked objective against the first. Default: 2%.
    cost : path
        TOML file with what each kind of part costs, in money, mass or volume: makes cost an
        objective; see catalog/prices/example.toml.
    sweep : str
        Show the designs over a coefficient, and where the first place changes hands: mu (of
        tubes and sheaths), tube_mu, sheath_mu, bearing_mu or sheath_angle, such as
        mu=0.02..0.3; with uncertainty in bands of what else is uncertain.
    hardware : Hardware or path
        TOML file with friction coefficients, angles and lengths (default: the paper's; see
        catalog/hardware/example.toml).
    model : Model or path
        TOML file with a hardware and with effects beyond the plain friction model; see
        catalog/model/example.toml.
    progress : callable or bool
        Called with stage, done and total; True: a bar of tqdm.

    Returns
    -------
    Ranking

    Raises
    ------
    InputError
        As the program would complain.
    Interrupted
        On Ctrl-C, with the result as far as it came.

    Examples
    --------
    >>> import reeve
    >>> list(reeve.rank("TR1", "TR7").designs["name"])
    ['TR7', 'TR1']
    """
    request = Request(routings, _options(locals(), "routings"))
    # Whatever a page would show is there; mu and data are of the page.
    def study(arguments: list[str], hears: Any) -> Any:
        return _core.rank([*arguments, "--out=."], hears)
    
    return run(Ranking, study, request, progress)


def size(
    *routings: RoutingLike,
    from_: Optional[Place] = None,
    top: Optional[int] = None,
    vary: Optional[Texts] = None,
    same: Optional[Texts] = None,
    goal: Optional[str] = None,
    target: Union[None, str, Mapping[str, float]] = None,
    score: Union[None, str, Mapping[str, float]] = None,
    grasps: Optional[str] = None,
    nominal: bool = False,
    draws: Optional[int] = None,
    seed: Optional[int] = None,
    starts: Optional[int] = None,
    evaluations: Optional[int] = None,
    threads: Optional[int] = None,
    hardware: Optional[HardwareLike] = None,
    model: Optional[ModelLike] = None,
    progress: Progress = None,
) -> Sizing:
    """The dimensions of a routing's parts that suit a goal best.

    Parameters
    ----------
    routings : Routing or str
        Words, or names of the catalogue.
    from_ : path
        Folder of an exploration: also the best of its designs.
    top : int
        For from: how many of them. Default: 20.
    vary : str or sequence of str
        A dimension and its bounds, such as 'sheath_angle[1]=3..9'; sheath_angle=3..9: of
        all fingers, each by itself. Also tip_angle, strand_mm, closing,
        contact_angle[T2-T3], motor_side_mm, hand_mm. May be given several times.
    same : str or sequence of str
        What stays equal: tips, sheaths, strands, or dimensions such as
        'sheath_angle[2,3,4]'. May be given several times.
    goal : str
        What to make the most of: an objective, or a product such as
        uniformity_worst*efficiency_worst; score: that of score. Default:
        uniformity*efficiency.
    target : str or mapping
        Instead: how hard the fingers are to pull, relative to each other, such as
        1=2,others=1.
    score : str or mapping
        For goal score: objectives with weights. Default: authors.
    grasps : str
        As of rank; with target none held, unless they are given. Default: single.
    nominal : bool
        Size for the coefficients as they are, and not for the 5 % quantile over their
        ranges.
    draws : int
        Draws of the coefficients. Default: 100.
    seed : int
        Seed of the draws and of the starts. Default: 1.
    starts : int
        Local searches, besides the global one. Default: 6.
    evaluations : int
        At most, of each search. Default: 1000.
    threads : int
        Threads; 0: all. The result does not depend on it. Default: 0.
    hardware : Hardware or path
        TOML file with friction coefficients, angles and lengths (default: the paper's; see
        catalog/hardware/example.toml).
    model : Model or path
        TOML file with a hardware and with effects beyond the plain friction model; see
        catalog/model/example.toml.
    progress : callable or bool
        Called with stage, done and total; True: a bar of tqdm.

    Returns
    -------
    Sizing

    Raises
    ------
    InputError
        As the program would complain.
    Interrupted
        On Ctrl-C, with the result as far as it came.
    """
    return run(Sizing, _core.size, Request(routings, _options(locals(), "routings")), progress)


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
    return run(Diagnosis, _core.diagnose, Request([data], _options(locals(), "data")), progress)


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
    request = Request([data], _options(locals(), "data"))
    with request.arguments() as arguments:
        return Comparison(_core.compare(arguments), request)


def show(
    routing: RoutingLike,
    *,
    held: Optional[Held] = None,
    direction: Optional[str] = None,
    cost: Optional[Place] = None,
    hardware: Optional[HardwareLike] = None,
    model: Optional[ModelLike] = None,
) -> Shown:
    """One routing in full: tensions, shares, sliding directions and objectives.

    Parameters
    ----------
    routing : Routing or str
        A word, or a name of the catalogue.
    held : str, int or sequence
        Fingers that are held, such as 1 or 1,2, or none; once for each grasp (default: none
        held and each one finger held).
    direction : str
        Which way the carriage moves. Default: pull.
    cost : path
        TOML file with what each kind of part costs, in money, mass or volume: adds what
        this routing costs; see catalog/prices/example.toml.
    hardware : Hardware or path
        TOML file with friction coefficients, angles and lengths (default: the paper's; see
        catalog/hardware/example.toml).
    model : Model or path
        TOML file with a hardware and with effects beyond the plain friction model; see
        catalog/model/example.toml.

    Returns
    -------
    Shown

    Raises
    ------
    InputError
        As the program would complain.
    """
    options = _options(locals(), "routing") | {"held": _held_texts(held)}
    request = Request([routing], options)
    with request.arguments() as arguments:
        return Shown(_core.show(arguments), request)


def count(
    *,
    fingers: Optional[int] = None,
    parts: Optional[str] = None,
    tips: Optional[Texts] = None,
    joins: Optional[Texts] = None,
    ends: Optional[Texts] = None,
    anchored: bool = False,
    blocks: Optional[int] = None,
    distinct_fingers: bool = False,
) -> Counts:
    """How many routings a set of parts makes, by formula.

    Parameters
    ----------
    fingers : int
        Number of fingers. Default: 2.
    parts : str
        paper: tip tube, joins T,P, ends M,F; full: also tip bearing and join B; all: also
        anchored and blocks 1. Default: full.
    tips : str or sequence of str
        Fingertips instead of the set's: tube,bearing.
    joins : str or sequence of str
        Joins instead of the set's: T,B,P.
    ends : str or sequence of str
        Ends instead of the set's: M,F.
    anchored : bool
        Also tendons that are tied at a fingertip, such as M-1x.
    blocks : int
        Also routings with up to so many floating blocks, such as M-Y1+1x-Y1-2x (default: 0;
        of parts all 1).
    distinct_fingers : bool
        Tell fingers apart: M-1-P-2-F and M-2-P-1-F are two routings.

    Returns
    -------
    Counts

    Raises
    ------
    InputError
        As the program would complain.

    Examples
    --------
    >>> import reeve
    >>> reeve.count(fingers=4).actuated
    3402
    """
    with Request(options=_options(locals())).arguments() as arguments:
        return Counts(*_core.count(arguments))


def check(
    *,
    family: Optional[str] = None,
) -> Check:
    """Recomputes every published number of the catalogue.

    Parameters
    ----------
    family : str
        One family of the catalogue alone: paper, or a folder of families/.

    Returns
    -------
    Check

    Raises
    ------
    InputError
        As the program would complain.
    """
    request = Request(options=_options(locals()))
    with request.arguments() as arguments:
        return Check(_core.check(arguments), request)


def simulate(
    routings: Union[RoutingLike, Sequence[RoutingLike]],
    *,
    grasps: Optional[str] = None,
    directions: Optional[str] = None,
    channels: Optional[str] = None,
    motor_tension: Union[None, str, float, Sequence[float]] = None,
    speed: Union[None, str, float, Sequence[float]] = None,
    cycles: Union[None, str, float, Sequence[float]] = None,
    temperature: Union[None, str, float, Sequence[float]] = None,
    sheath_angle: Union[None, str, float, Sequence[float]] = None,
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
    motor_tension : str
        In N: a range such as 5:60, or a list 5,10,20. Default: 5:60.
    speed : str
        In mm/s, likewise (default: no such column).
    cycles : str
        Rise over the whole experiment: a range or a list (default: no such column).
    temperature : str
        In C, likewise (default: no such column).
    sheath_angle : str
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
    options = _options(locals(), "routings", "cause")
    request = Request(options={"routings": routings, **options}, last=_cause_arguments(cause))
    with request.arguments() as arguments:
        return Simulation(_core.simulate(arguments))


def _cause_arguments(
    cause: Optional[Mapping[str, Optional[Mapping[str, float]]]],
) -> list[str]:
    """Each cause before its parameters."""
    arguments: list[str] = []
    for name, settings in (cause or {}).items():
        arguments.append(f"--cause={name}")
        arguments += [f"--set={key}={value}" for key, value in (settings or {}).items()]
    return arguments
