"""Ctrl-C and progress during long work."""

import _thread
import os
import signal
import sys
import threading
import time
import types

import numpy as np
import pytest
import reeve


def test_ctrl_c_ends_soon_and_gives_what_there_is():
    when = {}

    def press():
        when["pressed"] = time.monotonic()
        _thread.interrupt_main()

    timer = threading.Timer(0.7, press)
    timer.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        reeve.explore(fingers=6, parts="all", blocks=2)
    # All of it would take minutes.
    assert time.monotonic() - when["pressed"] < 10
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


@pytest.mark.parametrize(("call", "result"), [
    (lambda begun: reeve.size("TR5", vary="sheath_angle=3..9", evaluations=1000000, starts=1000,
                              draws=5, progress=begun), "<reeve.Sizing: TR5, 2 dimensions"),
    (lambda begun: reeve.diagnose(reeve.simulate("TR1", runs=60, rows=60).data, replicates=100000,
                                  progress=begun), "None"),
    (lambda begun: reeve.tensions("M-5-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", threads=1, progress=begun,
                                  tube_mu=np.full(2_000_000, 0.1)), "None"),
], ids=["size", "diagnose", "tensions"])
def test_a_signal_stops_it(call, result):
    timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))

    def begun(*_):
        """The signal comes while the study runs, not while its data are written."""
        if timer.ident is None:
            timer.start()

    with pytest.raises(reeve.Interrupted) as caught:
        call(begun)
    assert repr(caught.value.result).startswith(result)


class Bar:
    """Stands for tqdm's: remembers what it was told."""

    bars = []

    def __init__(self, desc, total):
        self.desc, self.total, self.n, self.closed = desc, total, 0, False
        Bar.bars.append(self)

    def update(self, more):
        self.n += more

    def close(self):
        self.closed = True


def test_a_bar_of_tqdm(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar))
    Bar.bars.clear()
    # Long enough to be shown on a machine that is idle.
    reeve.explore(fingers=5, parts="all", progress=True)
    assert Bar.bars and all(bar.closed for bar in Bar.bars)
    assert all(0 <= bar.n <= bar.total for bar in Bar.bars if bar.total)
    assert any(bar.n for bar in Bar.bars)


def test_without_tqdm_a_warning_names_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.warns(UserWarning, match="tqdm") as told:
        assert len(reeve.rank("TR1", progress=True).designs) == 1
    assert told[0].filename == __file__


def test_what_is_noted_of_data_is_a_warning():
    data = reeve.simulate("TR1", runs=2, rows=3).data.rename(columns={"T1_N": "T1_kg"})
    with pytest.warns(reeve.Notice, match="T1_kg") as told:
        reeve.compare(data)
    assert told[0].filename == __file__
