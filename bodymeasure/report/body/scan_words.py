"""How far values can be trusted on a body that was fitted to a scan, in words."""

from statistics import median

from msgspec import UNSET

from bodymeasure.report.body.records import BodyRecord, ChartDocument
from bodymeasure.report.body.tape import change_text, small_text
from bodymeasure.report.numbers import NONE, SPACE


def input_text(record: BodyRecord) -> str:
    """Return the uncertainty of a value that comes from the scan, as a tape shows it."""
    size = record.input_uncertainty
    if size is UNSET or size is None or record.value is None:
        return NONE
    return f"±{SPACE}{change_text(record.unit, size)}"


def scan_sentences(document: ChartDocument) -> list[str]:
    """Return how far the values can be trusted on a body that was fitted to a scan."""
    scan = document.scan
    if scan is UNSET:
        return []
    sizes = _sizes(document)
    distance = small_text(scan.distance, document.unit)
    sentences = [
        f"The body was fitted to a scan; its surface lies {distance} from it (root mean square)."
    ]
    if sizes:
        least, middle, most = (
            f"±{SPACE}{change_text(document.unit, each)}"
            for each in (sizes[0], median(sizes), sizes[-1])
        )
        sentences.append(
            "A length is as good as the scan and the places of its landmarks: these leave the "
            f"values uncertain by {least} to {most}, half of them by more than {middle}. The "
            "true value lies within twice that in about 19 of 20 cases, if the scan itself is of "
            "the right size, and shows skin and no clothes."
        )
    return [*sentences, *scan.warnings]


def scan_tile(document: ChartDocument) -> tuple[str, str, str] | None:
    """Return the key figure of a scan, with a heading and a remark; None without a scan."""
    sizes = _sizes(document)
    if not sizes:
        return None
    least, most = (change_text(document.unit, each) for each in (sizes[0], sizes[-1]))
    return "Uncertain from the scan", f"± {least} to {most}", "by the surface and the landmarks"


def _sizes(document: ChartDocument) -> list[float]:
    """Return the uncertainties of lengths that come from the scan, the smallest first."""
    return sorted(
        each.input_uncertainty
        for each in document.measurements
        if each.unit == document.unit and isinstance(each.input_uncertainty, float)
    )
