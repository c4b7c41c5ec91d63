"""The lines of a TOML text on which its entries and members stand; its parser does not say."""

import re
from dataclasses import dataclass

# Strings and comments, in which there are no headers and no members.
_HIDDEN = re.compile(
    r'"""(?:\\.|[^\\])*?"{3,5}|\'\'\'.*?\'{3,5}|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\'|#[^\n]*', re.S
)


@dataclass(frozen=True)
class SourceLines:
    """The lines of a TOML text, with strings and comments blanked out."""

    lines: tuple[str, ...]

    @classmethod
    def of(cls, text: str) -> "SourceLines":
        """Return the lines of a text."""
        blank = _HIDDEN.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
        return cls(tuple(blank.split("\n")))

    def member(self, name: str) -> int:
        """Return the line of a member of the whole file; 1 if it is not found."""
        return self._line_of(name, 0, len(self.lines)) or 1

    def entry(self, table: str, number: int) -> int:
        """Return the line of the header of an array's entry; entries are counted from 0."""
        headers = self._headers(table)
        # An array may also be written on one line, as `table = [{...}, {...}]`.
        return headers[number] + 1 if number < len(headers) else self.member(table)

    def entry_member(self, table: str, number: int, name: str) -> int:
        """Return the line of a member of an array's entry; its header's line if it is not found."""
        headers = [*self._headers(table), len(self.lines)]
        if number + 1 >= len(headers):
            return self.entry(table, number)
        line = self._line_of(name, headers[number], headers[number + 1])
        return line or headers[number] + 1

    def _headers(self, table: str) -> list[int]:
        header = re.compile(rf"\s*\[\[\s*{re.escape(table)}\s*\]\]")
        return [number for number, line in enumerate(self.lines) if header.match(line)]

    def _line_of(self, name: str, first: int, last: int) -> int:
        member = re.compile(rf"\s*(\[\[?\s*(\w+\s*\.\s*)?)?{re.escape(name)}\s*[]=.]")
        for number in range(first, last):
            if member.match(self.lines[number]):
                return number + 1
        return 0
