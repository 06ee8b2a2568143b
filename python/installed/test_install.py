"""The package away from the build tree: as CMake installs it, and as pip does.

Run with REEVE_BUILD, the folder of a build with the module.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = os.environ["REEVE_BUILD"]

# What a user's Python does with it, and that it is this one and no other.
SCRIPT = """
import importlib.metadata, pathlib, sys, reeve
folder = pathlib.Path(reeve.__file__).parent
assert folder.is_relative_to({prefix!r}), folder
assert not folder.is_symlink() and not (folder / "__init__.py").is_symlink()
assert (folder / "py.typed").exists() and (folder / "_core.pyi").exists()
assert list(reeve.rank("TR1", "TR7").designs["name"]) == ["TR7", "TR1"]
assert reeve.Routing("TR7").tensions(held=[1]).uniformity > 0.9
if "pip" in sys.argv:
    assert importlib.metadata.version("reeve") == reeve.__version__
"""


TYPED = """
import reeve
reveal_type(reeve.Routing("TR7").fingers)
reeve.explore(fingers="two")  # type: ignore[arg-type]
"""


def run(*command, **options):
    done = subprocess.run(command, text=True, capture_output=True, check=False, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.strip()


def use(python, prefix, *installer, path=None):
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    environment |= {"PYTHONPATH": str(path)} if path else {}
    run(python, "-c", SCRIPT.format(prefix=str(prefix)), *installer, cwd=prefix, env=environment)


def test_cmake_installs_it(tmp_path):
    run("cmake", "--install", BUILD, "--component", "python", "--prefix", tmp_path)
    (package,) = tmp_path.rglob("reeve/__init__.py")
    use(sys.executable, tmp_path, path=package.parents[1])


def test_pip_installs_it(tmp_path):
    run(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", tmp_path)
    python = tmp_path / "bin/python"
    run(sys.executable, "-m", "pip", "--python", python, "install", "--no-build-isolation",
        "--no-deps", "--no-index", ROOT, env=os.environ | {"REEVE_BUILD": BUILD})
    use(python, tmp_path, "pip")
    pytest.importorskip("mypy", reason="mypy is not installed")
    (tmp_path / "user.py").write_text(TYPED)
    said = run(sys.executable, "-m", "mypy", "--python-executable", python, "--config-file",
               ROOT / "python/mypy.ini", "--cache-dir",
               f"{BUILD}/python/mypy_cache", tmp_path / "user.py")
    assert 'Revealed type is "builtins.int"' in said
