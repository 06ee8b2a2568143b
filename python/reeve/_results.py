"""Results of the subcommands, as data frames, dictionaries and drawings."""

from __future__ import annotations

import io
import json
import warnings
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Callable, Optional, TypeVar, Union

from . import _core
from ._model import Model
from ._progress import Progress, close, listener
from ._request import Request
from .errors import Interrupted, Notice

if TYPE_CHECKING:
    import pandas

Place = Union[str, "PathLike[str]"]


def _frame(columns: dict[str, Any]) -> "pandas.DataFrame":
    """With the objectives' units in its ``attrs``."""
    import pandas

    frame = pandas.DataFrame(columns)
    units = _core.objective_units()
    frame.attrs["units"] = {name: units[name] for name in frame.columns if name in units}
    return frame


def _read(csv: str) -> "pandas.DataFrame":
    import pandas

    frame = pandas.read_csv(io.StringIO(csv), comment="#")
    frame.attrs["simulated"] = csv.startswith("#") and "simulated" in csv.split("\n", 1)[0]
    return frame


class Result:
    """What a subcommand found.

    Attributes
    ----------
    summary : dict
        As the program's ``--format json`` prints it; docs/json.md has its keys.
    """

    def __init__(self, report: Any, request: Request) -> None:
        self._report = report
        self._request = request
        self._summary: Optional[dict[str, Any]] = None

    @property
    def summary(self) -> dict[str, Any]:
        if self._summary is None:
            self._summary = json.loads(self._report.json())
        return self._summary

    def save(self, folder: Place) -> None:
        """Writes the files and the page of the program's ``--out``, byte by byte.

        What was given as an object (a `Hardware`, a data frame) is put there as a file too, so
        that the command on the page can be run again.
        """
        self._report.save(self._request.arguments_for(fspath(folder)))

    def __str__(self) -> str:
        return str(self._report.text())

    def _repr_html_(self) -> str:
        from html import escape

        return f"<pre>{escape(str(self))}</pre>"


Kind = TypeVar("Kind", bound=Result)


def run(
    kind: Callable[[Any, Request], Kind], study: Any, request: Request, progress: Progress
) -> Kind:
    """The result of a study that can be interrupted."""
    hears = listener(progress)
    try:
        with request.arguments() as arguments:
            report, interrupted = study(arguments, hears)
    finally:
        close(hears)
    result = None if report is None else kind(report, request)
    if interrupted:
        raise Interrupted(result)
    if result is None:
        raise Interrupted()
    for note in result.summary.get("notes") or []:
        text = note.get("text", str(note)) if isinstance(note, dict) else str(note)
        warnings.warn(text, Notice, stacklevel=3)
    return result


class Ranking(Result):
    """Designs, best first.

    Attributes
    ----------
    designs : pandas.DataFrame
        The columns of designs.csv (docs/json.md); units in ``attrs["units"]``.
    front : pandas.DataFrame
        Those that no other beats in every objective.
    ladder : pandas.DataFrame
        What more parts buy.
    """

    @property
    def designs(self) -> "pandas.DataFrame":
        return _frame(self._report.designs())

    @property
    def front(self) -> "pandas.DataFrame":
        designs = self.designs
        return designs[designs["front"] == 1]

    @property
    def ladder(self) -> "pandas.DataFrame":
        import pandas

        return pandas.json_normalize((self.summary.get("ladder") or {}).get("rungs") or [])

    def plot(self, x: str = "uniformity_mean", y: str = "efficiency_mean", ax: Any = None) -> Any:
        """Two objectives of the designs against each other, the front marked; with matplotlib.

        Returns
        -------
        matplotlib.axes.Axes
        """
        designs, front = self.designs, self.front
        ax = designs.plot.scatter(x, y, color="lightgray", ax=ax, label="designs")
        front.plot.scatter(x, y, color="tab:red", ax=ax, label="front")
        units = designs.attrs["units"]
        for label, name in ((ax.set_xlabel, x), (ax.set_ylabel, y)):
            label(name if units.get(name, "1") == "1" else f"{name} ({units[name]})")
        return ax

    def _repr_html_(self) -> str:
        shown = ["rank", "front", "name", "routing"]
        shown += ["uniformity_mean", "efficiency_mean", "sheaths"]
        designs = self.designs
        table = designs[[name for name in shown if name in designs]].head(10)
        html = str(table.to_html(index=False))
        ladder = self.ladder
        if len(ladder):
            html += "<p>What more parts buy:</p>" + str(ladder.to_html(index=False))
        return html


class Exploration(Ranking):
    """Every routing that a set of parts allows, best first.

    Attributes
    ----------
    partial : str
        Why it is not all of them; empty if it is.
    """

    @property
    def front(self) -> "pandas.DataFrame":
        return _frame(self._report.front())

    @property
    def partial(self) -> str:
        return str(self._report.partial())


class Sizing(Result):
    """Dimensions that suit a goal best.

    Attributes
    ----------
    designs : list of dict
        The routings sized, best first.
    """

    @property
    def designs(self) -> list[dict[str, Any]]:
        return list(self.summary["designs"])

    def hardware_toml(self) -> str:
        """The file of ``--save-hardware``."""
        with self._request.arguments() as arguments:
            return str(self._report.hardware_toml(arguments))


class Diagnosis(Result):
    """What the model gets wrong about measured tensions, and why.

    Attributes
    ----------
    verdict : str
        ``"cause"``, ``"none"``, ``"unexplained"``, ``"indistinguishable"`` or ``"too_few"``.
    answer : str
        What is wrong, which cause, how much better: a few lines.
    causes : pandas.DataFrame
        One row for each parameter of each cause that is named.
    gain : dict or None
        On the runs that no fit has seen: ``rms_before``, ``rms_after``, ``reduction``, …
    next_measurement : dict or None
        What to measure next.
    residuals : pandas.DataFrame
        Each reading beside the model's, before and after.
    model : Model
        The extended one.
    """

    @property
    def verdict(self) -> str:
        return str(self.summary["verdict"])

    @property
    def answer(self) -> str:
        return str(self._report.answer())

    @property
    def causes(self) -> "pandas.DataFrame":
        import pandas

        rows = [
            {"cause": cause["name"], "parameter": parameter["name"]}
            | {key: value for key, value in parameter.items() if key != "name"}
            | {"p_value": cause["p_value"]}
            for cause in self.summary["causes"]
            for parameter in cause["parameters"]
        ]
        return pandas.DataFrame(rows)

    @property
    def gain(self) -> Optional[dict[str, Any]]:
        gain: Optional[dict[str, Any]] = self.summary["held_out"]
        return gain

    @property
    def next_measurement(self) -> Optional[dict[str, Any]]:
        planned: Optional[dict[str, Any]] = self.summary["next_measurement"]
        return planned

    @property
    def residuals(self) -> "pandas.DataFrame":
        return _read(self._report.residuals_csv())

    @property
    def model(self) -> Model:
        with self._request.arguments() as arguments:
            return Model(self._report.model_toml(arguments))

    def page(self, folder: Place) -> None:
        """Writes the page and the files of the program's ``--out``."""
        self.save(folder)

    def save(self, folder: Place) -> None:
        for name in self._request.file_names():
            if name == "data.csv":
                self._report.call_data(f"{fspath(folder)}/{name}")
        super().save(folder)

    def _repr_html_(self) -> str:
        from html import escape

        return f"<p>{escape(self.answer)}</p>" + str(self.causes.to_html(index=False))


class Comparison(Result):
    """Measured tensions beside the model's, as it stands.

    Attributes
    ----------
    residuals : pandas.DataFrame
    """

    @property
    def residuals(self) -> "pandas.DataFrame":
        return _read(self._report.residuals_csv())


class Shown(Result):
    """One routing in full."""

    def svg(self, grasp: Optional[int] = None) -> str:
        """Its drawing, in one of the grasps, from 0; None: the parts alone."""
        return str(self._report.svg(grasp))

    def _repr_svg_(self) -> str:
        return self.svg()


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


class Simulation:
    """Simulated readings of a planned experiment.

    Attributes
    ----------
    csv : str
        The data file, as the program writes it; comment lines say that it is simulated, and how.
    data : pandas.DataFrame
        Its rows; ``attrs["simulated"]`` is True.
    """

    def __init__(self, csv: str) -> None:
        self.csv = csv

    @property
    def data(self) -> "pandas.DataFrame":
        frame = _read(self.csv)
        frame.attrs["simulated"] = True
        return frame

    def save(self, path: Place) -> None:
        """Writes the data file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.csv)

    def _repr_html_(self) -> str:
        return "<p><b>Simulated.</b></p>" + str(self.data.to_html(index=False, max_rows=10))
