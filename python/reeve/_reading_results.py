"""Results about readings: compared, diagnosed, simulated, imported."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

from . import _plots
from ._frames import read_csv
from ._model import Model, Place
from ._results import Result, SavedResult

if TYPE_CHECKING:
    import pandas

_CAUSE_COLUMNS = (
    "cause", "parameter", "value", "low", "high", "nominal", "unit", "at_bound", "literature",
    "p_value",
)


def _readings(number: int, simulated: bool) -> str:
    kind = "simulated reading" if simulated else "reading"
    return f"{number} {kind}{'' if number == 1 else 's'}"


def _label(simulated: bool) -> str:
    return "<p><b>Simulated readings.</b></p>" if simulated else ""


class Diagnosis(SavedResult):
    """What the model gets wrong about measured tensions, and why.

    Attributes
    ----------
    verdict : str
        ``"cause"``, ``"none"``, ``"unexplained"``, ``"indistinguishable"`` or ``"too_few"``.
    answer : str
        What is wrong, which cause, how much better: a few lines.
    causes : pandas.DataFrame
        One row for each parameter of each cause and law that is named;
        ``summary["laws"]`` has the parts of the laws.
    gain : dict or None
        On the runs that no fit has seen: ``rms_before``, ``rms_after``, ``reduction``, …
    next_measurement : dict or None
        What to measure next.
    residuals : pandas.DataFrame
        Each reading beside the model's, before and after.
    model : Model
        The extended one.
    simulated : bool
        Whether the readings say that they are; frames have it in ``attrs["simulated"]``.
    """

    @property
    def verdict(self) -> str:
        return str(self.summary["verdict"])

    @property
    def answer(self) -> str:
        return str(self._report.answer())

    @property
    def simulated(self) -> bool:
        return bool(self.summary["simulated"])

    @property
    def causes(self) -> "pandas.DataFrame":
        import pandas

        rows = [
            {"cause": cause["name"], "parameter": parameter.get("name")}
            | {key: value for key, value in parameter.items() if key != "name"}
            | {"p_value": cause["p_value"]}
            for cause in [*self.summary["causes"], *self.summary.get("laws", [])]
            for parameter in cause["parameters"] or [{}]
        ]
        frame = pandas.DataFrame(rows, columns=list(_CAUSE_COLUMNS))
        frame.attrs["simulated"] = self.simulated
        return frame

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
        return read_csv(self._report.residuals_csv())

    @property
    def model(self) -> Model:
        with self._request.arguments() as arguments:
            return Model(self._report.model_toml(arguments))

    def page(self, folder: Place) -> None:
        """Writes the page and the files of the program's ``--out``."""
        self.save(folder)

    def plot(self, ax: Any = None) -> Any:
        """The readings over the model's, before and after; with matplotlib.

        Returns
        -------
        matplotlib.axes.Axes
        """
        models = {"before_N": "the model as it was", "after_N": "as diagnosed"}
        return _plots.readings(self.residuals, models, "N", ax)

    def _in_a_line(self) -> str:
        causes = ", ".join(dict.fromkeys(self.causes["cause"]))
        named = f" ({causes})" if causes else ""
        return f"{self.verdict}{named}, {_readings(len(self.residuals), self.simulated)}"

    def _repr_html_(self) -> str:
        table = str(self.causes.to_html(index=False))
        return f"{_label(self.simulated)}<p>{escape(self.answer)}</p>{table}"


class Comparison(SavedResult):
    """Measured tensions beside the model's, as it stands.

    Attributes
    ----------
    residuals : pandas.DataFrame
        Each reading beside the model's; ``attrs["simulated"]`` as its file says.
    """

    @property
    def residuals(self) -> "pandas.DataFrame":
        return read_csv(self._report.residuals_csv())

    def plot(self, ax: Any = None) -> Any:
        """The tensions over the model's; with matplotlib.

        Returns
        -------
        matplotlib.axes.Axes
        """
        residuals = self.residuals
        tensions = residuals[residuals["quantity"] == "tension"]
        return _plots.readings(tensions, {"predicted": "the model"}, "N", ax)

    def _in_a_line(self) -> str:
        residuals = self.residuals
        tensions = self.summary["tension"]
        off = f", off by {tensions['all']['rms']:.3g} N rms" if tensions else ""
        return f"{_readings(len(residuals), residuals.attrs['simulated'])}{off}"

    def _repr_html_(self) -> str:
        return _label(self.residuals.attrs["simulated"]) + super()._repr_html_()


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
        return read_csv(self.csv)

    def save(self, path: Place) -> None:
        """Writes the data file."""
        Path(path).write_text(self.csv, encoding="utf-8")

    def __repr__(self) -> str:
        data = self.data
        return f"<reeve.Simulation: {_readings(len(data), True)} in {data['run'].nunique()} runs>"

    def _repr_html_(self) -> str:
        return _label(True) + str(self.data.to_html(index=False, max_rows=10))


class Power(Result):
    """What diagnoses of simulated experiments found.

    Attributes
    ----------
    findings : pandas.DataFrame
        How often what is hidden was found, and what else: ``count``, ``share`` and its 95 %
        interval, ``low`` and ``high``; ``attrs["simulated"]`` is True.
    trials : pandas.DataFrame
        One row for each experiment: its seed, its finding, the causes that were named.
    """

    def _simulated(self, rows: Any) -> "pandas.DataFrame":
        import pandas

        frame = pandas.DataFrame(rows)
        frame.attrs["simulated"] = self.summary["simulated"]
        return frame

    @property
    def findings(self) -> "pandas.DataFrame":
        findings = self.summary["findings"].items()
        return self._simulated([{"finding": name} | counted for name, counted in findings])

    @property
    def trials(self) -> "pandas.DataFrame":
        return self._simulated(self.summary["trials"])

    def _in_a_line(self) -> str:
        found = self.summary["findings"]["found"]["count"]
        return f"{self.summary['experiments']} simulated experiments, found in {found}"

    def _repr_html_(self) -> str:
        return _label(True) + str(self.findings.to_html(index=False))


class SteadyReadings(Result):
    """Steady readings out of a logger's time series.

    Attributes
    ----------
    csv : str
        The data file, as the program writes it.
    data : pandas.DataFrame
        Its rows; without any, only its columns. ``attrs["simulated"]`` as the log says.
    """

    @property
    def csv(self) -> str:
        """The data file, as the program writes it."""
        return self._request.named(str(self._report.csv()))

    @property
    def data(self) -> "pandas.DataFrame":
        """Its rows."""
        return read_csv(self.csv)

    def svg(self) -> str:
        """The drawing of ``--plot``: the signals, what was taken, what was left out and why."""
        return str(self._report.svg())

    def save(self, path: Place) -> None:
        """Writes the data file of ``-o``."""
        Path(path).write_text(self.csv, encoding="utf-8")

    def _in_a_line(self) -> str:
        data = self.data
        return f"{_readings(len(data), data.attrs['simulated'])} of {self.summary['data']['file']}"

    def _repr_svg_(self) -> str:
        return self.svg()
