"""SeamlyMe's files, checked by the published schema of individual measurements, 0.3.4."""

import re
import unicodedata
from collections.abc import Callable
from dataclasses import replace
from datetime import date
from xml.etree import ElementTree

import msgspec
import pytest
from helpers.charts.hand_made_chart import BUST, MEASURED, hand_made_chart

from bodymeasure.chart import Measured, Outcome
from bodymeasure.errors import InputError
from bodymeasure.report.body import chart_document, to_smis

Check = Callable[[str], bool]


def _is_date(text: str) -> bool:
    try:
        return date.fromisoformat(text).isoformat() == text
    except ValueError:
        return False


def _anything(_text: str) -> bool:
    return True


# The elements in their order, each with the text or the elements that it must hold.
PERSONAL: list[tuple[str, Check]] = [
    ("family-name", _anything),
    ("given-name", _anything),
    ("birth-date", _is_date),
    ("gender", lambda text: text in {"unknown", "male", "female"}),
    ("email", _anything),
]
HEAD: list[tuple[str, Check]] = [
    ("version", lambda t: re.fullmatch(r"(0|[1-9][0-9]*)(\.(0|[1-9][0-9]*)){2}", t) is not None),
    ("read-only", lambda text: text in {"true", "false", "1", "0"}),
    ("notes", _anything),
    ("unit", lambda text: text in {"mm", "cm", "inch"}),
    ("pm_system", lambda t: re.fullmatch(r"([0-9]|[1-4][0-9]|5[0-4])|998", t) is not None),
]
# Characters that a short name must not hold: those of the schema's pattern, with \p{Zs} and, in
# front, \p{Nd} and the apostrophe.
FORBIDDEN = set('*/&|!<>^-()\u2013+\u2212=?:;"')


def faults(content: bytes) -> list[str]:
    """The faults that the schema would find in a file; none if it is valid."""
    root = ElementTree.fromstring(content)
    found = [] if root.tag == "smis" else [f"root {root.tag}"]
    expected = [*(tag for tag, _ in HEAD), "personal", "body-measurements"]
    if [child.tag for child in root] != expected:
        return [*found, f"order {[child.tag for child in root]}"]
    *head, personal, measurements = root
    if [child.tag for child in personal] != [tag for tag, _ in PERSONAL]:
        return [*found, "order of personal"]
    for element, (tag, check) in [
        *zip(head, HEAD, strict=True),
        *zip(personal, PERSONAL, strict=True),
    ]:
        if not check(element.text or ""):
            found.append(f"{tag} {element.text!r}")
    names = [m.get("name", "") for m in measurements]
    found += [f"twice {name}" for name in set(names) if names.count(name) > 1]
    for m in measurements:
        if m.tag != "m" or not set(m.attrib) <= {"name", "value", "full_name", "description"}:
            found.append(f"element {m.tag} {sorted(m.attrib)}")
        if not {"name", "value"} <= set(m.attrib):
            found.append("an attribute is missing")
    found += [f"name {name!r}" for name in names if not _is_short_name(name)]
    return found


def _is_short_name(name: str) -> bool:
    if not name or name[0] == "'" or unicodedata.category(name[0]) == "Nd":
        return False
    return not any(c in FORBIDDEN or unicodedata.category(c) == "Zs" for c in name)


def values(content: bytes) -> dict[str, str]:
    measurements = ElementTree.fromstring(content).find("body-measurements")
    assert measurements is not None
    return {m.attrib["name"]: m.attrib["value"] for m in measurements}


@pytest.mark.parametrize(
    ("unit", "written", "bust"),
    [
        ("cm", "cm", "91.320"),
        ("mm", "mm", "913.20"),
        ("inch", "inch", "35.9528"),
        # The format has no meters.
        ("m", "cm", "91.320"),
    ],
)
def test_the_file_is_valid_in_each_unit(unit: str, written: str, bust: str) -> None:
    content = to_smis(chart_document(hand_made_chart(), unit))
    assert faults(content) == []
    root = ElementTree.fromstring(content)
    assert root.findtext("version") == "0.3.4"
    assert root.findtext("unit") == written
    # The value is that of the right arm, though the left one comes first; unmeasured ones are left
    # out.
    arm = f"{float(bust) * 302.0 / 913.2:.{len(bust.partition('.')[2])}f}"
    assert values(content) == {"bust_circ": bust, "arm_upper_circ": arm, "shoulder_slope": "23.58"}
    assert "Anna <Muster>" in (root.findtext("notes") or "")


def test_the_left_side_serves_where_the_right_one_has_no_value() -> None:
    measured = list(MEASURED)
    measured[2] = Measured(measured[2].definition, Outcome.REFUSED, reason="the loop merges")
    content = to_smis(chart_document(hand_made_chart(measured=tuple(measured)), "cm"))
    assert values(content)["arm_upper_circ"] == "30.100"


def test_nothing_measured_is_a_valid_file_too() -> None:
    content = to_smis(chart_document(hand_made_chart(measured=()), "cm"))
    assert faults(content) == []
    assert values(content) == {}


def test_what_xml_cannot_hold_is_replaced() -> None:
    chart = hand_made_chart()
    chart = replace(chart, atlas=replace(chart.atlas, name='bell \x07 & "Anna" \u00e4'))
    content = to_smis(chart_document(chart, "cm"))
    assert faults(content) == []
    assert 'bell \ufffd & "Anna" \u00e4' in (
        ElementTree.fromstring(content).findtext("notes") or ""
    )


@pytest.mark.parametrize("name", ["bust circ", "1st", "a-b", "a+b", "", "x\u2212y", "'quoted"])
def test_names_that_seamly_would_refuse_are_refused(name: str) -> None:
    bust = replace(MEASURED[0], definition=msgspec.structs.replace(BUST, seamly=(name,)))
    assert not _is_short_name(name)
    with pytest.raises(InputError, match=r"'bust_girth'.*cannot be a name in Seamly2D"):
        to_smis(chart_document(hand_made_chart(measured=(bust,)), "cm"))


def test_the_checker_itself_refuses_what_is_wrong() -> None:
    good = to_smis(chart_document(hand_made_chart(), "cm"))
    for old, new in (
        (b"<unit>cm<", b"<unit>m<"),
        (b"998", b"55"),
        (b"bust_circ", b"2bust"),
        (b"bust_circ", b"arm_upper_circ"),
        (b"unknown", b"none"),
        (b"1800-01-01", b"1800"),
        (b"<email />", b""),
        (b"0.3.4", b"0.3"),
    ):
        assert old in good
        assert faults(good.replace(old, new, 1)) != [], new
