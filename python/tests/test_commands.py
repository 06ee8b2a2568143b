"""The subcommands: the program's files, names, defaults and complaints."""

import doctest
import inspect
import json
import math
import re

import pandas as pd
import pytest
import reeve
from reeve import _core

# What only a shell or a file has: printing, and where things are written.
OF_THE_SHELL = {
    "help", "out", "format", "columns", "text-width", "svg", "output", "plot", "save-model",
    "save-hardware", "power", "set", "guess",
}
# import is a word of the language.
COMMANDS = {"import_log": "import", "power": "simulate"} | {
    name: name
    for name in ("explore", "merge", "rank", "size", "diagnose", "compare", "show", "count",
                 "check", "catalogue", "simulate")
}


# "  --fingers INT:INT in [1 - 64]=2", "  --tendons TEXT:{one,any}=any": name and default.
OPTION = re.compile(
    r"^  (?:-\w,)?--([a-z-]+)(?: [A-Z]+(?::[A-Z]+ in \[.*?\]|:\{.*?\})?(?:=(\S+))?)?", re.MULTILINE)


@pytest.mark.parametrize("name", COMMANDS)
def test_keywords_and_defaults_are_those_of_the_help(name, program):
    options = {{"from": "from_", "constraint": "constraints"}.get(o, o).replace("-", "_"): default
               for o, default in OPTION.findall(program(COMMANDS[name], "--help"))
               if o not in OF_THE_SHELL | {"routings"}}
    parameters = inspect.signature(getattr(reeve, name)).parameters
    keywords = {p.name: p for p in parameters.values() if p.kind == p.KEYWORD_ONLY}
    assert keywords.keys() - {"progress"} == options.keys()
    doc = inspect.getdoc(getattr(reeve, name))
    for option, default in options.items():
        assert keywords[option].default in (None, False)  # left to the program
        (text,) = re.findall(rf"^{option} : .+\n((?:    .*\n)+)", doc, re.MULTILINE)
        told = re.findall(r"Default: (.*)\.$", re.sub(r"\s+", " ", text).strip())
        assert told == ([default] if default else []), option


def test_options_that_may_be_given_again_take_lists():
    again = {name for command in COMMANDS.values()
             for name, _, _, kind in _core.options(command) if kind == "list"}
    assert again - {"routing", "folders", "cause", "set"} == reeve._request._REPEATED


def test_objects_stand_for_files(tmp_path):
    hardware = reeve.Hardware(tube_mu=0.05, sheath_mu=0.02)
    (tmp_path / "h.toml").write_text(hardware.to_toml())
    ranked = reeve.rank("TR1", "TR7", hardware=hardware)
    assert ranked.summary["designs"] == reeve.rank(
        "TR1", "TR7", hardware=tmp_path / "h.toml").summary["designs"]
    ranked.save(tmp_path / "out")
    assert reeve.Hardware.from_toml(tmp_path / "out/hardware.toml") == hardware
    assert f"--hardware {tmp_path}/out/hardware.toml" in (tmp_path / "out/index.html").read_text()


def test_a_diagnosis_of_the_published_readings(root, tmp_path):
    path = root / "catalog/measured/exo_glove_ii.csv"
    found = reeve.diagnose(path, replicates=400)
    assert found.verdict == "indistinguishable"  # what one reading of TR1 is
    assert list(found.causes["cause"])[:2] == ["sheath_friction", "tube_friction"]
    assert found.gain["reduction"] > 0.8
    assert found.answer.startswith("The friction coefficient of the sheaths")
    of_a_frame = reeve.diagnose(pd.read_csv(path, comment="#"), replicates=400)
    for cause in [*found.summary["causes"], *of_a_frame.summary["causes"]]:
        del cause["partial_residuals"]["points"]["line"]  # a frame has no lines of comments
    assert of_a_frame.summary["causes"] == found.summary["causes"]
    of_a_frame.page(tmp_path / "page")
    assert (tmp_path / "page/data.csv").exists()
    assert "tube" in found.model.to_toml()
    # The model that was found is one to explore by.
    assert reeve.rank("TR1", "TR7", model=found.model).designs["rank"][0] == 1


def test_simulated_readings_say_so():
    made = reeve.simulate(["TR1", "TR7"], runs=2, rows=2,
                          cause={"sensor_gain[T3]": {"gain": 1.08}})
    assert made.data.attrs["simulated"] and "simulated" in made.csv.split("\n")[0].lower()
    assert len(made.data) == 4
    assert "sensor_gain[T3]" in made.csv


def test_the_power_of_an_experiment_is_the_programs(program):
    planned = {"runs": 6, "rows": 10, "cause": {"sensor_gain[T3]": {"gain": 1.3}}}
    found = reeve.power(2, ["TR1", "TR7"], **planned)
    said = json.loads(program(
        "simulate", "--routings", "TR1,TR7", "--cause", "sensor_gain[T3]", "--set", "gain=1.3",
        "--runs", "6", "--rows", "10", "--power", "2", "--format", "json"))
    said["settings"].pop("command")
    ours = dict(found.summary, settings=dict(found.summary["settings"]))
    ours["settings"].pop("command")
    assert ours == said
    assert repr(found) == "<reeve.Power: 2 simulated experiments, found in 2>"
    assert found.findings.attrs["simulated"] and found.trials["seed"].tolist() == [1, 2]
    with pytest.raises(TypeError, match="unexpected keyword argument 'tows'"):
        reeve.power(3, "TR1", tows=10)
    with pytest.raises(TypeError, match="^rows: expected int"):
        reeve.power(3, "TR1", rows="10")


def test_counts_and_checks(program):
    counts = json.loads(program("count", "--fingers", "4", "--format", "json"))
    assert reeve.count(fingers=4)._asdict() == {**counts, "meeting": None, "meeting_one_tendon": None}
    counts = json.loads(program("count", "--constraint", "sheaths<=2", "--constraint", "knots<=0",
                                "--format", "json"))
    counts.pop("constraints")
    assert reeve.count(constraints=["sheaths<=2", "knots<=0"])._asdict() == counts
    checked = reeve.check(family="paper")
    assert (checked.checks["status"] != "differs").all()


def test_the_catalog_by_name(program):
    listed = reeve.catalogue(fingers=4)
    told = json.loads(program("catalogue", "--fingers", "4", "--format", "json"))
    assert list(listed.mechanisms["name"]) == [entry["name"] for entry in told["mechanisms"]]
    assert set(listed.mechanisms["fingers"]) == {4}
    with pytest.raises(reeve.InputError, match="^--fingers"):
        reeve.catalogue(fingers=60)


def test_drawings():
    assert reeve.Routing("TR5")._repr_svg_().startswith("<svg")
    assert "<table" in reeve.rank("TR1", "TR7")._repr_html_()


def test_doctests():
    for module in (_core, reeve._methods, reeve._commands, reeve._tensions):
        found = doctest.testmod(module)
        assert found.attempted and not found.failed


def test_simulate_hides_laws_of_further_columns():
    law = {"law[exponent of sheath, humidity_pct, linear]": {"a": 0.0083}}
    made = reeve.simulate("TR1", runs=2, rows=4, cause=law, run_column="supply_V=22,24",
                          column=["humidity_pct=20:80", "dwell_s=1,2"])
    assert list(made.data.columns[5:8]) == ["humidity_pct", "dwell_s", "supply_V"]
    assert made.data["supply_V"].groupby(made.data["run"]).nunique().eq(1).all()
    assert "(a = 0.0083, middle = 50, range = 20:80)" in made.csv


def test_a_model_with_a_law_is_one_of_designs():
    law = """
[[law]]
acts_on = "exponent"
site = "sheath"
form = "linear"
covariate = "humidity_pct"
middle = 50
range = [20, 80]
a = 0.01
[conditions]
humidity_pct = 70
"""
    model = reeve.rank("TR1", model=reeve.Model(law)).designs
    plain = reeve.rank("TR1").designs
    expected = plain["efficiency_mean"] * math.exp(-0.36 * math.pi * 0.2)
    assert model["efficiency_mean"].to_numpy() == pytest.approx(expected.to_numpy())
