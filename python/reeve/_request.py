"""What is asked of a subcommand, as the command line would say it."""

from __future__ import annotations

import csv
import os
import re
import secrets
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from numbers import Integral
from pathlib import Path
from typing import Any, Optional, Union

import numpy as np

from . import _core
from ._model import Model
from .errors import InputError, OutOfRange

# Options of which each value is given by itself; of all others a list is joined by commas.
_REPEATED = {
    "constraint", "vary", "equal", "map", "unit", "noise", "exact", "held", "column", "run-column",
}


class FileText:
    """A value that the program reads from a file, under the name of its argument."""

    def __init__(self, argument: str, ending: str, text: str, is_of_user: bool = True) -> None:
        self.is_of_user = is_of_user  # the user knows its lines
        self.argument = argument
        self.name = argument + ending
        self.text = text

    def place(self, line: Optional[str]) -> str:
        """Where a line of the file is, for who gave no file."""
        if line is None or not self.name.endswith(".csv"):
            return f"{self.argument}:{line}" if line else self.argument
        header = 1 + self.text.startswith("#")
        row = int(line) - header - 1
        return f"{self.argument}, row {row}" if row >= 0 else f"{self.argument}, columns"


# Up to here every whole number is one of its own in a column of floats.
_WHOLE_BELOW = 2.0**53


def _is_whole(column: Any) -> bool:
    if column.dtype.kind != "f":
        return False
    numbers = column.dropna()
    return bool(((numbers % 1 == 0) & (numbers.abs() < _WHOLE_BELOW)).all())


def _csv(frame: Any) -> str:
    """The rows as a file has them: pandas reads whole numbers beside empty cells as 1.0 and 2.0."""
    whole = {name: "Int64" for name, column in frame.items() if _is_whole(column)}
    simulated = "# simulated\n" if frame.attrs.get("simulated") else ""
    # A row that begins with # is a comment, but for one in quotes.
    first = frame.iloc[:, 0] if frame.shape[1] > 0 else ()
    quoting = (
        csv.QUOTE_NONNUMERIC if any(str(cell).startswith("#") for cell in first)
        else csv.QUOTE_MINIMAL
    )
    rows: str = frame.astype(whole).to_csv(index=False, quoting=quoting)
    return simulated + rows


def _as_file(name: str, value: Any) -> Any:
    if isinstance(value, (_core.Hardware, Model)):
        return FileText(name, ".toml", value.to_toml(), is_of_user=isinstance(value, Model))
    if hasattr(value, "to_csv"):
        return FileText(name, ".csv", _csv(value))
    return value


def _text(value: Any) -> str:
    if isinstance(value, Mapping):
        return ",".join(f"{key}={_text(item)}" for key, item in value.items())
    if isinstance(value, (Sequence, np.ndarray)) and not isinstance(value, str):
        return ",".join(_text(item) for item in value)
    if isinstance(value, _core.Routing):
        return value.word
    return str(value)


def _values(name: str, value: Any) -> list[Any]:
    if name not in _REPEATED or isinstance(value, (str, Integral)):
        return [value]
    if isinstance(value, Mapping):
        return [f"{key}={_text(item)}" for key, item in value.items()]
    return list(value)


def _is_there(path: Path, file: FileText) -> bool:
    """Whether it need not be written; raises InputError where another one would be lost."""
    if not os.path.lexists(path):
        return False
    if path.is_file() and path.read_bytes() == file.text.encode():
        return True
    expected = f"another folder, since {file.argument} is written to this file"
    raise InputError(
        f"{path}: already there, with other content: expected {expected}",
        where=str(path), what=file.argument, expected=expected,
    )


def _put(path: Path, text: str) -> None:
    """All of it or nothing, as the program writes its files."""
    part = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
    try:
        part.write_bytes(text.encode())
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


class Request:
    """Positional and other arguments of a subcommand."""

    def __init__(
        self,
        positionals: Mapping[str, Sequence[Any]] = {},
        options: Mapping[str, Any] = {},
        last: Sequence[str] = (),
    ) -> None:
        self._folder: Optional[Path] = None  # the folder of its files in the last run
        self._positionals = [
            _as_file(name, item) for name, items in positionals.items() for item in items
        ]
        self._options: list[tuple[str, Any]] = []
        for keyword, value in options.items():
            name = keyword.rstrip("_").replace("_", "-")
            if value is None or value is False:
                continue
            if value is True:
                self._options.append((name, True))
                continue
            value = _as_file(name, value)
            items = [value] if isinstance(value, FileText) else _values(name, value)
            self._options.extend((name, item) for item in items)
        self._last = list(last)

    def files(self) -> list[FileText]:
        """The values that are no files yet."""
        values = [*self._positionals, *(value for _, value in self._options)]
        return [value for value in values if isinstance(value, FileText)]

    def require_files(self) -> None:
        """What a store is made with is read again where it is ranked or merged."""
        if self.files():
            raise InputError(
                "store: expected files for hardware, model and cost, which outlive this process",
                what="store", expected="files for hardware, model and cost",
            )

    def _arguments(self, folder: Path) -> list[str]:
        def text(value: Any) -> str:
            return str(folder / value.name) if isinstance(value, FileText) else _text(value)

        named = [
            f"--{name}" if value is True else f"--{name}={text(value)}"
            for name, value in self._options
        ]
        return [*(text(item) for item in self._positionals), *named, *self._last]

    @contextmanager
    def arguments(self) -> Iterator[list[str]]:
        """The arguments, while the files that they name are there."""
        if not self.files():
            yield self._arguments(Path())
            return
        with tempfile.TemporaryDirectory(prefix="reeve-") as folder:
            self._folder = Path(folder)
            try:
                yield self._written(Path(folder))
            except InputError as error:
                raise error._changed(self.named) from None
            except OutOfRange as error:
                raise OutOfRange(self.named(str(error))) from None

    def arguments_for(self, folder: Union[str, Path]) -> list[str]:
        """The arguments that write into this folder; the files they name are put there."""
        if self.files():
            Path(folder).mkdir(parents=True, exist_ok=True)
        return [*self._written(Path(folder)), f"--out={folder}"]

    def _written(self, folder: Path) -> list[str]:
        missing = [file for file in self.files() if not _is_there(folder / file.name, file)]
        for file in missing:
            _put(folder / file.name, file.text)
        return self._arguments(folder)

    def named(self, text: str) -> str:
        """With the names of arguments in place of files that were there for the call alone."""
        if self._folder is None:
            return text
        for file in self.files():
            path = re.escape(str(self._folder / file.name))
            # An error about a Hardware names the key alone: nobody has seen its file.
            if not file.is_of_user:
                text = re.sub(path + r"(:\d+)*: (?=hardware\b)", "", text)
            text = re.sub(path + r"(?::(\d+))?", lambda found: file.place(found[1]), text)
        return text
