"""What taut raises."""

from __future__ import annotations


class InputError(ValueError):
    """The input is wrong. str() is one line that names file, line and culprit, as far as each is known.

    file: the file's name, or None; line: from 1, or None; culprit: the message without both.
    """

    def __init__(self, message: str, file: str | None = None, line: int | None = None, culprit: str | None = None):
        super().__init__(message)
        self.file = file
        self.line = line
        self.culprit = message if culprit is None else culprit

    def __reduce__(self):
        return type(self), (str(self), self.file, self.line, self.culprit)


class TooFine(ValueError):
    """The input is sound, but what is built from it cannot be rounded to doubles."""


class Unproven(RuntimeError):
    """Nothing was found, which does not prove that there is nothing."""


for _error in (InputError, TooFine, Unproven):
    _error.__module__ = "taut"
