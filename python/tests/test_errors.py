"""What is wrong with what is given, and where."""

import pickle

import numpy as np
import pandas as pd
import pytest
import reeve


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


def test_a_range_has_its_value_and_what_was_expected():
    with pytest.raises(reeve.InputError) as caught:
        reeve.explore(fingers=99)
    error = caught.value
    assert (error.where, error.what, error.value) == ("explore", "--fingers", "99")
    assert error.expected == "a number from 1 to 64"
    with pytest.raises(reeve.InputError) as caught:
        reeve.explore(tendons="both")
    assert (caught.value.value, caught.value.expected) == ("both", "one of {one,any}")
    with pytest.raises(reeve.InputError) as caught:
        reeve.diagnose("d.csv", alpha=3)
    assert caught.value.value == "3" and caught.value.expected.startswith("a number from")


@pytest.mark.parametrize(("call", "said"), [
    (lambda: reeve.explore(fingers="two"), "fingers: expected int, not 'two'"),
    (lambda: reeve.explore(fingers=2.0), "fingers: expected int, not 2.0"),
    (lambda: reeve.explore(fingers=True), "fingers: expected int, not True"),
    (lambda: reeve.explore(uncertainty=1), "uncertainty: expected bool, not 1"),
    (lambda: reeve.explore(constraints=[5]), "constraints: expected str or sequence of str"),
    (lambda: reeve.explore(hardware=5), "hardware: expected str, path or Hardware, not 5"),
    (lambda: reeve.explore(score=["a"]), "score: expected str or mapping"),
    (lambda: reeve.explore(progress=3), "progress: expected bool or callable, not 3"),
    (lambda: reeve.rank(["TR1"]), "routings: expected str or Routing, not ['TR1']"),
    (lambda: reeve.diagnose(None), "data: expected str, path or DataFrame, not None"),
    (lambda: reeve.merge("s1"), "folders: expected sequence of str or path, not 's1'"),
    (lambda: reeve.show("TR5", held=1.5), "held: expected int, str or sequence of"),
    (lambda: reeve.tensions(5), "routings: expected str, Routing or sequence of"),
    (lambda: reeve.tensions("TR7", tube_mu="x"), "tube_mu: expected numbers, not 'x'"),
    (lambda: reeve.tensions("TR7", hardware=3), "hardware: expected Hardware, not 3"),
    (lambda: reeve.Routing(5), "word: expected a word such as 'M-1-T-2-F'"),
    (lambda: reeve.Routing("TR7").tensions(5), "hardware: expected a reeve.Hardware or None, not 5"),
    (lambda: reeve.Routing("TR7").tensions(held=[1.5]), "held: expected the fingers that are held"),
    (lambda: reeve.Routing("TR7").tensions(direction=1), "direction: expected 'pull' or 'release'"),
    (lambda: reeve.Routing("TR7").tensions(mu=1),
     "tensions() got an unexpected keyword argument 'mu'"),
    (lambda: reeve.Routing("TR7").to_mjcf(5), "hardware: expected a reeve.Hardware or None, not 5"),
    (lambda: reeve.Hardware(tube_mu="x"), "tube_mu: expected a number, not 'x'"),
    (lambda: reeve.Hardware(fingers=5), "fingers: expected a mapping, not 5"),
    (lambda: reeve.Hardware(fingers={1: {"tip_mu": None}}),
     "fingers[1]['tip_mu']: expected a number, not None"),
    (lambda: reeve.Hardware.from_toml(5), "path: expected a path, not 5"),
])
def test_a_wrong_type_is_named(call, said):
    with pytest.raises(TypeError) as caught:
        call()
    assert str(caught.value).startswith(said)
    assert "\n" not in str(caught.value)


def test_numbers_of_numpy_are_numbers():
    assert len(reeve.explore(fingers=np.int64(1), top=np.int32(5)).designs) > 0
    assert reeve.simulate("TR1", runs=2, rows=2, motor_tension=np.array([5.0, 10.0])).csv == (
        reeve.simulate("TR1", runs=2, rows=2, motor_tension=[5.0, 10.0]).csv)
    held = reeve.Routing("TR7").tensions(held=np.int64(1)).array
    assert np.array_equal(held, reeve.Routing("TR7").tensions(held=1).array)


ONE, TWO = np.int64(1), np.int32(2)


@pytest.mark.parametrize(("held", "same"), [
    (ONE, 1), (np.array([1, 2]), "1,2"), ([1, 2], "1,2"),
    ([ONE, "none"], [1, "none"]), ([[ONE, TWO], ONE], ["1,2", "1"]),
])
def test_fingers_of_numpy_are_fingers(held, same):
    assert reeve.show("TR7", held=held).summary == reeve.show("TR7", held=same).summary
    assert reeve.show("TR7", held=held).summary != reeve.show("TR7", held="none").summary


@pytest.mark.filterwarnings("ignore::reeve.Notice")
@pytest.mark.parametrize(("held", "same"), [
    (ONE, 1), (np.array([1, 2]), "1;2"), ([TWO], "2"), ([], "none"),
])
def test_a_log_holds_fingers_of_numpy(root, held, same):
    log = pd.read_csv(root / "tests/golden/log.csv", comment="#").drop(columns="held")
    ours, theirs = reeve.import_log(log, held=held), reeve.import_log(log, held=same)
    assert ours.csv == theirs.csv and len(ours.data) > 0
    assert set(ours.data["held"]) == {str(same)}


def test_an_error_keeps_its_parts_when_it_travels_and_when_its_words_change():
    def fields(error):
        own = (str(error), error.where, error.what, error.value, error.expected)
        return [*own, *(field for part in error.parts for field in fields(part))]

    error = reeve.InputError("m", "w", "x", "v", "e", (reeve.InputError("p", None, "q"),))
    assert fields(pickle.loads(pickle.dumps(error))) == fields(error)
    assert fields(error._changed(str.upper)) == [
        field and field.upper() for field in fields(error)]


def wrong(row=None, column="T1_N"):
    data = reeve.simulate(["TR1", "TR7"], runs=2, rows=3).data
    data[column] = data[column].astype(object)
    if row is not None:
        data.loc[row, column] = "abc"
    return data


@pytest.mark.parametrize("simulated", [True, False])
@pytest.mark.parametrize("row", [0, 4])
def test_a_row_of_a_frame_is_named(row, simulated):
    data = wrong(row)
    data.attrs["simulated"] = simulated
    for function in (reeve.compare, reeve.diagnose):
        with pytest.raises(reeve.InputError, match=rf"^data, row {row}: column 'T1_N'") as caught:
            function(data)
        assert caught.value.where == f"data, row {row}" and caught.value.value == "abc"
    with pytest.raises(reeve.InputError, match=rf"^log, row {row}: "):
        reeve.import_log(data.assign(time_s=range(6)))


def test_no_message_names_a_file_that_is_gone():
    for call in (
        lambda: reeve.compare(wrong().drop(columns="routing")),
        lambda: reeve.rank("TR1", model=reeve.Model("a = 5")),
        lambda: reeve.import_log(wrong()),
    ):
        with pytest.raises(reeve.InputError) as caught:
            call()
        fields = [str(caught.value), *map(str, vars(caught.value).values())]
        assert not any("reeve-" in field or "/tmp" in field for field in fields), fields
    with pytest.raises(reeve.InputError, match=r"^model:1:1: unknown key 'a'"):
        reeve.rank("TR1", model=reeve.Model("a = 5"))


def test_what_is_wrong_with_a_hardware_is_named_by_its_key(tmp_path):
    text = '[contact."T1-T2"]\nmu = 6\n'
    path = tmp_path / "strong.toml"
    path.write_text(text)
    read = reeve.Hardware.from_toml(path)
    strong = "hardware: T1-T2: mu * angle = 18.84955592153876: expected at most 10"
    for hardware in (read, reeve.Hardware(contacts={"T1-T2": {"mu": 6}})):
        with pytest.raises(reeve.OutOfRange) as beyond:
            reeve.show("TR1", hardware=hardware)
        assert str(beyond.value) == f"routing 'M-1-T-2-F': {strong}"
    for call in (lambda: reeve.show("TR1", hardware=path), lambda: reeve.Routing("TR1").tensions(read)):
        with pytest.raises(reeve.OutOfRange) as beyond:
            call()
        assert str(beyond.value) == f"routing 'M-1-T-2-F': {path}:1:10: {strong}"

    with pytest.raises(reeve.OutOfRange) as beyond:  # a model's lines are the user's own
        reeve.show("TR1", model=reeve.Model(text))
    assert str(beyond.value) == f"routing 'M-1-T-2-F': model:1:10: {strong}"

    joints = [{"arm_mm": 8, "range_deg": 90, "lever_mm": 60}]
    with pytest.raises(reeve.InputError) as lacking:
        reeve.show("TR1", hardware=reeve.Hardware(fingers={1: {"joints": joints, "force_N": 5}}))
    assert lacking.value.where == "hardware"
    assert str(lacking.value).startswith("hardware: finger 2 has no joints; expected joints in")
