"""The shape of results: frames, one line, tables and drawings."""

import math
import sys
import types

import numpy as np
import pandas as pd
import pytest
import reeve

READINGS = "catalog/measured/exo_glove_ii.csv"


@pytest.fixture(scope="module")
def diagnosis(request):
    return reeve.diagnose(request.path.parents[2] / READINGS, replicates=400)


@pytest.fixture(scope="module")
def simulated():
    return reeve.simulate(["TR1", "TR7"], runs=2, rows=3)


@pytest.fixture(scope="module")
def sized():
    return reeve.size("TR5", "TR7", vary=["sheath_angle=3..9"], nominal=True, starts=1,
                      evaluations=50)


def test_one_line_says_what_it_is(diagnosis, simulated, sized):
    found = reeve.explore(fingers=2, parts="full")
    counted = found.summary["evaluated"]
    assert repr(found) == f"<reeve.Exploration: 2 fingers, {counted} designs, 3 on the front>"
    assert repr(reeve.rank("TR1", "TR7")) == "<reeve.Ranking: 2 designs, TR7 first>"
    assert repr(diagnosis) == (
        "<reeve.Diagnosis: indistinguishable (sheath_friction, tube_friction, "
        "law[exponent of tube 3 of M-1-T-2-F]), 28 readings>")
    assert repr(simulated) == "<reeve.Simulation: 6 simulated readings in 2 runs>"
    assert repr(reeve.compare(simulated.data)).startswith(
        "<reeve.Comparison: 24 simulated readings, off by ")
    assert repr(sized).startswith("<reeve.Sizing: TR7, 2 dimensions, goal from 0.322 to 0.5")
    assert repr(reeve.show("TR5")) == "<reeve.Shown: M-1-P-2-M, 3 grasps>"
    assert repr(reeve.check(family="paper")).endswith(" numbers, 0 of them differ>")


def test_a_front_is_the_first_front():
    ranked = reeve.rank("TR1", "TR2", "TR3", "TR7", objectives=["uniformity", "sheaths"])
    assert list(ranked.front["name"]) == ["TR7", "TR3", "TR1"]
    assert list(ranked.designs["front"]) == [1, 1, 1, 2]


def of_summary(kind, residuals="", **summary):
    """A result of which nothing but its summary and residuals is known."""
    result = kind.__new__(kind)
    result._summary = {"simulated": False, **summary}
    result._report = types.SimpleNamespace(residuals_csv=lambda: residuals)
    return result


def test_a_cause_has_a_row_for_each_parameter_and_one_without_any():
    found = of_summary(reeve.Diagnosis, "run,T\nA,1\n", verdict="cause", causes=[
        {"name": "wrong_grasp[TR1]", "parameters": [], "p_value": 0.01},
        {"name": "wear", "parameters": [{"name": "depth"}, {"name": "cycles"}], "p_value": 0.02},
    ])
    assert found.causes["cause"].tolist() == ["wrong_grasp[TR1]", "wear", "wear"]
    assert found.causes["parameter"].tolist() == [None, "depth", "cycles"]
    assert found.causes["p_value"].tolist() == [0.01, 0.02, 0.02]
    assert repr(found) == "<reeve.Diagnosis: cause (wrong_grasp[TR1], wear), 1 reading>"


def test_a_power_counts_what_it_found():
    findings = {"found": {"count": 2}, "none": {"count": 3}}
    power = of_summary(reeve.Power, experiments=5, findings=findings)
    assert repr(power) == "<reeve.Power: 5 simulated experiments, found in 2>"
    assert power.findings["finding"].tolist() == ["found", "none"]


def test_a_comparison_is_off_by_its_rms(simulated):
    compared = reeve.compare(simulated.data)
    rms = compared.summary["tension"]["all"]["rms"]
    assert repr(compared).endswith(f", off by {rms:.3g} N rms>")


def test_what_is_saved_is_afterwards_called_as_before(simulated, tmp_path):
    compared = reeve.compare(simulated.data)
    before = str(compared)
    compared.save(tmp_path / "out")
    assert str(compared) == before and before.startswith("data: ")


def test_a_part_of_an_exploration_says_so():
    found = of_summary(reeve.Exploration)
    found._report = types.SimpleNamespace(
        fingers=lambda: 1, evaluated=lambda: 5, front=lambda: {"rank": [1]},
        partial=lambda: "it was stopped")
    assert repr(found) == "<reeve.Exploration: 1 finger, 5 designs, 1 on the front, partial>"


def test_sizes_are_frames(sized):
    designs, dimensions = sized.designs, sized.dimensions
    assert list(designs["rank"]) == [1, 2] and list(designs["name"]) == ["TR7", "TR5"]
    assert (designs["goal"] > designs["goal_before"]).all()
    assert designs.attrs["units"]["uniformity_mean"] == "1"
    # The goal is their product, of means.
    product = designs["uniformity_mean"] * designs["efficiency_mean"]
    assert designs["goal"].to_numpy() == pytest.approx(product.to_numpy())
    assert list(dimensions["dimension"]) == ["sheath_angle[1]", "sheath_angle[2]"] * 2
    assert (dimensions["low"] == 3).all() and (dimensions["high"] == 9).all()
    assert dimensions["sized"].between(3, 9).all()
    of = [of for design in sized.summary["designs"] for of in design["dimensions"]]
    for side in ("less", "more"):
        assert dimensions[f"tolerance_{side}"].tolist() == pytest.approx(
            [one["tolerance"][side] or math.nan for one in of], nan_ok=True)


def test_causes_have_their_columns_where_there_are_none(diagnosis, simulated):
    none = reeve.diagnose(simulated.data, replicates=400)
    assert none.verdict == "none" and len(none.causes) == 0
    assert list(none.causes.columns) == list(diagnosis.causes.columns)
    assert "value" in none.causes and diagnosis.causes["value"].notna().all()


def test_what_is_simulated_stays_so(simulated, diagnosis):
    for result in (reeve.compare(simulated.data), reeve.diagnose(simulated.data, replicates=400)):
        assert result.residuals.attrs["simulated"]
        assert "simulated" in repr(result) and "imulated" in result._repr_html_()
    assert reeve.diagnose(simulated.data, replicates=400).causes.attrs["simulated"]
    assert not diagnosis.residuals.attrs["simulated"]
    assert "imulated" not in diagnosis._repr_html_()


def test_tables_in_a_notebook(diagnosis, sized):
    ranked = reeve.rank("TR1", "TR7")._repr_html_()
    assert ranked.count("<table") == 2 and "Best design for each number of parts" in ranked
    assert ranked.split("<p>")[0].count("<tr>") == 2
    assert "sheath_friction" in diagnosis._repr_html_()
    assert "sheath_angle[1]" in sized._repr_html_()
    assert reeve.Routing("TR5")._repr_svg_().startswith("<svg")
    shown = reeve.show("TR5")
    assert shown._repr_svg_().startswith("<svg")
    assert len({shown.svg(), shown.svg(0), shown.svg(1), shown.svg(2)}) == 4


@pytest.fixture
def drawing():
    matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    matplotlib.use("Agg")
    yield
    import matplotlib.pyplot

    matplotlib.pyplot.close("all")


def points(ax):
    """Of each label, how many points stand under it."""
    return {c.get_label(): len(c.get_offsets()) for c in ax.collections if hasattr(c, "get_offsets")}


def test_designs_are_drawn(drawing):
    found = reeve.explore(fingers=2)
    ax = found.plot(x="sheaths")
    assert points(ax) == {"designs": len(found.designs), "front": len(found.front)}
    drawn = ax.collections[1].get_offsets().data
    assert (drawn == found.front[["sheaths", "efficiency_mean"]].to_numpy()).all()
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("sheaths (parts)", "efficiency_mean")
    assert found.plot(ax=ax) is ax
    with pytest.raises(reeve.InputError, match="x 'mass': expected one of"):
        found.plot(x="mass")


def test_readings_are_drawn(drawing, diagnosis, simulated):
    ax = diagnosis.plot()
    assert points(ax) == {"the model as it was": 28, "as diagnosed": 28}
    assert ax.get_ylabel() == "measured (N)" and ax.get_title() == ""
    ax = reeve.compare(simulated.data).plot()
    assert ax.get_ylabel() == "simulated (N)" and ax.get_title() == "simulated readings"
    drawn = pd.DataFrame(ax.collections[0].get_offsets().data, columns=["predicted", "measured"])
    residuals = reeve.compare(simulated.data).residuals
    assert (drawn["measured"].to_numpy() == residuals["measured"].to_numpy()).all()
    data = simulated.data
    data.loc[:2, "motor_tension_N"] = None  # rows of shares, which are no newtons
    compared = reeve.compare(data)
    tensions = (compared.residuals["quantity"] == "tension").sum()
    assert 0 < tensions < len(compared.residuals)
    assert points(compared.plot()) == {"the model": tensions}


def test_dimensions_are_drawn(drawing, sized):
    ax = sized.plot()
    labels = [label.get_text() for label in ax.get_yticklabels()]
    assert labels == ["sheath_angle[1], 3 to 9 rad", "sheath_angle[2], 3 to 9 rad"]
    before = next(c for c in ax.collections if c.get_label() == "before").get_offsets().data
    assert before[:, 0] == pytest.approx((2 * 3.141592653589793 - 3) / 6)
    best = sized.dimensions[:2]
    line, _, (tolerances,) = ax.containers[0]
    assert np.allclose(line.get_xdata().astype(float), (best["sized"] - 3) / 6)
    ends = np.array([part[:, 0] for part in tolerances.get_segments()])
    low = best["sized"] - best["tolerance_less"].fillna(0)
    high = best["sized"] + best["tolerance_more"].fillna(0)
    assert np.allclose(ends[:, 0], (low - 3) / 6) and np.allclose(ends[:, 1], (high - 3) / 6)


def test_without_matplotlib_an_error_names_it(monkeypatch, sized, diagnosis):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    for result in (reeve.rank("TR1"), sized, diagnosis):
        with pytest.raises(ImportError, match="plot.. needs matplotlib, which is not installed"):
            result.plot()
