"""The types of the package, as a checker sees them."""

from pathlib import Path

import pytest
import reeve

PACKAGE = Path(reeve.__file__).parent
CONFIG = Path(__file__).resolve().parents[1] / "mypy.ini"

# An ignored error that there is not would be one.
USER = """\
import reeve
reeve.explore(fingers=2, tips=["tube"], score={"uniformity": 2}, hardware="h.toml")
reeve.explore(fingers="two")  # type: ignore[arg-type]
reeve.explore(finger=2)  # type: ignore[call-arg]
reeve.power(3, ["TR1"], rows="10")  # type: ignore[arg-type]
reeve.size("TR7", vary=5).page  # type: ignore[arg-type,attr-defined]
"""


def test_types_hold(tmp_path):
    api = pytest.importorskip("mypy.api", reason="mypy is not installed")
    (tmp_path / "user.py").write_text(USER)
    # Beside the module: what NumPy says of its types is read once.
    cache = str(PACKAGE.parent / "mypy_cache")
    said, _, status = api.run(["--config-file", str(CONFIG), "--cache-dir", cache, str(PACKAGE),
                               str(tmp_path / "user.py")])
    assert status == 0, said
