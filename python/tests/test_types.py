"""The types of the package, as a checker sees them."""

from pathlib import Path

import pytest

PYTHON = Path(__file__).resolve().parents[1]


def test_types_hold():
    api = pytest.importorskip("mypy.api", reason="mypy is not installed")
    config = str(PYTHON / "mypy.ini")
    said, _, status = api.run(["--config-file", config, "--cache-dir", "/dev/null", str(PYTHON / "reeve")])
    assert status == 0, said
