"""What is written about the module is what it is and does."""

import re
import subprocess
import sys

import reeve


def test_the_reference_is_that_of_the_docstrings(root):
    said = subprocess.run([sys.executable, root / "scripts/python_reference"], text=True,
                          capture_output=True, check=True).stdout
    written = (root / "docs/python_reference.md").read_text(encoding="utf-8")
    assert said == written, "./run python scripts/python_reference > docs/python_reference.md"
    for name in reeve.__all__:
        assert f"\n## {name}\n" in written, name


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
    assert names["whole"].designs.equals(reeve.explore(fingers=3).designs)
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
        "count": "Counts", "simulate": "Simulation", "power": "Power", "import_log": "SteadyReadings",
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
