"""Routings that one has in mind: ranked, shown, checked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Optional, Union

from . import _core
from ._arguments import (
    DataLike,
    HardwareLike,
    Held,
    ModelLike,
    RoutingLike,
    Texts,
    held_texts,
    options_of,
)
from ._design_results import Check, Ranking, Shown, StoredRanking
from ._model import Place
from ._progress import Progress
from ._request import Request
from ._results import made, run


def rank(
    *routings: RoutingLike,
    catalog: bool = False,
    family: Optional[str] = None,
    fingers: Optional[int] = None,
    margin: bool = False,
    store: Optional[Place] = None,
    constraints: Optional[Texts] = None,
    top: Optional[int] = None,
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
    within: Optional[str] = None,
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
    store : path
        What explore keeps in this file, ranked without evaluating it again: by the
        objectives, score, constraints and top given here, else as it was explored.
    constraints : str or sequence of str
        Of a store: only designs with, such as 'sheaths<=2'.
    top : int
        Of a store: how many of the best designs.
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
        Of a store a `StoredRanking`, which has no page to save.

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
    request = Request({"routings": routings}, options_of(rank, locals(), "routings"))
    if store is not None:
        return made(StoredRanking, _core.rank_stored, request)

    # Whatever a page would show is there; mu and data are of the page.
    def study(arguments: list[str], hears: Any) -> Any:
        return _core.rank([*arguments, "--out=."], hears)

    return run(Ranking, study, request, progress)


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
    options = options_of(show, locals(), "routing") | {"held": held_texts(held)}
    return made(Shown, _core.show, Request({"routing": [routing]}, options))


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
    return made(Check, _core.check, Request(options=options_of(check, locals())))
