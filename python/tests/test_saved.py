"""What results save: the program's files, byte for byte."""

import filecmp
import json
import sqlite3

import numpy as np
import pandas as pd
import pytest
import reeve


def different(one, other):
    """The files of two folders that do not have the same bytes."""
    ours = sorted(p.relative_to(one) for p in one.rglob("*") if p.is_file())
    assert ours == sorted(p.relative_to(other) for p in other.rglob("*") if p.is_file())
    return [str(name) for name in ours if not filecmp.cmp(one / name, other / name, shallow=False)]


def timeless(file):
    """Its values but for the work that it took."""
    values = json.loads(file.read_text())
    own = ("seconds", "designs_per_second", "designs_visited", "beginnings_visited")
    return {k: v for k, v in values.items() if k not in own}


@pytest.fixture
def saved(program, tmp_path, monkeypatch):
    """Saves a result, has the program write its own, and compares the folders."""
    monkeypatch.chdir(tmp_path)

    def compare(result, *command, timed=None):
        result.save("out")
        (tmp_path / "out").rename(tmp_path / "ours")
        program(*command, "--out", "out", folder=tmp_path)
        ours, theirs = tmp_path / "ours", tmp_path / "out"
        names = different(ours, theirs)
        assert set(names) <= {timed}
        if timed:
            assert timeless(ours / timed) == timeless(theirs / timed)
        return theirs

    return compare


def test_an_exploration(saved):
    found = reeve.explore(fingers=2, parts="paper", constraints=["sheaths<=2"], draws=20,
                          uncertainty=True, objectives=["uniformity", "efficiency"])
    out = saved(found, "explore", "--fingers", "2", "--parts", "paper", "--constraint",
                "sheaths<=2", "--uncertainty", "--draws", "20", "--objectives",
                "uniformity,efficiency", timed="summary.json")
    written = pd.read_csv(out / "designs.csv", comment="#")
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
        pd.read_csv(out / "pareto.csv", comment="#")["routing"]
    )


def test_a_ranking(saved):
    saved(reeve.rank("TR1", reeve.Routing("TR7"), distribution_mu="0.18"),
          "rank", "TR1", "1-P-2-P-1", "--distribution-mu", "0.18")


def test_a_routing(saved):
    saved(reeve.show("TR5", held=[[1], [1, 2]], direction="release"),
          "show", "TR5", "--held", "1", "--held", "1,2", "--direction", "release")


def test_the_catalog(saved):
    saved(reeve.catalogue(family="paper"), "catalogue", "--family", "paper")


def test_a_diagnosis(saved, root):
    path = root / "catalog/measured/exo_glove_ii.csv"
    saved(reeve.diagnose(path, replicates=400, seed=2),
          "diagnose", path, "--replicates", "400", "--seed", "2", timed="diagnosis.json")


def test_a_comparison(saved, root):
    path = root / "catalog/measured/exo_glove_ii.csv"
    saved(reeve.compare(path), "compare", path)


def test_a_sizing(saved, program, tmp_path):
    sized = reeve.size("TR5", "TR7", vary=["sheath_angle=3..9"], starts=1, evaluations=30, draws=5)
    options = ["TR5", "TR7", "--vary", "sheath_angle=3..9", "--starts", "1", "--evaluations", "30",
               "--draws", "5"]
    saved(sized, "size", *options)
    program("size", *options, "--save-hardware", "h.toml", folder=tmp_path)
    assert sized.hardware_toml() == (tmp_path / "h.toml").read_text()


def test_shards_and_what_they_are_merged_to(saved, tmp_path, program):
    options = ["--fingers", "3", "--parts", "paper"]
    theirs = tmp_path / "theirs"
    theirs.mkdir()
    for shard in ("1/2", "2/2"):
        name = shard.replace("/", "of")
        reeve.explore(fingers=3, parts="paper", shard=shard).save(name)
        program("explore", *options, "--shard", shard, "--out", name, folder=theirs)
        timed = {"summary.json", "shard.json"}
        assert set(different(tmp_path / name, theirs / name)) <= timed
        for file in timed:
            assert timeless(tmp_path / name / file) == timeless(theirs / name / file)
    merged = reeve.merge(["1of2", tmp_path / "2of2"])
    assert merged.designs.equals(reeve.explore(fingers=3, parts="paper").designs)
    saved(merged, "merge", "1of2", "2of2", timed="summary.json")
    with pytest.raises(reeve.InputError, match="2/2 is missing"):
        reeve.merge(["1of2"])
    with pytest.raises(reeve.InputError, match="another folder"):
        merged.save("1of2")


def rows(store):
    """All that it holds, but for how long it took."""
    with sqlite3.connect(store) as base:
        base.execute("create temporary table untimed as select * from shards")
        base.execute("update untimed set seconds = 0, digest = 0")  # of the seconds, too
        named = base.execute("select name from main.sqlite_master where type = 'table'").fetchall()
        tables = [name for (name,) in named if name != "shards"] + ["untimed"]
        return {name: sorted(map(repr, base.execute(f"select * from {name}"))) for name in tables}


def test_a_store_and_its_ranking(program, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = reeve.explore(fingers=2, store="ours.db", keep="all")
    program("explore", "--fingers", "2", "--store", "theirs.db", "--keep", "all", folder=tmp_path)
    ours, theirs = rows("ours.db"), rows("theirs.db")
    assert ours.keys() == theirs.keys()
    assert [name for name in ours if ours[name] != theirs[name]] == []
    ranked = reeve.rank(store="theirs.db")
    assert ranked.designs["routing"].equals(found.designs["routing"])
    asked = ["--objectives", "efficiency", "--constraint", "sheaths<=2", "--top", "5"]
    other = reeve.rank(store="ours.db", objectives="efficiency", constraints=["sheaths<=2"], top=5)
    said = json.loads(program("rank", "--store", "ours.db", *asked, "--format", "json",
                              folder=tmp_path))
    assert other.summary == said
    assert (other.designs["sheaths"] <= 2).all() and len(other.designs) == 5
    with pytest.raises(reeve.InputError, match="evaluated already"):
        reeve.rank("TR1", store="ours.db")
    with pytest.raises(reeve.InputError, match="outlive this process"):
        reeve.explore(store="other.db", hardware=reeve.Hardware())
    assert not (tmp_path / "other.db").exists()
    with pytest.raises(NotImplementedError, match="no page"):
        other.save("out")


def test_a_log(program, root, tmp_path, monkeypatch):
    monkeypatch.chdir(root)
    steady = reeve.import_log("tests/golden/log.csv", tolerance=0.03, reverse=False)
    steady.save(tmp_path / "ours.csv")
    said = program("import", "tests/golden/log.csv", "--tolerance", "0.03", "-o",
                   tmp_path / "theirs.csv", "--plot", tmp_path / "theirs.svg", "--format", "json")
    assert (tmp_path / "ours.csv").read_bytes() == (tmp_path / "theirs.csv").read_bytes()
    assert steady.svg() == (tmp_path / "theirs.svg").read_text()
    assert steady.summary == json.loads(said)
    assert steady.data.attrs["simulated"] and len(steady.data) > 0


@pytest.mark.filterwarnings("ignore::reeve.Notice")
def test_a_frame_is_the_file_that_it_was_read_from(root, tmp_path):
    path = root / "tests/golden/readings.csv"
    frame = pd.read_csv(path, comment="#")
    frame.attrs["simulated"] = True
    of_a_frame, of_the_file = reeve.compare(frame), reeve.compare(path)
    both = [dict(result.summary["data"], file="") for result in (of_a_frame, of_the_file)]
    assert both[0] == both[1]
    of_a_frame.save(tmp_path)
    # What is written names the file beside it, and nothing that was there for the call alone.
    assert json.loads((tmp_path / "comparison.json").read_text())["data"]["file"] == str(
        tmp_path / "data.csv")
    assert of_a_frame.summary["data"]["file"] == "data"


def given():
    """Of each file that is put beside a result, one way to it."""
    hardware, model = reeve.Hardware(tube_mu=0.05), reeve.Model(reeve.Hardware().to_toml())
    data = reeve.simulate("TR1", runs=2, rows=3).data
    return {"hardware.toml": reeve.show("TR1", hardware=hardware),
            "model.toml": reeve.rank("TR1", model=model), "data.csv": reeve.compare(data)}


@pytest.mark.parametrize("name", ["hardware.toml", "model.toml", "data.csv"])
def test_a_file_of_the_user_stays(name, tmp_path):
    (tmp_path / name).write_text("mine\n")
    result = given()[name]
    with pytest.raises(reeve.InputError, match="already there, with other content") as caught:
        result.save(tmp_path)
    assert caught.value.where == str(tmp_path / name) and str(caught.value).startswith(
        caught.value.where)
    assert [file.name for file in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).read_text() == "mine\n"
    (tmp_path / name).unlink()
    for _ in range(2):
        result.save(tmp_path)
    assert (tmp_path / name).read_text() != "mine\n"
    assert not [file.name for file in tmp_path.iterdir() if file.name.startswith(".")]
    assert (tmp_path / name).stat().st_mode == next(tmp_path.glob("*.json")).stat().st_mode


def test_of_several_files_none_is_put_where_one_is_there(tmp_path):
    data = reeve.simulate("TR1", runs=2, rows=3).data
    compared = reeve.compare(data, hardware=reeve.Hardware(tube_mu=0.05))
    for name in ("data.csv", "hardware.toml"):
        folder = tmp_path / name
        (folder / name).mkdir(parents=True)  # a folder is no file of ours either
        with pytest.raises(reeve.InputError, match=f"{name}: already there"):
            compared.save(folder)
        assert [file.name for file in folder.iterdir()] == [name]


def test_a_file_that_cannot_be_put_leaves_nothing(tmp_path, monkeypatch):
    def full(*_):
        raise OSError("no space left")

    result = given()["data.csv"]
    monkeypatch.setattr("pathlib.Path.replace", full)
    with pytest.raises(OSError, match="no space left"):
        result.save(tmp_path)
    assert not list(tmp_path.iterdir())
