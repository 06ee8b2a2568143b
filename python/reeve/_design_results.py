"""Results about designs: counted, explored, ranked, sized, shown, checked, listed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Optional

from . import _plots
from ._frames import frame_of
from ._results import Result, SavedResult

if TYPE_CHECKING:
    import pandas


def _counted(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


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
    parts : dict
        Parts that were counted: ``tips``, ``joins``, ``ends``, ``anchored``, ``blocks``.
    left_out : dict or None
        Parts that the default leaves out, since they make too many routings.
    """

    all: int
    actuated: int
    one_tendon: int
    meeting: Optional[int] = None
    meeting_one_tendon: Optional[int] = None
    parts: Optional[dict[str, Any]] = None
    left_out: Optional[dict[str, Any]] = None


class Ranking(SavedResult):
    """Designs, best first.

    Attributes
    ----------
    designs : pandas.DataFrame
        The columns of designs.csv (docs/json.md); units in ``attrs["units"]``.
    front : pandas.DataFrame
        Those that no other beats in every objective.
    tradeoff : pandas.DataFrame
        Best design for each number of parts.
    """

    @property
    def designs(self) -> "pandas.DataFrame":
        return frame_of(self._report.designs())

    @property
    def front(self) -> "pandas.DataFrame":
        designs = self.designs
        return designs[designs["front"] == 1]

    @property
    def tradeoff(self) -> "pandas.DataFrame":
        import pandas

        return pandas.json_normalize((self.summary.get("tradeoff") or {}).get("steps") or [])

    def plot(self, x: str = "uniformity_mean", y: str = "efficiency_mean", ax: Any = None) -> Any:
        """Two objectives of the designs against each other, the front marked; with matplotlib.

        Returns
        -------
        matplotlib.axes.Axes
        """
        return _plots.two_columns(self.designs, self.front, x, y, ax)

    def _in_a_line(self) -> str:
        designs = self.designs
        first = designs["name"][0] or designs["routing"][0]
        return f"{_counted(len(designs), 'design')}, {first} first"

    def _repr_html_(self) -> str:
        shown = ["rank", "front", "name", "routing"]
        shown += ["uniformity_mean", "efficiency_mean", "sheaths"]
        designs = self.designs
        table = designs[[name for name in shown if name in designs]].head(10)
        html = str(table.to_html(index=False))
        tradeoff = self.tradeoff
        if len(tradeoff):
            html += "<p>Best design for each number of parts:</p>" + str(tradeoff.to_html(index=False))
        return html


class StoredRanking(Ranking):
    """What a store keeps, ranked; it has no files of its own."""

    @property
    def front(self) -> "pandas.DataFrame":
        return frame_of(self._report.front())

    def save(self, folder: Any) -> None:
        """Not there: the program writes no page of a store either."""
        raise NotImplementedError("what a store keeps has no page: .designs.to_csv() writes it")

    def _in_a_line(self) -> str:
        kept = _counted(len(self.designs), "design")
        return f"{kept} of a store, {len(self.front)} on the front"


class Exploration(Ranking):
    """Every routing that a set of parts allows, best first.

    Attributes
    ----------
    partial : str
        Why it is not all of them; empty if it is.
    """

    @property
    def front(self) -> "pandas.DataFrame":
        return frame_of(self._report.front())

    @property
    def partial(self) -> str:
        return str(self._report.partial())

    def _in_a_line(self) -> str:
        fingers = _counted(self._report.fingers(), "finger")
        designs = _counted(self._report.evaluated(), "design")
        partial = ", partial" if self.partial else ""
        return f"{fingers}, {designs}, {len(self.front)} on the front{partial}"


class Sizing(SavedResult):
    """Dimensions that suit a goal best.

    Attributes
    ----------
    designs : pandas.DataFrame
        The routings sized, best first: ``goal_before``, ``goal``, and the objectives as sized,
        named as in designs.csv; units in ``attrs["units"]``.
    dimensions : pandas.DataFrame
        One row for each routing and dimension: its bounds, what it was and what it is, how far it
        alone may be off before 1 % of the goal is lost (``tolerance_less``, ``tolerance_more``;
        NaN: farther than its bounds and their width beyond).
    """

    @property
    def designs(self) -> "pandas.DataFrame":
        import pandas

        rows = []
        for design in self.summary["designs"]:
            sized = {name: value for name, value in design["sized"].items() if name != "goal"}
            before, after = design["before"]["goal"], design["sized"]["goal"]
            about = {name: design[name] for name in ("rank", "rank_before", "routing", "name")}
            rows.append(about | {"goal_before": before, "goal": after} | sized)
        return frame_of(pandas.json_normalize(rows, sep="_"))

    @property
    def dimensions(self) -> "pandas.DataFrame":
        import pandas

        rows = []
        for design in self.summary["designs"]:
            for of in design["dimensions"]:
                tolerance = of["tolerance"] or {"less": None, "more": None}
                rows.append({
                    "routing": design["routing"],
                    "dimension": of["dimension"],
                    "unit": of["unit"],
                    "low": of["bounds"][0],
                    "high": of["bounds"][1],
                    "before": of["before"],
                    "sized": of["sized"],
                    "at_bound": of["at_bound"],
                    "tolerance_less": tolerance["less"],
                    "tolerance_more": tolerance["more"],
                })
        numbers = ["before", "sized", "tolerance_less", "tolerance_more"]
        return pandas.DataFrame(rows).astype(dict.fromkeys(numbers, float))

    def plot(self, ax: Any = None) -> Any:
        """Where the best design's dimensions are in their bounds; with matplotlib.

        Returns
        -------
        matplotlib.axes.Axes
        """
        best = self.dimensions[self.dimensions["routing"] == self.designs["routing"][0]]
        return _plots.dimensions(best, ax)

    def hardware_toml(self) -> str:
        """The file of ``--save-hardware``."""
        with self._request.arguments() as arguments:
            return str(self._report.hardware_toml(arguments))

    def _in_a_line(self) -> str:
        best = self.designs.iloc[0]
        varied = _counted((self.dimensions["routing"] == best["routing"]).sum(), "dimension")
        goal = f"{best['goal_before']:.3g} to {best['goal']:.3g}"
        return f"{best['name'] or best['routing']}, {varied}, goal from {goal}"

    def _repr_html_(self) -> str:
        return str(self.dimensions.to_html(index=False))


class Shown(SavedResult):
    """One routing in full."""

    def svg(self, grasp: Optional[int] = None) -> str:
        """Its drawing, in one of the grasps, from 0; None: the parts alone."""
        return str(self._report.svg(grasp))

    def _in_a_line(self) -> str:
        grasps = _counted(len(self.summary["grasps"]), "grasp")
        return f"{self.summary['routing']}, {grasps}"

    def _repr_svg_(self) -> str:
        return self.svg()


class Catalogue(SavedResult):
    """Known routings and mechanisms by name.

    Attributes
    ----------
    mechanisms : pandas.DataFrame
        One row for each, with its word, its source, and how many of its printed numbers agree.
    """

    @property
    def mechanisms(self) -> "pandas.DataFrame":
        import pandas

        return pandas.DataFrame(self.summary["mechanisms"])

    def _in_a_line(self) -> str:
        return _counted(len(self.summary["mechanisms"]), "mechanism")

    def _repr_html_(self) -> str:
        shown = ["family", "name", "routing", "fingers", "title"]
        return str(self.mechanisms[shown].to_html(index=False))


class Check(Result):
    """The publications' numbers, recomputed.

    Attributes
    ----------
    checks : pandas.DataFrame
        One row for each number.
    """

    @property
    def checks(self) -> "pandas.DataFrame":
        import pandas

        return pandas.DataFrame(self.summary["checks"])

    def _in_a_line(self) -> str:
        checks = self.checks
        differ = (checks["status"] == "differs").sum()
        return f"{_counted(len(checks), 'number')}, {differ} of them differ"
