"""The examples run from the root and from their folder, and give what the notebooks store."""

import json
import re
import runpy

import pytest
from conftest import ROOT

SCRIPT = runpy.run_path(str(ROOT / "scripts/notebooks"))
NUMBER = re.compile(r"-?\d+\.\d+(?:e[-+]?\d+)?")


@pytest.fixture
def folder(request, monkeypatch):
    """The root, or what `@pytest.mark.parametrize(…, indirect=True)` says."""
    monkeypatch.chdir(ROOT / getattr(request, "param", "."))


def test_there_are_some():
    assert len(SCRIPT["NOTEBOOKS"]) >= 4


# One of them from the folder that it is in.
FROM = [(".", file) for file in SCRIPT["NOTEBOOKS"]] + [("examples", SCRIPT["NOTEBOOKS"][-1])]


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(("folder", "file"), FROM, indirect=["folder"],
                         ids=[f"{folder}-{file.stem}" for folder, file in FROM])
def test_a_notebook_gives_what_is_stored(file):
    stored = file.read_text(encoding="utf-8")
    given = SCRIPT["executed"](stored)
    assert NUMBER.sub("#", given) == NUMBER.sub("#", stored), "./run python scripts/notebooks"
    # Libraries of mathematics differ in the last digits.
    given, stored = (list(map(float, NUMBER.findall(text))) for text in (given, stored))
    assert given == pytest.approx(stored, rel=1e-6)


@pytest.mark.parametrize("file", SCRIPT["NOTEBOOKS"], ids=lambda file: file.stem)
def test_cells_have_names_of_their_own(file):
    names = [cell["id"] for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]]
    assert len(set(names)) == len(names)


@pytest.mark.usefixtures("folder")
def test_the_script_prints_what_its_notebook_has(capsys):
    runpy.run_path(str(ROOT / "examples/codesign.py"), run_name="__main__")
    assert "uniformity over the coefficients: 0.215 (0.114 to 0.403)" in capsys.readouterr().out
