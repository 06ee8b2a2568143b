"""Readings as frames: what the files say, cell by cell."""

import csv
import io

import pandas as pd
import pytest
import reeve

NAMES = ["A#1", "NA", "02", "03", "nan", "1e3", "True", "None", "3, left", 'a "b"',
         "#1\n# simulated"]


@pytest.fixture
def readings():
    """Of runs that are called what a reader of tables takes for something else."""
    data = reeve.simulate(["TR1", "TR7"], runs=len(NAMES), rows=3).data
    data["run"] = data["run"].map(lambda run: NAMES[int(run) - 1])
    data.attrs["simulated"] = False
    return data


def written(text):
    """The rows of a file, read without pandas."""
    lines = text.split("\n")
    while lines[0].startswith("#"):
        lines.pop(0)
    return list(csv.DictReader(io.StringIO("\n".join(lines), newline="")))


def said(frame, name):
    return frame[name].tolist()


@pytest.mark.filterwarnings("ignore::reeve.Notice")
def test_residuals_keep_the_names_of_runs(readings, tmp_path):
    for result in (reeve.compare(readings), reeve.diagnose(readings, replicates=400)):
        result.save(tmp_path / type(result).__name__)
        rows = written((tmp_path / type(result).__name__ / "residuals.csv").read_text())
        frame = result.residuals
        assert {row["run"] for row in rows} == set(NAMES)
        for name in ("run", "routing", "held", "direction", "channel"):
            assert said(frame, name) == [row[name] for row in rows], name
        measured = next(name for name in frame if name.startswith("measured"))
        assert said(frame, measured) == pytest.approx([float(row[measured]) for row in rows])
        assert not frame.attrs["simulated"]


def test_an_empty_number_is_none_and_an_empty_grasp_is_no_finger():
    data = reeve.simulate(["TR1", "TR2"], runs=2, rows=4, channels="a,T1,b").data
    rows = written(reeve.simulate(["TR1", "TR2"], runs=2, rows=4, channels="a,T1,b").csv)
    assert said(data, "held") == [row["held"] for row in rows] and "" in said(data, "held")
    assert said(data, "run") == ["1"] * 4 + ["2"] * 4
    assert data["Tb_N"].dtype.kind == "f"
    assert list(data["Tb_N"].isna()) == [row["Tb_N"] == "" for row in rows]
    assert data["Tb_N"].isna().any() and data["Tb_N"].notna().any()


@pytest.mark.filterwarnings("ignore::reeve.Notice")
@pytest.mark.parametrize("run", ["02", "NA", "A#1", "#1"])
def test_imported_readings_keep_the_name_of_their_run(root, run):
    log = pd.read_csv(root / "tests/golden/log.csv", comment="#").drop(columns="run")
    steady = reeve.import_log(log, run=run)
    rows = written(steady.csv)
    assert len(steady.data) == len(rows) > 0
    assert set(steady.data["run"]) == {run}
    assert said(steady.data, "held") == [row["held"] for row in rows]


def test_a_frame_of_files_with_empty_cells_is_the_file():
    made = reeve.simulate(["TR1", "TR7"], runs=2, rows=4)
    for data in (made.data, pd.read_csv(io.StringIO(made.csv), comment="#")):
        data.attrs["simulated"] = True
        compared = reeve.compare(data)
        assert compared.summary["data"]["simulated"]
        assert said(compared.residuals, "held") == [
            row["held"] for row in written(made.csv) for name in ("T1", "T2", "T3", "T4")]


def test_a_whole_number_beyond_any_integer_is_a_number():
    data = reeve.simulate("TR1", runs=2, rows=3).data.assign(humidity=1e20)
    with pytest.warns(reeve.Notice, match="humidity"):
        assert len(reeve.compare(data).residuals) == 24
    data["T1_N"] = 1e20
    with pytest.raises(reeve.InputError, match=r"\n  data, row 0: column 'T1_N' = '1e\+20'"):
        reeve.compare(data)


@pytest.mark.filterwarnings("ignore::reeve.Notice")
def test_a_row_of_a_frame_that_begins_with_a_hash_is_no_comment():
    runs = ["#1", "#2", "plain", "#3, late"]
    frame = pd.DataFrame({"run": runs, "routing": ["TR1"] * 4, "T1_N": [10.0, 20, 30, 40],
                          "T2_N": [5.0, 11, 16, 19], "motor_tension_N": [30, 60, 90, 110]})
    assert list(reeve.compare(frame).residuals["run"].unique()) == runs
