"""Dimensions that suit a goal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Optional, Union

from . import _core
from ._arguments import HardwareLike, ModelLike, RoutingLike, Texts, options_of
from ._design_results import Sizing
from ._model import Place
from ._progress import Progress
from ._request import Request
from ._results import run


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
        all fingers, each by itself. Also tip_angle, strand_mm, closing, arm_mm,
        contact_angle[T2-T3], motor_side_mm, hand_mm. May be given several times.
    same : str or sequence of str
        What stays equal: tips, sheaths, strands, arms, or dimensions such as
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
    request = Request({"routings": routings}, options_of(size, locals(), "routings"))
    return run(Sizing, _core.size, request, progress)
