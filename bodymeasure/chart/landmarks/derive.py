"""Landmarks that follow from others by rule."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field

from bodymeasure.arguments import several
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.chart.landmarks.names import KNOWN_NAMES
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.sides import both_sides
from bodymeasure.errors import BodymeasureError, InputError
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import hint


@dataclass(frozen=True, eq=False)
class Derived:
    """The landmarks of an atlas, its own and those that follow by rule.

    Parameters
    ----------
    landmarks : mapping of str to AtlasPoint
        The atlas's own landmarks come first.
    missing : mapping of str to str
        The landmarks that rules could not give, each with the reason.
    rules : mapping of str to LandmarkRule
        The rule of each landmark that is not the atlas's own, with left or right in place of
        ``{side}``; the rules of missing landmarks are among them.
    """

    landmarks: Mapping[str, AtlasPoint]
    missing: Mapping[str, str]
    rules: Mapping[str, LandmarkRule] = field(default_factory=dict, repr=False)


@one_blas_thread()
def derive_landmarks(
    atlas: Atlas, rules: Iterable[LandmarkRule], *, strict: bool = True
) -> Derived:
    """Find the landmarks that rules give on an atlas.

    Parameters
    ----------
    atlas : Atlas
        Its own landmarks take precedence over rules of the same name.
    rules : iterable of LandmarkRule
        In any order; they may refer to one another. ``{side}`` stands for left and right in turn.
    strict : bool
        Whether it is an error if a rule needs a landmark whose name is neither the atlas's, nor a
        rule's, nor one that ISO 8559-1 or this program knows. Otherwise the rule's landmark is
        missing.

    Returns
    -------
    Derived
        A landmark whose rule cannot be fulfilled on this body is missing, with the reason.

    Raises
    ------
    InputError
        If two rules give one landmark, rules need one another in a circle, or a name is unknown.

    Notes
    -----
    All points lie on the smooth surface and are exact except for rounding; points on geodesics are
    as exact as the geodesics. If points are equally far because they are mirror images, the one on
    the side of the landmark to which the rule refers is taken, else the one on the wearer's left.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from bodymeasure.chart.landmarks.rules import Median
    >>> navel = Median(name="navel", of="elbow point left", through="crotch point", facing="front")
    >>> derived = derive_landmarks(bm.load_sample("female_average"), [navel])
    >>> "navel" in derived.landmarks, derived.missing
    (True, {})
    """
    require_atlas(atlas)
    rules = several(rules, LandmarkRule, "the rules", "a rule for a landmark")
    by_name: dict[str, LandmarkRule] = {}
    for rule in both_sides(rules):
        if rule.name in by_name:
            raise InputError(
                f"two rules give landmark {rule.name!r}; leave one of them out, or rename it "
                "(a rule with {side} needs it in its name, too)"
            )
        by_name[rule.name] = rule
    known = {*atlas.landmarks, *by_name, *KNOWN_NAMES}
    search = _Search(atlas, by_name, known, strict, dict(atlas.landmarks))
    for name in by_name:
        search.find(name, ())
    return Derived(search.landmarks, search.missing, search.done)


@dataclass
class _Search:
    """A search for landmarks in which each rule follows those whose landmarks it needs."""

    atlas: Atlas
    rules: Mapping[str, LandmarkRule]
    known: Collection[str]
    strict: bool
    landmarks: dict[str, AtlasPoint]
    missing: dict[str, str] = field(default_factory=dict)
    done: dict[str, LandmarkRule] = field(default_factory=dict)

    def find(self, name: str, chain: tuple[str, ...]) -> None:
        """Find the landmark of a rule that the rules in `chain` need, or why there is none."""
        if name in chain:
            circle = " needs ".join(repr(link) for link in (*chain[chain.index(name) :], name))
            raise InputError(
                f"rules for landmarks need one another in a circle: {circle}; pick one of these "
                "landmarks, or give one another rule"
            )
        if name in self.done:
            return
        rule, chain = self.rules[name], (*chain, name)
        picked = name in self.atlas.landmarks
        for needed in rule.landmarks:
            # A picked landmark needs no rule, but its rule may be misspelled all the same.
            if needed not in self.known and self.strict:
                needs = " needs ".join(repr(link) for link in (*chain, needed))
                raise InputError(
                    f"no landmark is called {needed!r} ({needs}); {self._remedy(needed)}"
                )
            if needed in self.rules and needed not in self.atlas.landmarks and not picked:
                self.find(needed, chain)
        if picked:
            return
        self.done[name] = rule
        reason = next(filter(None, map(self._lack, rule.landmarks)), "")
        try:
            if fault := next(rule.faults(), None):
                raise InputError(fault.words)
            if not reason:
                self.landmarks[name] = rule.point(self.atlas, self.landmarks)
        except BodymeasureError as error:
            reason = str(error)
        if reason:
            self.missing[name] = reason

    def _lack(self, name: str) -> str:
        """Return why a rule cannot have a landmark that it needs; empty if it can."""
        if name in self.landmarks:
            return ""
        if name in self.missing:
            return f"it needs {name!r}, which is missing: {self.missing[name]}"
        if name in self.known:
            return f"it needs {name!r}, which the atlas lacks and no rule gives; pick it"
        return f"it needs {name!r}, which no landmark is called; {self._remedy(name)}"

    def _remedy(self, name: str) -> str:
        near = hint(name, sorted(self.known))
        return near if near.startswith("did you mean") else "pick it, or give it a rule"
