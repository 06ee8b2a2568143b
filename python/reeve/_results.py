"""What the results of all subcommands have."""

from __future__ import annotations

import json
import warnings
from html import escape
from os import fspath
from typing import Any, Callable, Optional, TypeVar

from ._model import Place
from ._progress import Progress, close, listener
from ._request import Request
from .errors import Interrupted, Notice


class Result:
    """What a subcommand found.

    Attributes
    ----------
    summary : dict
        As the program's ``--format json`` prints it; docs/schema has its keys.
    """

    def __init__(self, report: Any, request: Request) -> None:
        self._report = report
        self._request = request
        self._summary: Optional[dict[str, Any]] = None
        self._call_data("")

    def _call_data(self, folder: str) -> None:
        """How the file is called that a data frame of readings is, or will be, in."""
        for file in self._request.files():
            if file.name.endswith(".csv"):
                self._report.call_data(f"{folder}/{file.name}" if folder else file.argument)

    @property
    def summary(self) -> dict[str, Any]:
        if self._summary is None:
            self._summary = json.loads(self._request.named(self._report.json()))
        return self._summary

    def _in_a_line(self) -> str:
        raise NotImplementedError

    def __repr__(self) -> str:
        return f"<reeve.{type(self).__name__}: {self._in_a_line()}>"

    def __str__(self) -> str:
        return self._request.named(str(self._report.text()))

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"


class SavedResult(Result):
    """A result that the program writes files of, too."""

    def save(self, folder: Place) -> None:
        """Writes the files and the page of the program's ``--out``, byte by byte.

        What was given as an object (a `Hardware`, a data frame) is put there as a file too, so
        that the command on the page can be run again. Another file of that name stays: it is an
        `InputError`, and nothing is written.
        """
        self._call_data(fspath(folder))
        try:
            self._report.save(self._request.arguments_for(fspath(folder)))
        finally:
            self._call_data("")


Kind = TypeVar("Kind", bound=Result)


def made(kind: Callable[[Any, Request], Kind], study: Any, request: Request) -> Kind:
    """The result of a study that takes no time."""
    with request.arguments() as arguments:
        report = study(arguments)
    result = kind(report, request)
    warn(result, request)
    return result


def run(
    kind: Callable[[Any, Request], Kind], study: Any, request: Request, progress: Progress
) -> Kind:
    """The result of a study that can be interrupted."""
    hears = listener(progress, stacklevel=4)
    try:
        with request.arguments() as arguments:
            report, interrupted = study(arguments, hears)
    finally:
        close(hears)
    result = None if report is None else kind(report, request)
    if interrupted or result is None:
        raise Interrupted(result)
    warn(result, request)
    return result


def in_no_folder(study: Any) -> Any:
    """The study with all that its page would show; `save` says where to."""
    return lambda arguments, hears: study([*arguments, "--out=."], hears)


def warn(result: Result, request: Request) -> None:
    """Its notes, at the line that called the subcommand's function."""
    for note in result.summary.get("notes") or []:
        text = note.get("text", str(note)) if isinstance(note, dict) else str(note)
        warnings.warn(request.named(text), Notice, stacklevel=4)
