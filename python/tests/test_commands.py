"""The subcommands: the program's files, names, defaults and complaints."""

import _thread
import doctest
import filecmp
import inspect
import json
import re
import threading
import time

import numpy as np
import pandas as pd
import pytest
import reeve
from reeve import _core

# What only a shell or a file has: printing, and where things are written.
OF_THE_SHELL = {
    "out", "format", "columns", "text-width", "svg", "output", "plot", "save-model",
    "save-hardware", "power", "set",
}
OTHERWISE = {"constraints": "constraint", "from_": "from"}
# import is a word of the language.
COMMANDS = {"import_log": "import"} | {
    name: name
    for name in ("explore", "merge", "rank", "size", "diagnose", "compare", "show", "count",
                 "check", "simulate")
}


@pytest.mark.parametrize("name", COMMANDS)
def test_names_and_defaults_are_the_programs(name):
    options = {text[0]: text for text in _core.options(COMMANDS[name])}
    function = getattr(reeve, name)
    parameters = inspect.signature(function).parameters
    ours = {OTHERWISE.get(p, p).replace("_", "-") for p in parameters if p != "progress"}
    ours -= {"routings"} - set(options)  # the positional is called routing
    assert ours - {"routing"} == set(options) - OF_THE_SHELL - {"routing"}
    for parameter in parameters.values():
        option = options.get(OTHERWISE.get(parameter.name, parameter.name).replace("_", "-"))
        if option is None or not option[1] or option[3]:
            continue
        assert parameter.default is None  # left to the program
        said = re.search(rf"\n    {parameter.name} : .*\n((?:        .*\n)+)", function.__doc__)
        assert f"Default: {option[1]}." in re.sub(r"\s+", " ", said.group(1)), parameter.name


def different(one, other):
    """The files of two folders that do not have the same bytes."""
    ours = sorted(p.relative_to(one) for p in one.rglob("*") if p.is_file())
    assert ours == sorted(p.relative_to(other) for p in other.rglob("*") if p.is_file())
    return [str(name) for name in ours if not filecmp.cmp(one / name, other / name, shallow=False)]


def test_an_exploration_saves_what_the_program_writes(program, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = reeve.explore(fingers=2, parts="paper", constraints=["sheaths<=2"], draws=20,
                          uncertainty=True, objectives=["uniformity", "efficiency"])
    found.save("out")
    (tmp_path / "out").rename(tmp_path / "ours")
    program("explore", "--fingers", "2", "--parts", "paper", "--constraint", "sheaths<=2",
            "--uncertainty", "--draws", "20", "--objectives", "uniformity,efficiency",
            "--out", "out", folder=tmp_path)
    assert set(different(tmp_path / "ours", tmp_path / "out")) <= {"summary.json"}
    summaries = [json.loads((tmp_path / f / "summary.json").read_text()) for f in ("ours", "out")]
    for summary in summaries:
        for how_fast in ("seconds", "designs_per_second"):
            summary.pop(how_fast)
    assert summaries[0] == summaries[1]
    written = pd.read_csv(tmp_path / "out/designs.csv", comment="#")
    written.pop("exploration")  # which says to which files the file belongs
    frame = found.designs
    assert list(frame.columns) == list(written.columns)
    for name in frame.columns:
        if frame[name].dtype == object:
            assert list(frame[name]) == list(written[name].fillna("")), name
        else:
            assert np.array_equal(frame[name], written[name], equal_nan=True), name
    assert frame.attrs["units"]["uniformity_mean"] == "1"
    assert list(found.front["routing"]) == list(
        pd.read_csv(tmp_path / "out/pareto.csv", comment="#")["routing"]
    )


def test_a_ranking_saves_what_the_program_writes(program, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    ranked = reeve.rank("TR1", reeve.Routing("TR7"), mu="0.18")
    ranked.save("out")
    (tmp_path / "out").rename(tmp_path / "ours")
    program("rank", "TR1", "1-P-2-P-1", "--mu", "0.18", "--out", "out", folder=tmp_path)
    assert different(tmp_path / "ours", tmp_path / "out") == []
    assert list(ranked.designs["name"]) == ["TR7", "TR1"]


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
    assert found.verdict == "cause"
    assert list(found.causes["cause"]) == ["tube_friction", "sheath_friction"]
    assert found.gain["reduction"] > 0.8
    assert found.answer.startswith("The friction coefficient of the tubes")
    of_a_frame = reeve.diagnose(pd.read_csv(path, comment="#"), replicates=400)
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


def test_a_frame_is_the_file_that_it_was_read_from():
    made = reeve.simulate(["TR1", "TR7"], runs=2, rows=4)
    assert made.data["held"].dtype.kind == "f"  # grasps with empty cells among them
    compared = reeve.compare(made.data)
    assert compared.summary["data"]["simulated"]
    assert len(compared.residuals) > 0


def test_counts_and_checks(program):
    counts = json.loads(program("count", "--fingers", "4", "--format", "json"))
    assert reeve.count(fingers=4)._asdict() == counts
    checked = reeve.check(family="paper")
    assert (checked.checks["status"] != "differs").all()


def test_complaints_are_the_programs(program):
    for call, command in [
        (lambda: reeve.explore(constraints=["sheathes<=2"]), ["explore", "--constraint", "sheathes<=2"]),
        (lambda: reeve.explore(fingers=99), ["explore", "--fingers", "99"]),
        (lambda: reeve.rank("TR9"), ["rank", "TR9"]),
    ]:
        with pytest.raises(reeve.InputError) as caught:
            call()
        said = program(*command, check=False).stderr
        known = str(caught.value).split(": ", 1)[-1] if "99" in command else str(caught.value)
        assert known.split("\n")[0][:60] in said


def test_ctrl_c_within_a_second_gives_what_there_is():
    when = {}

    def press():
        when["pressed"] = time.monotonic()
        _thread.interrupt_main()

    timer = threading.Timer(0.7, press)
    timer.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        reeve.explore(fingers=6, parts="all", blocks=2)
    assert time.monotonic() - when["pressed"] < 1
    assert isinstance(caught.value, reeve.Interrupted)
    assert caught.value.result.partial and len(caught.value.result.designs) > 0


def test_progress_is_told_and_what_it_raises_is_raised():
    told = []
    with pytest.raises(ZeroDivisionError):
        def listen(stage, done, total):
            told.append((stage, done, total))
            if len(told) == 2:
                1 / 0
        reeve.explore(fingers=6, parts="all", progress=listen)
    assert told and all(done <= total for _, done, total in told)


def test_drawings():
    assert reeve.Routing("TR5")._repr_svg_().startswith("<svg")
    assert "<table" in reeve.rank("TR1", "TR7")._repr_html_()


def test_doctests():
    for module in (_core, reeve._exploring, reeve._ranking, reeve._tensions):
        found = doctest.testmod(module)
        assert found.attempted and not found.failed
