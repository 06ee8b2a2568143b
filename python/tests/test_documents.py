"""What is written about the module is what it is and does."""

import inspect
import re
from pathlib import Path

import reeve
from test_commands import COMMANDS


def test_the_reference_has_all_functions_and_their_keywords():
    written = (Path(reeve.__file__).parents[1] / "python_reference.md").read_text(encoding="utf-8")
    parts = dict(part.split("\n", 1) for part in written.split("\n## ")[1:])
    assert sorted(parts) == sorted(reeve.__all__)
    for name in COMMANDS:
        rows = re.findall(r"^\| `(\w+)` \| \w.* \| \S.* \|$", parts[name], re.MULTILINE)
        assert rows == list(inspect.signature(getattr(reeve, name)).parameters), name


def test_the_lines_of_the_introduction_run(root, tmp_path, monkeypatch):
    text = (root / "docs/python.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "catalog").symlink_to(root / "catalog")
    names = {}
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert len(blocks) == 4
    for block in blocks:
        exec(block, names)  # noqa: S102
    assert (tmp_path / "out/explore/index.html").exists()
    assert names["whole"].designs.equals(reeve.explore(fingers=2).designs)
    assert names["glove"].fingers[2]["tip_mu"] == 0.09


def test_the_lines_of_the_readme_run(root, monkeypatch):
    text = (root / "README.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    monkeypatch.chdir(root)
    exec(block, {})  # noqa: S102


def test_the_table_names_what_results_have(root):
    text = (root / "docs/python.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`\w+`(?:, `\w+`)*) \| (.*) \|$", text, re.MULTILINE)
    kinds = {
        "explore": "Exploration", "rank": "Ranking", "merge": "Exploration", "size": "Sizing",
        "diagnose": "Diagnosis", "compare": "Comparison", "show": "Shown", "check": "Check",
        "catalogue": "Catalogue", "count": "Counts", "simulate": "Simulation", "power": "Power", "import_log": "SteadyReadings",
    }
    seen = set()
    for functions, members in rows:
        for function in re.findall(r"\w+", functions):
            seen.add(function)
            for member in re.findall(r"`\.?(\w+)(?:\(\w*\))?`", re.sub("`import`|`simulate --power`", "", members)):
                assert member in scope(getattr(reeve, kinds[function])), (function, member)
    assert seen == kinds.keys()


def scope(kind):
    """Names of members, those that only instances have among them."""
    code = getattr(kind.__init__, "__code__", None)
    return {*dir(kind), *(code.co_names if code else ())}
