"""The form in which the page and the summary show values."""

from bodymeasure.paper.tables.table import Column, Value
from bodymeasure.report import numbers

# Below this, a percentage needs more than one decimal.
SMALL_SHARE = 0.01


def shown(value: Value, column: Column) -> str:
    """Return a value as the page shows it; a dash for None."""
    if value is None:
        return numbers.NONE
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    match column.kind:
        case "count":
            return f"{value:,}"
        case "number":
            return f"{value:,}" if isinstance(value, int) else f"{value:,.2f}"
        case "length":
            return f"{value:#.6g}"
        case "percent":
            return numbers.percent(value)
        case "fine":
            return numbers.percent(value, 3)
        case "share":
            return f"{100.0 * value:.{1 if value >= SMALL_SHARE else 3}f}\N{NO-BREAK SPACE}%"
        case "small":
            return numbers.scientific(value)
        case "seconds":
            return f"{value:.3f}"
        case "factor":
            return f"{value:,.2f}" if value < 10 else f"{value:,.0f}"
        case "text":
            return str(value)
