"""The notebooks of examples/ run, and are stored without what they print."""

import json

import pytest
from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "examples").glob("*.ipynb"))


def test_there_are_some():
    assert len(NOTEBOOKS) >= 4


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_a_notebook_runs(file, monkeypatch):
    notebook = json.loads(file.read_text(encoding="utf-8"))
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in cells)
    sources = ["".join(cell["source"]) for cell in cells]
    if any("scipy" in source for source in sources):
        pytest.importorskip("scipy", reason="SciPy is not installed")
    monkeypatch.chdir(ROOT)  # as its paths are
    names = {}
    for source in sources:
        *statements, last = source.split("\n")
        exec(compile(source, file.name, "exec"), names)  # noqa: S102
        if last and not last.startswith((" ", ")", "]")) and "=" not in last:
            repr(eval(last, names))  # what a notebook would show
