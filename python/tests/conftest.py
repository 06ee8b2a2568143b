import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def root():
    return ROOT


@pytest.fixture
def program():
    """Runs the program; what it prints."""

    def run(*arguments, check=True, folder=ROOT):
        command = [os.environ["REEVE_EXECUTABLE"], *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=folder)
        assert not check or done.returncode in (0, 1), done.stderr
        return done.stdout if check else done

    return run
