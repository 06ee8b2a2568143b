"""What can go wrong, as exceptions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Optional


class InputError(ValueError):
    """Input that the program would refuse with exit code 2.

    Attributes
    ----------
    where : str or None
        File and line, or the routing: ``"d.csv:3"``.
    what : str
        The column, option or quantity: ``"--shard"``.
    value : str or None
        What was given.
    expected : str
        What could have been given.
    parts : tuple of InputError
        Where one input has several faults: each of them.
    """

    def __init__(
        self,
        message: str,
        where: Optional[str] = None,
        what: str = "",
        value: Optional[str] = None,
        expected: str = "",
        parts: tuple["InputError", ...] = (),
    ) -> None:
        super().__init__(message)
        self.where = where
        self.what = what
        self.value = value
        self.expected = expected
        self.parts = parts

    def _changed(self, change: Callable[[str], str]) -> "InputError":
        """The same of other words."""
        return InputError(
            change(str(self)),
            None if self.where is None else change(self.where),
            change(self.what),
            None if self.value is None else change(self.value),
            change(self.expected),
            tuple(part._changed(change) for part in self.parts),
        )

    def __reduce__(self) -> tuple[Any, ...]:
        fields = (self.where, self.what, self.value, self.expected, self.parts)
        return (InputError, (str(self), *fields))


class OutOfRange(ArithmeticError):
    """Input that is well said but has no answer, such as tensions beyond any number."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during long work.

    Attributes
    ----------
    result
        What there was by then; None if that says nothing.
    """

    def __init__(self, result: object = None) -> None:
        super().__init__("interrupted")
        self.result = result


class Notice(UserWarning):
    """What one should know about a result: data that were taken otherwise than they stand."""
