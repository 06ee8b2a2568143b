"""Routings out of parts: explored, merged, counted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

from . import _core
from ._arguments import HardwareLike, ModelLike, Texts, options_of
from ._design_results import Exploration
from ._model import Place
from ._progress import Progress
from ._request import Request
from ._results import run


class Counts(NamedTuple):
    """How many routings there are.

    Attributes
    ----------
    all : int
        Of the parts.
    actuated : int
        Of these, with every tendon hanging on the motor.
    one_tendon : int
        Of those, with one tendon.
    meeting : int or None
        Of the actuated, those that meet the constraints, if any were given.
    meeting_one_tendon : int or None
        Of those, with one tendon.
    """

    all: int
    actuated: int
    one_tendon: int
    meeting: Optional[int] = None
    meeting_one_tendon: Optional[int] = None


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
    within: Optional[str] = None,
    cost: Optional[Place] = None,
    shard: Optional[str] = None,
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
    shard : str
        i/N: only the i-th of N parts of the whole; `merge` puts them together. Default: 1/1.
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
    request = Request(options=options_of(explore, locals()))
    if store is not None:
        request.require_files()
    return run(Exploration, _core.explore, request, progress)


def merge(
    folders: Sequence[Place],
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Exploration:
    """The shards of an exploration, put together to what the whole would have been.

    Parameters
    ----------
    folders : sequence of path
        The folders that ``explore(shard="i/N").save(folder)`` wrote, or the stores of store, all
        N in any order.
    threads : int
        Threads; 0: all. The result does not depend on it. Default: 0.
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
    """
    request = Request({"folders": folders}, options_of(merge, locals(), "folders"))

    # Where to, save says.
    def study(arguments: list[str], hears: Any) -> Any:
        return _core.merge([*arguments, "--out=."], hears)

    return run(Exploration, study, request, progress)


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
    constraints: Optional[Texts] = None,
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
    constraints : str or sequence of str
        Also how many meet this, on parts alone, such as 'sheaths<=2'.

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
    with Request(options=options_of(count, locals())).arguments() as arguments:
        return Counts(*_core.count(arguments))
