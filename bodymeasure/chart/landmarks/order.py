"""Rules with sides put in, in an order in which each follows those that it needs."""

from collections.abc import Collection, Iterable, Mapping

from bodymeasure.chart.landmarks.names import KNOWN_NAMES
from bodymeasure.chart.landmarks.rules import LandmarkRule
from bodymeasure.chart.reading.sides import both_sides
from bodymeasure.errors import InputError
from bodymeasure.wording import hint

# Fields of rules that name landmarks.
REFERENCES = ("start", "end", "of", "through", "above", "below")


def expanded(rules: Iterable[LandmarkRule]) -> dict[str, LandmarkRule]:
    """Rules by the names of their landmarks, with left and right put in for ``{side}``.

    Raises
    ------
    InputError
        If two rules give one landmark.
    """
    result: dict[str, LandmarkRule] = {}
    for rule in both_sides(tuple(rules)):
        if rule.name in result:
            raise InputError(
                f"two rules give landmark {rule.name!r}; leave one of them out, or rename it "
                "(a rule with {side} needs it in its name, too)"
            )
        result[rule.name] = rule
    return result


def references(rule: LandmarkRule) -> tuple[str, ...]:
    """Names of the landmarks that a rule needs."""
    names = (getattr(rule, field, None) for field in REFERENCES)
    return tuple(dict.fromkeys(name for name in names if name is not None))


def in_order(rules: Mapping[str, LandmarkRule], picked: Collection[str]) -> list[LandmarkRule]:
    """Rules that are needed, each after those whose landmarks it refers to.

    Parameters
    ----------
    rules : mapping of str to LandmarkRule
        As `expanded` gives them.
    picked : collection of str
        Names of the landmarks that are there; they need no rule.

    Raises
    ------
    InputError
        If rules need one another in a circle, or a name is neither picked, nor of a rule, nor one
        that ISO 8559-1 or this program knows.
    """
    done: dict[str, LandmarkRule] = {}

    def visit(name: str, chain: tuple[str, ...]) -> None:
        if name in chain:
            circle = " needs ".join(repr(link) for link in (*chain[chain.index(name) :], name))
            raise InputError(
                f"rules for landmarks need one another in a circle: {circle}; pick one of these "
                "landmarks, or give one another rule"
            )
        if name in picked or name in done:
            return
        if name not in rules:
            _refuse_unknown(name, chain, {*picked, *rules, *KNOWN_NAMES})
            return
        for needed in references(rules[name]):
            visit(needed, (*chain, name))
        done[name] = rules[name]

    for name, rule in rules.items():
        visit(name, ())
        # A picked landmark needs no rule, but its rule may be misspelled all the same.
        for needed in references(rule):
            if needed not in picked and needed not in rules:
                _refuse_unknown(needed, (name,), {*picked, *rules, *KNOWN_NAMES})
    return list(done.values())


def _refuse_unknown(name: str, chain: tuple[str, ...], known: Collection[str]) -> None:
    if name in known:
        return
    needs = " needs ".join(repr(link) for link in (*chain, name))
    near = hint(name, sorted(known))
    remedy = near if near.startswith("did you mean") else "pick it, or give it a rule"
    raise InputError(f"no landmark is called {name!r} ({needs}); {remedy}")
