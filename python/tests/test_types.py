"""The types of the package, as a checker sees them."""

from pathlib import Path

import pytest
import reeve

PYTHON = Path(__file__).resolve().parents[1]


def test_types_hold():
    api = pytest.importorskip("mypy.api", reason="mypy is not installed")
    config = str(PYTHON / "mypy.ini")
    # Beside the module: what NumPy says of its types is read once.
    cache = str(Path(reeve.__file__).parents[1] / "mypy_cache")
    said, _, status = api.run(["--config-file", config, "--cache-dir", cache, str(PYTHON / "reeve")])
    assert status == 0, said
