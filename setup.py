"""The Python package, built and installed by CMake (pyproject.toml).

    pip install .                        configures and builds below build/pip
    REEVE_BUILD=build/release pip …      takes the module of a build that is there
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
OPTIONS = ["-DREEVE_PYTHON=ON", "-DREEVE_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}"]


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(reeve VERSION ([0-9.]+)", text)[1]


class InstallWithCMake(build_ext):
    """The package as `cmake --install` leaves it, in the wheel's place."""

    def run(self):
        given = os.environ.get("REEVE_BUILD")
        build = Path(given).resolve() if given else ROOT / "build" / "pip"
        if not given:
            self.cmake("--preset", "release", "-B", build, *OPTIONS)
        self.cmake("--build", build, "--target", "reeve_python")
        with tempfile.TemporaryDirectory() as prefix:
            self.cmake("--install", build, "--component", "python", "--prefix", prefix)
            (package,) = Path(prefix).rglob("reeve")
            shutil.rmtree(Path(self.build_lib) / "reeve", ignore_errors=True)  # an earlier build's
            shutil.copytree(package, Path(self.build_lib) / "reeve")

    def cmake(self, *arguments):
        # pip's own PYTHONPATH would be that of every Python that CMake asks.
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
        subprocess.run(["cmake", *arguments], check=True, cwd=ROOT, env=environment)


(ROOT / "build").mkdir(exist_ok=True)
setup(
    version=version(),
    ext_modules=[Extension("reeve._core", [])],
    cmdclass={"build_ext": InstallWithCMake},
    options={"egg_info": {"egg_base": "build"}, "build": {"build_base": "build/setuptools"}},
)
