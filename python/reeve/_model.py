"""A model: a hardware, and effects beyond the plain friction model."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from typing import Union

Place = Union[str, PathLike[str]]


class Model:
    """A hardware with effects beyond the plain friction model, such as a diagnosis finds them.

    Parameters
    ----------
    toml : str
        The text of a model file, as ``--model`` reads it.
    """

    def __init__(self, toml: str) -> None:
        self._toml = toml

    @classmethod
    def from_toml(cls, path: Place) -> "Model":
        """The model of a file. Whoever uses it says what is wrong with it."""
        return cls(Path(path).read_text(encoding="utf-8"))

    def to_toml(self) -> str:
        """The text of its file."""
        return self._toml

    def save(self, path: Place) -> None:
        """Writes it as a file that ``--model`` reads."""
        Path(path).write_text(self._toml, encoding="utf-8")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and self._toml == other._toml

    def __hash__(self) -> int:
        return hash(self._toml)
