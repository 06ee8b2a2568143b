"""Routings, hardware and tensions, against closed forms and the program."""

import json
import math
import pickle

import numpy as np
import pytest
import reeve


def test_a_routing_is_one_however_it_is_written():
    written = reeve.Routing("M-1-T-2-F")
    assert written == reeve.Routing("F-2-T-1-M")
    assert hash(written) == hash(reeve.Routing("F-2-T-1-M"))
    assert written != reeve.Routing("M-2-T-1-F")  # other fingers
    assert written != "M-1-T-2-F"
    assert reeve.Routing("M-2-T-1-F").canonical == "M-1-T-2-F"


def test_a_name_is_its_routing():
    routing = reeve.Routing("TR7")
    assert routing.word == "1-P-2-P-1"
    assert routing.name == "TR7"
    assert routing.fingers == 2
    assert routing.parts == {
        "sheaths": 4, "pulleys": 2, "knots": 1, "blocks": 0, "bars": 0, "anchors": 0,
    }
    assert repr(routing) == "Routing('1-P-2-P-1')"


def test_pickles():
    routing = reeve.Routing("M-1-P-2-F")
    assert pickle.loads(pickle.dumps(routing)) == routing
    hardware = reeve.Hardware(tube_mu=0.1 + 0.2, strand_mm=1 / 3)
    again = pickle.loads(pickle.dumps(hardware))
    assert again == hardware
    assert again.tube_mu == 0.1 + 0.2
    error = reeve.InputError("m", "f:1", "c", "v", "e")
    assert vars(pickle.loads(pickle.dumps(error))) == vars(error)


def test_hardware_is_immutable():
    paper = reeve.Hardware()
    assert (paper.tube_mu, paper.sheath_angle_rad) == (0.18, 2 * math.pi)
    other = paper.replace(mu_tube=0.09)
    assert (paper.tube_mu, other.tube_mu) == (0.18, 0.09)
    assert other == reeve.Hardware(tube_mu=0.09)
    with pytest.raises(AttributeError):
        paper.tube_mu = 1
    with pytest.raises(TypeError, match="tube_nu"):
        reeve.Hardware(tube_nu=1)


def test_hardware_of_a_file(root, tmp_path):
    hardware = reeve.Hardware.from_toml(root / "catalog/hardware/example.toml")
    (tmp_path / "again.toml").write_text(hardware.to_toml())
    assert reeve.Hardware.from_toml(tmp_path / "again.toml") == hardware


TABLES = {
    "fingers": {2: {"tip_mu": 0.09, "sheath_angle_rad": 7.0, "closing": 0.8}},
    "contacts": {"a-T1": {"mu": 0.2}},
}


def test_hardware_of_tables_is_that_of_the_file(tmp_path):
    (tmp_path / "h.toml").write_text("""
        [sheath]
        mu = 0.05
        [finger.2]
        tip_mu = 0.09
        sheath_angle_rad = 7
        closing = 0.8
        [contact."a-T1"]
        mu = 0.2
    """)
    hardware = reeve.Hardware(sheath_mu=0.05, **TABLES)
    assert hardware == reeve.Hardware.from_toml(tmp_path / "h.toml")
    assert hardware == reeve.Hardware().replace(**TABLES).replace(sheath_mu=0.05)
    assert (hardware.fingers, hardware.contacts) == (TABLES["fingers"], TABLES["contacts"])
    assert pickle.loads(pickle.dumps(hardware)) == hardware
    assert eval(f"reeve.{hardware!r}") == hardware
    # Another finger's table takes the place of all.
    other = hardware.replace(fingers={"1": {"tip_mu": 0.1}})
    assert other.fingers == {1: {"tip_mu": 0.1}} and other.contacts == hardware.contacts
    assert other.replace(fingers={}, contacts={}, sheath_mu=0.18) == reeve.Hardware()


def test_a_hand_in_tables_is_that_of_its_file(root):
    hand = reeve.Hardware.from_toml(root / "catalog/hardware/three_finger_hand.toml")
    again = reeve.Hardware(
        tube_mu=hand.tube_mu, sheath_mu=hand.sheath_mu, sheath_angle_rad=hand.sheath_angle_rad,
        hand=hand.hand, motor=hand.motor, fingers=hand.fingers, uncertainty=hand.uncertainty,
    )
    assert again == hand
    assert [joint["arm_mm"] for joint in hand.fingers[1]["joints"]] == [11, 8]
    assert hand.motor["force_N"] == 80


def test_what_is_of_one_finger_acts_there():
    # TR1 with finger 1 held slides through T1, T2, T3, T4: the tip of finger 2 is the last contact.
    hardware = reeve.Hardware(tube_mu=0.07, sheath_mu=0.05)
    plain = reeve.Routing("TR1").tensions(hardware, held=[1])
    other = hardware.replace(fingers={2: {"tip_mu": 0.3, "tip_angle_rad": 2}})
    changed = reeve.Routing("TR1").tensions(other, held=[1])
    strands = ["T1", "T2", "T3"]
    assert [changed[i] for i in strands] == pytest.approx([plain[i] for i in strands], rel=1e-12)
    assert changed["T4"] == pytest.approx(changed["T3"] * math.exp(-0.6), rel=1e-12)
    inlet = hardware.replace(contacts={"T1-a": {"mu": 0}})
    assert reeve.Routing("TR1").tensions(inlet, held=[1])["T1"] == 1


@pytest.mark.parametrize(("tables", "what", "value"), [
    ({"fingers": {2: {"tip_mu": -1}}}, "finger.2.tip_mu", "-1"),
    ({"fingers": {2: {"tip_nu": 1}}}, "unknown key", "finger.2.tip_nu"),
    ({"fingers": {0: {"tip_mu": 1}}}, "unknown table", "finger.0"),
    ({"contacts": {"a": {"mu": 1}}}, "contact", "a"),
    ({"contacts": {"a-Q": {"mu": 1}}}, "segment", "Q"),
    ({"tube_mu": 20, "fingers": {1: {"tip_mu": 1}}}, "tube.mu", "20"),
])
def test_a_table_that_cannot_be_is_refused(tables, what, value):
    with pytest.raises(reeve.InputError) as caught:
        reeve.Hardware(**tables)
    assert (caught.value.what, caught.value.value) == (what, value)
    assert "Hardware:" not in str(caught.value) and caught.value.expected


def capstan(mu_tube, mu_sheath):
    """M-1-T-2-F with finger 1 held slides the same way everywhere: one product."""
    sheath, tube = math.exp(-mu_sheath * 2 * math.pi), math.exp(-mu_tube * math.pi)
    return [sheath, sheath * tube, sheath * tube**2, sheath * tube**3]


def test_tensions_are_the_closed_form():
    state = reeve.Routing("TR1").tensions(reeve.Hardware(tube_mu=0.07, sheath_mu=0.05), held=[1])
    expected = capstan(0.07, 0.05)
    assert [state[f"T{i}"] for i in range(1, 5)] == pytest.approx(expected, rel=1e-12)
    assert isinstance(state["T1"], np.floating)
    assert state["a"] == 1
    assert set(state) == set(state.keys()) == {"a", "T1", "T2", "T3", "T4"}
    assert dict(state.items())["T4"] == state["T4"]
    assert state.uniformity == pytest.approx(expected[3] / expected[0])
    assert not state.jams
    with pytest.raises(KeyError):
        state["T9"]


@pytest.mark.parametrize("held", [[1], (1,), 1, "1", np.array([1])])
def test_a_grasp_can_be_said_in_several_ways(held):
    expected = reeve.Routing("TR5").tensions(held=[1])
    assert np.array_equal(reeve.Routing("TR5").tensions(held=held).array, expected.array)


def test_tensions_are_the_programs(program):
    for direction in ("pull", "release"):
        shown = json.loads(program("show", "TR4", "--held", "2", "--direction", direction,
                                   "--format", "json"))
        state = reeve.Routing("TR4").tensions(held=[2], direction=direction)
        assert shown["grasps"][0]["tensions"] == dict(state)


def test_a_table_is_the_single_calls():
    mu = np.array([[0.05, 0.1, 0.18]])
    angle = np.array([[3.0], [6.5]])
    routings = ["TR1", "M-1-P-2-M", "TR7"]
    held = [[], [1], [2]]
    table = reeve.tensions(routings, held=held, mu_tube=mu, sheath_mu=0.1, sheath_angle_rad=angle)
    assert table.dims == ("routing", "held", "sample_0", "sample_1", "segment")
    assert table.shape[:4] == (3, 3, 2, 3)
    names = list(np.asarray(table.coords["segment"]))
    for r, word in enumerate(routings):
        for g, grasp in enumerate(held):
            for i in range(2):
                for k in range(3):
                    hardware = reeve.Hardware(
                        tube_mu=mu[0, k], sheath_mu=0.1, sheath_angle_rad=angle[i, 0]
                    )
                    state = reeve.Routing(word).tensions(hardware, held=grasp)
                    row = np.asarray(table)[r, g, i, k]
                    for name, value in zip(names, row):
                        assert value == state[name] if name in state else np.isnan(value)


def test_axes_that_were_not_asked_for_are_not_there():
    assert reeve.tensions("TR7").dims == ("segment",)
    assert reeve.tensions(["TR7"], held=[1]).dims == ("routing", "segment")
    assert reeve.tensions("TR7", held=["none", "1"], tube_mu=[0.1]).dims == (
        "held", "sample", "segment",
    )
    assert isinstance(reeve.tensions("TR7", named=False), np.ndarray)


def test_routings_and_grasps_stand_along_their_axes_as_they_can_be_said():
    along = reeve.tensions(["TR7", "TR1"], held=[[1, 2], [1], []]).coords
    assert np.asarray(along["held"]).tolist() == ["1,2", "1", "none"]
    assert np.asarray(along["routing"]).tolist() == ["1-P-2-P-1", "M-1-T-2-F"]


def test_models_are_equal_if_their_files_are():
    assert reeve.Model("a = 1") == reeve.Model("a = 1")
    assert reeve.Model("a = 1") != reeve.Model("a = 2")


def test_scores_and_causes_may_be_mappings():
    said = reeve.rank("TR1", "TR7", score="uniformity=2,sheaths=0.5").summary
    assert reeve.rank("TR1", "TR7", score={"uniformity": 2, "sheaths": 0.5}).summary == said
    both = {"wear": {"change": -0.4, "cycles": 500}, "tube_friction": {"mu": 0.1}}
    csv = reeve.simulate("TR1", runs=2, rows=2, cycles=[0, 1000], cause=both).csv
    assert "--cause wear --set change=-0.4 --set cycles=500 --cause tube_friction --set mu=0.1" in csv


def test_axes_keep_the_names_of_xarray():
    xarray = pytest.importorskip("xarray")
    mu = xarray.DataArray([0.1, 0.2], dims="lining")
    angle = xarray.DataArray([3.0, 6.0, 9.0], dims="bend")
    table = reeve.tensions("TR7", tube_mu=mu, sheath_angle_rad=angle)
    assert table.dims == ("lining", "bend", "segment")
    assert table.shape[:2] == (2, 3)


def test_the_table_does_not_depend_on_threads():
    mu = np.linspace(0, 0.3, 3000)
    one = reeve.tensions("TR5", held=[1], tube_mu=mu, threads=1, named=False)
    assert np.array_equal(one, reeve.tensions("TR5", held=[1], tube_mu=mu, threads=3, named=False))


def test_bearings_vary_blocks_that_have_no_law_of_their_own():
    word = "M-Y1+1x-Y1-2x"
    table = reeve.tensions(word, held=[1], bearing_mu=[0.001, 0.1], named=False)
    for row, mu in zip(table, [0.001, 0.1]):
        single = reeve.Routing(word).tensions(reeve.Hardware(bearing_mu=mu), held=[1])
        assert sorted(row) == sorted(single.array)


def test_faults_have_their_parts():
    with pytest.raises(reeve.InputError) as caught:
        reeve.Routing("M-1-Q-2-F")
    assert caught.value.where == "routing 'M-1-Q-2-F', column 5"
    assert "expected" in str(caught.value) and caught.value.expected
    with pytest.raises(reeve.InputError, match=r"tube_mu\[1\].*-0.1"):
        reeve.tensions("TR7", tube_mu=[0.1, -0.1])
    with pytest.raises(reeve.InputError, match="finger"):
        reeve.Routing("TR7").tensions(held=[3])
    with pytest.raises(TypeError, match="tube_nu"):
        reeve.tensions("TR7", tube_nu=[1])
    with pytest.raises(reeve.InputError, match="sideways"):
        reeve.Routing("TR7").tensions(direction="sideways")


def test_a_routing_is_exported_as_the_program_does(program):
    assert reeve.Routing("TR7").to_mjcf() == program("export", "TR7")


def test_a_quick_question_needs_no_file():
    quick = reeve.show("M-1-F", held="none", mu=0.1, sheath_bend="90deg").summary
    same = reeve.show("M-1-F", held="none", mu=0.1, sheath_bend=np.pi / 2).summary
    tension = quick["grasps"][0]["tensions"]["T1"]
    assert tension == pytest.approx(np.exp(-0.1 * np.pi / 2))
    assert tension == pytest.approx(same["grasps"][0]["tensions"]["T1"])
