"""What the check of an atlas finds, in a sentence for who opens it."""

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.check.check import check_atlas
from bodymeasure.atlas.check.finding import Severity
from bodymeasure.wording import counted

# Findings that are told; `bodymeasure check` lists all.
TOLD = 3


def check_sentences(atlas: Atlas) -> tuple[str, ...]:
    """Return what is wrong with an atlas, which can be looked at all the same.

    Parameters
    ----------
    atlas : Atlas

    Returns
    -------
    tuple of str
        One sentence with the first errors, or none if there are no errors.
    """
    errors = [found for found in check_atlas(atlas) if found.severity == Severity.ERROR]
    if not errors:
        return ()
    told = "; ".join(found.message for found in errors[:TOLD])
    return (
        f"The check of the atlas finds {counted(len(errors), 'error')}, near which lengths may "
        f"be wrong: {told}{'; …' if len(errors) > TOLD else ''}",
    )
