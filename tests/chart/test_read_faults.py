"""The messages about bad files of definitions."""

import re

import pytest
from helpers.charts.definition_files import HEAD, PATH, entry, fault, read
from hypothesis import given
from hypothesis import strategies as st

from bodymeasure.chart import Definitions
from bodymeasure.chart.reading.read import DEFAULT, definitions_from
from bodymeasure.errors import InputError

FAULTS = [
    ("", r"my.toml, line 1: is not a file of bodymeasure measurements; expected format = "),
    ('format = "bodymeasure atlas"', r"line 1: is not a file of bodymeasure meas.*'bodymeasure at"),
    (
        HEAD.replace("= 1", "= 2"),
        r"line 2: has version 2; this bodymeasure reads version 1; update",
    ),
    (HEAD.replace("= 1", "= true"), r"line 2: has version True"),
    (HEAD.replace('name = "Mine"', ""), r"line 1: the set has no name; add a line such as name ="),
    (HEAD + "name = 3\n", r"line 4: is not valid TOML \(Cannot overwrite a value at column 9\)"),
    (HEAD.replace('"Mine"', "3"), r"line 3: name: expected text, got a whole number"),
    (HEAD + "words =\n", r"line 4: is not valid TOML \(Invalid value at column 8\); compare with"),
    (HEAD + 'words = "', r"line 4: is not valid TOML \(Unterminated string at the end of the file"),
    (HEAD + f"words = {'1' * 5000}", r"holds a value that cannot be read \(Exceeds the limit"),
    (HEAD + f"words = {'[' * 5000}", r"my.toml: is nested too deeply to hold definitions"),
    (
        HEAD + "mesurement = []",
        r"line 4: has the unknown member 'mesurement'; did you mean 'measur",
    ),
    (HEAD + "zzz = []", r"unknown member 'zzz'; expected one of format, version, name, words, ext"),
    (
        HEAD + "measurement = 3",
        r"line 4: measurement is no list of entries; begin each with a line",
    ),
    (HEAD + "measurement = [3]", r"line 4: measurement 1: expected a table of members, got 3"),
    (HEAD + 'extends = "mine"', r"line 4: extends is 'mine'; only 'default' can be extended"),
    (
        HEAD + 'drop = ["a"]',
        r"line 4: drop names 'a', .* a set without extends = \"default\" has n",
    ),
    (
        HEAD + 'extends = "default"\ndrop = ["waist_girt"]',
        r"line 5: drop names 'waist_girt', which is not in what is extended; did you mean 'waist_g",
    ),
    (HEAD + "drop = 3", r"line 4: drop: expected a list, got a whole number"),
    (
        HEAD + PATH.replace("kind", "knid"),
        r"line 5: measurement 'back': has no 'kind'; add one of 'formula', 'extreme girth', 'gi",
    ),
    (
        HEAD + PATH.replace('"path"', '"pth"'),
        r"line 7: measurement 'back': has the unknown kind 'pth'; did you mean 'path'\?",
    ),
    (
        HEAD + PATH.replace('"path"', "7"),
        r"line 7: measurement 'back': has the unknown kind 7; exp",
    ),
    (
        HEAD + PATH.replace("through", "trough"),
        r"line 9: measurement 'back': has the unknown member 'trough'; did you mean 'through'\? "
        r"\(a measurement of the kind 'path' has: kind, key, name,",
    ),
    (
        HEAD + PATH.replace("key =", "# key ="),
        r"line 5: measurement 1: has no 'key', which the kind 'path' needs; add it",
    ),
    (
        HEAD + PATH.replace('"back waist point"', "2"),
        r"line 9: measurement 'back': through\[1\]: expected text, got a whole number",
    ),
    (
        HEAD + PATH.replace('"back neck point", ', ""),
        r"line 9: measurement 'back': through needs two landmarks or more",
    ),
    (
        HEAD + PATH + 'tape = "loose"',
        r"line 10: measurement 'back': tape is 'loose'; expected one of 'contact', 'taut', 'both'",
    ),
    (HEAD + PATH + "tape = true", r"line 10: measurement 'back': tape is true; expected one of"),
    (
        HEAD + PATH + '[measurement.iso]\nnme = "x"',
        r"line 10: measurement 'back': iso: .*`nme`",
    ),
    (
        HEAD + PATH.replace('"back"', '"back length"'),
        r"line 6: measurement 'back length': the key 'back length' cannot stand in a formula; exp",
    ),
    (HEAD + PATH.replace('"back"', '"1st"'), r"the key '1st' cannot stand in a formula"),
    (HEAD + PATH.replace('"back"', '"max"'), r"line 6: .*the key 'max' is a function's name"),
    (
        HEAD + PATH.replace('"Back"', '" "'),
        r"line 8: measurement 'back': name is empty; expected a",
    ),
    (
        HEAD + PATH.replace('"Back"', '"a\\nb"'),
        r"line 8: .*name is 'a\\nb'; expected text on one l",
    ),
    (
        HEAD + PATH + PATH,
        r"line 12: measurement 'back': the key 'back' is there twice, first on line 6; rename",
    ),
    (
        HEAD + PATH.replace("back waist", "{side} waist"),
        r"line 9: .*through has {side}, but the key 'back' has not, so that left and right could n",
    ),
    (
        HEAD + PATH.replace('"back"', '"back_{side}"').replace('"Back"', '"Back {side}"'),
        r"line 6: .*the key 'back_{side}' has {side}, but nothing that is measured has",
    ),
    (
        HEAD + PATH.replace('"back"', '"b_{side}"').replace("waist point", "waist point {side}"),
        r"line 8: .*the key 'b_{side}' has {side}, but the name has not",
    ),
    (
        HEAD + PATH.replace("back waist", "{sied} waist"),
        r"line 9: .*through holds '{sied}'; only {side} has a meaning",
    ),
    (
        HEAD
        + entry("height", 'at = "a {side}"', "h_{side}").replace('"It"', '"It {side}"')
        + entry("height", 'at = "b"', "h_left"),
        r"line 12: .*the key 'h_left' is there twice \(as 'h_{side}' gives it\)",
    ),
    (
        HEAD + entry("girth", 'at = "a"\ncut = ["b"]'),
        r"line 10: measurement 'it': cut: expected a list of length 2, got 1",
    ),
    (
        HEAD + entry("girth arc", 'at = "a"\nstart = "b"\nend = "b"\nside = "front"'),
        r"line 11: measurement 'it': leads from 'b' to the same landmark, which is 0 on every body",
    ),
    (
        HEAD + entry("limb girth", 'start = "a"\nend = "b"\nat = 1.5'),
        r"line 11: measurement 'it': at is 1.5; expected 0 to 1, or a landmark's name",
    ),
    (
        HEAD + entry("limb girth", 'start = "a"\nend = "b"\nat = true'),
        r"line 11: measurement 'it': at: expected a number or text, got true or false",
    ),
    (
        HEAD + entry("height", "at = 1979-05-27"),
        r"line 9: measurement 'it': at: expected text, got",
    ),
    (
        HEAD + entry("path", 'through = ["a", "b", "b"]'),
        r"line 9: measurement 'it': leads from 'b' to the same landmark, which is 0 on every body",
    ),
    (
        HEAD + entry("girth", 'at = "a"\nlimb = true\ncut = ["b", "c"]'),
        r"line 11: measurement 'it': cut is for the trunk, limb for a leg or arm; give one",
    ),
    (
        HEAD + entry("chord", 'start = "a"\nend = "a"'),
        r"line 10: measurement 'it': leads from 'a' to the same landmark",
    ),
    (
        HEAD + entry("height", 'at = "a"\nabove = "a"'),
        r"line 10: measurement 'it': leads from 'a' to the same landmark",
    ),
    (
        HEAD + entry("formula", 'formula = "itt + 1"'),
        r"line 9: measurement 'it': the formula 'itt \+ 1' names 'itt', which is no key here; did",
    ),
    (
        HEAD + entry("formula", 'formula = "it *"'),
        r"line 9: measurement 'it': the formula 'it \*' is no arithmetic: invalid syntax",
    ),
    (
        HEAD + PATH + entry("formula", 'formula = "back + 1"'),
        r"line 15: .*the formula 'back \+ 1' has mixed units: 'back \+ 1' puts together a len",
    ),
    (
        HEAD + PATH + entry("formula", 'formula = "back / back"'),
        r"line 15: .*has mixed units: it gives a pure number, not a length; change the formula",
    ),
    (
        HEAD + PATH + entry("formula", 'formula = "atan(back / back)"'),
        r"line 15: .*has mixed units: it gives an angle, not a length; say `angle = true`",
    ),
    (
        HEAD
        + entry("formula", 'formula = "b + b"', "a")
        + entry("formula", 'formula = "2 * c"', "b")
        + entry("formula", 'formula = "a"', "c"),
        r"the formulas go round in a circle: (a -> b -> c -> a|b -> c -> a -> b|c -> a -> b -> c)",
    ),
    (
        HEAD + entry("formula", 'formula = "it"'),
        r"the formulas go round in a circle: it -> it; def",
    ),
    (
        HEAD + '[[landmark]]\nname = "a"\nrule = "betwen"',
        r"line 6: landmark 'a': has the unknown rule 'betwen'; did you mean 'between'\?",
    ),
    (
        HEAD + '[[landmark]]\nname = "a"\nrule = "between"\nstart = "b"\nend = "c"\nfraction = 2',
        r"line 9: landmark 'a': fraction is 2.0; expected 0 to 1",
    ),
    (
        HEAD + '[[landmark]]\nname = "a"\nrule = "level"\nof = "b"\nfacing = "north"',
        r"line 8: landmark 'a': facing is 'north'; expected one of 'front', 'back', 'left'",
    ),
    (
        HEAD + '[[landmark]]\nname = "a"\nrule = "level"\nof = "b {side}"\nfacing = "left"',
        r"line 7: landmark 'a': of has {side}, but the name 'a' has not; write it in both, such as",
    ),
    (
        HEAD + 'extends = "default"\ndrop = ["waist_to_hip_left"]',
        r"drop names 'waist_to_hip_left', .*did you mean 'waist_to_hip_{side}'\?",
    ),
    (
        HEAD + 'extends = "default"\ndrop = ["waist_to_hip_{side}"]',
        r"line 5: 'outer_leg_length_{side}' of the default set, with the changes that this file mak"
        r".*names 'waist_to_hip_left', which is no key here",
    ),
]


@pytest.mark.parametrize(("text", "message"), FAULTS, ids=[message for _, message in FAULTS])
def test_what_is_wrong_is_said(text: str, message: str) -> None:
    found = fault(text)
    assert found.startswith("my.toml")
    assert re.search(message, found), found


def test_lines_are_not_misled_by_strings_and_comments() -> None:
    text = HEAD + (
        'words = """\n[[measurement]]\nthrough = 1\n"""\n# [[measurement]]\n'
        + PATH
        + "words = '''\n[[measurement]]\n'''\ntape = \"loose\"\n"
    )
    line = text.split("\n").index('tape = "loose"') + 1
    assert f"line {line}: measurement 'back': tape is 'loose'" in fault(text)
    inline = HEAD + 'measurement = [\n{key = "a", name = "A", kind = "height", at = 3}]'
    assert "my.toml, line 4: measurement 'a': at: expected text" in fault(inline)


def test_text_that_is_no_utf8_is_refused() -> None:
    with pytest.raises(InputError, match=r"my.toml, line 2: is not text in UTF-8; save the file"):
        definitions_from(b"a = 1\nb = '\xff'", "my.toml")


DEFAULT_TEXT = DEFAULT.read_text("utf-8")


@given(
    at=st.integers(0, len(DEFAULT_TEXT)),
    length=st.integers(0, 40),
    inserted=st.text(alphabet="[]{}\"=.,#\n\\'x1 -\x00é", max_size=6),
)
def test_no_damage_to_a_file_is_a_surprise(at: int, length: int, inserted: str) -> None:
    text = DEFAULT_TEXT[:at] + inserted + DEFAULT_TEXT[at + length :]
    try:
        assert isinstance(read(text), Definitions)
    except InputError as error:
        assert str(error).startswith("my.toml")  # noqa: PT017


@given(
    st.dictionaries(
        st.sampled_from(["key", "kind", "name", "at", "tape", "through", "iso", "seamly", "words"]),
        st.one_of(
            st.sampled_from(['"girth"', '"path"', '"height"', '"{side}"', '"a_{side}"', '["a"]']),
            st.sampled_from(["1", "1.5", "nan", "true", "1979-05-27", "[]", "{}", '""', "[[1]]"]),
        ),
    )
)
def test_no_member_of_any_type_is_a_surprise(members: dict[str, str]) -> None:
    lines = "\n".join(f"{name} = {value}" for name, value in members.items())
    try:
        assert isinstance(read(f"{HEAD}[[measurement]]\n{lines}\n"), Definitions)
    except InputError as error:
        assert re.match(r"my.toml, line \d+: measurement ", str(error))  # noqa: PT017
