"""Results as drawings of matplotlib, where it is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .errors import InputError

if TYPE_CHECKING:
    import pandas


def _axes(ax: Any) -> Any:
    try:
        import matplotlib.pyplot
    except ImportError:
        raise ImportError(
            "plot() needs matplotlib, which is not installed "
            "(Debian: python3-matplotlib; pip: matplotlib)"
        ) from None
    return matplotlib.pyplot.subplots()[1] if ax is None else ax


def _label(frame: "pandas.DataFrame", name: str) -> str:
    unit = frame.attrs["units"].get(name, "1")
    return name if unit == "1" else f"{name} ({unit})"


def two_columns(
    designs: "pandas.DataFrame", front: "pandas.DataFrame", x: str, y: str, ax: Any
) -> Any:
    """Two objectives against each other, the front marked."""
    ax = _axes(ax)
    for what, name in (("x", x), ("y", y)):
        if name not in designs:
            known = "one of " + ", ".join(designs.select_dtypes("number").columns)
            raise InputError(
                f"{what} '{name}': expected {known}", what=what, value=name, expected=known
            )
    ax.scatter(designs[x], designs[y], color="lightgray", label="designs")
    ax.scatter(front[x], front[y], color="tab:red", label="front")
    ax.set_xlabel(_label(designs, x))
    ax.set_ylabel(_label(designs, y))
    ax.legend()
    return ax


def readings(residuals: "pandas.DataFrame", models: dict[str, str], unit: str, ax: Any) -> Any:
    """What was measured over what each model says; ``models`` are columns and labels."""
    ax = _axes(ax)
    measured = next(name for name in residuals if str(name).startswith("measured"))
    for colour, (column, label) in zip(("lightgray", "tab:red"), models.items()):
        ax.scatter(residuals[column], residuals[measured], color=colour, label=label)
    columns = [measured, *models]
    low, high = residuals[columns].min().min(), residuals[columns].max().max()
    ax.plot([low, high], [low, high], color="black", linewidth=0.8)
    simulated = residuals.attrs["simulated"]
    ax.set_xlabel(f"model ({unit})")
    ax.set_ylabel(f"{'simulated' if simulated else 'measured'} ({unit})")
    if simulated:
        ax.set_title("simulated readings")
    ax.legend()
    return ax


def dimensions(sized: "pandas.DataFrame", ax: Any) -> Any:
    """Where in its bounds each dimension is, before and sized, with its tolerance."""
    ax = _axes(ax)
    width = (sized["high"] - sized["low"]).where(lambda bounds: bounds > 0, 1)
    share = (sized["sized"] - sized["low"]) / width
    less = (sized["tolerance_less"] / width).fillna(0)
    more = (sized["tolerance_more"] / width).fillna(0)
    rows = range(len(sized))
    ax.hlines(rows, 0, 1, color="lightgray", linewidth=6, label="bounds")
    before = (sized["before"] - sized["low"]) / width
    ax.scatter(before, rows, facecolor="none", edgecolor="black", label="before")
    ax.errorbar(
        share, rows, xerr=[less, more], color="tab:red", fmt="o", capsize=3, label="sized"
    )
    ax.set_yticks(
        rows,
        [
            f"{row.dimension}, {row.low:g} to {row.high:g} {row.unit}"
            for row in sized.itertuples()
        ],
    )
    ax.set_xlabel("from the least to the greatest that it may be")
    ax.legend()
    return ax
