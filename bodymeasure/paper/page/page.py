"""The page of the reproduction, one self-contained file."""

from bodymeasure.paper.data.random_patches import GROUP_SIZE
from bodymeasure.paper.page import analysis_charts, charts
from bodymeasure.paper.page.sections import CHOICES, LONG, sections_of, tiles
from bodymeasure.paper.page.shown import shown
from bodymeasure.paper.reproduction import BODY, CHOSEN, Reproduction
from bodymeasure.report import templating


def render_page(found: Reproduction) -> bytes:
    """Return a reproduction as one HTML page that loads nothing else.

    Raises
    ------
    MissingExtraError
        If jinja2 or matplotlib is not installed.
    """
    context = {
        "found": found,
        "sections": sections_of(found),
        "pictures": _pictures(found),
        "choices": CHOICES,
        "tiles": tiles(found),
        "long": LONG,
        "full_group": GROUP_SIZE,
    }
    return templating.render_page(
        "bodymeasure.paper",
        "paper.html.j2",
        context,
        feature="the HTML page",
        filters={"shown": shown},
    )


def _pictures(found: Reproduction) -> dict[str, list[tuple[str, str]]]:
    """Return the charts by section, each with its caption."""
    beyond, future = found.table("beyond"), analysis_charts
    made = {
        "readings": [
            (
                charts.roots_chart(found.table("roots"), "roots"),
                "The number of patches that have so many real solutions at t = 1/2, by reading.",
            )
        ],
        "truth": [
            (
                charts.distribution_chart(found.table("distribution"), CHOSEN, "distribution"),
                f"The sizes of the differences for the reading “{CHOSEN}”. Where the line of "
                "radial functions against Ritz lies on that against the truth, the accuracy loss "
                "is that of the two functions.",
            )
        ],
        "table5": [
            (
                charts.distribution_chart(found.table("body_distribution"), BODY, "body"),
                "The sizes of the relative errors (17) of all curves.",
            )
        ],
        "beyond": [
            (
                charts.accuracy_chart(beyond, charts.METHODS, "methods"),
                "The error of the length of the computed path, without the correction.",
            ),
            (
                charts.accuracy_chart(beyond, charts.PLACINGS, "placings"),
                "The same for the paper's kernel, by the places of centers and collocation points.",
            ),
            (
                charts.cost_chart(beyond, charts.METHODS, "cost"),
                "The error with the correction against processor time, with a point for each "
                "number of functions.",
            ),
        ],
        "future": [
            (
                future.forms_chart(found.table("future_forms"), "forms"),
                "The error of the length of the computed path by both forms.",
            ),
            (
                future.orders_chart(found.table("future_model"), "orders"),
                "Errors on the linear model, whose slopes are the orders of convergence.",
            ),
            (
                future.slopes_chart(found.table("future_slopes"), "slopes"),
                "Errors of lengths against errors of paths: the length of the path falls with the "
                "square, and the corrected length faster.",
            ),
            (
                future.quadrature_chart(found.table("future_quadrature"), "quadrature"),
                "How many lengths of the weak form lie below the truth, by the number of points.",
            ),
            (
                future.conjugate_chart(found.table("future_conjugate"), "conjugate"),
                "Arcs of a great circle as their ends come near to conjugate points.",
            ),
        ],
    }
    return {
        anchor: [(templating.data_uri(svg), caption) for svg, caption in pictures]
        for anchor, pictures in made.items()
    }
