"""The place at which the JSON of a file is broken."""

import json
import re


def place_of_fault(content: bytes, reason: str) -> str:
    """Return the line at which a file is not JSON and the reason, to follow the file's name."""
    try:
        text = content.decode()
        json.loads(text)
    except UnicodeDecodeError:
        return ": is not text in UTF-8; expected JSON"
    except json.JSONDecodeError as error:
        return (
            f", line {error.lineno}: is not valid JSON ({error.msg}); "
            "the file may have been cut off or edited by hand"
        )
    except RecursionError:
        return ": is nested too deeply to be an atlas"
    # The standard library takes NaN and Infinity, which JSON does not have.
    match = re.search(r"-?\b(NaN|Infinity)\b", text)
    if match is None:
        return f": is not valid JSON ({reason})"
    line = text.count("\n", 0, match.start()) + 1
    return f", line {line}: {match.group()} is not a number; expected finite coordinates"
