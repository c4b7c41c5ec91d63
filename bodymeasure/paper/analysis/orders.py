"""The orders at which the paper's functions converge, in both forms."""

from typing import NamedTuple

from bodymeasure.geodesic import WU_C2, WU_C4, WU_C6, WU_C10, Kernel
from bodymeasure.paper.analysis.linear_model import Form, fitted_order, model_error
from bodymeasure.paper.tables.table import Column, Table

KERNELS = (WU_C2, WU_C4, WU_C6, WU_C10)
FORMS: tuple[Form, ...] = ("weak", "collocation")
# With fewer functions, errors of the smooth kernels are not yet in their final fall.
COUNTS: dict[Form, tuple[int, ...]] = {
    "weak": (8, 11, 15, 20, 27, 36),
    "collocation": (11, 15, 20, 27, 36),
}
# The order in L2 is so much above that in H1, t - 1/2.
L2_GAIN: dict[Form, float] = {"weak": 1.0, "collocation": 0.5}


class _Order(NamedTuple):
    kernel: str
    smoothness: int
    form: str
    l2: float
    l2_expected: float
    h1: float
    h1_expected: float


class _Error(NamedTuple):
    kernel: str
    form: str
    functions: int
    l2: float
    h1: float


def native_smoothness(kernel: Kernel) -> int:
    """Return the t of the kernel's native space H^t: its first odd power is 2 t - 1."""
    powers = [k for k, c in enumerate(kernel.coefficients) if k % 2 and c]
    return (powers[0] + 1) // 2


def expected_orders(kernel: Kernel, form: Form) -> tuple[float, float]:
    """Return the orders in L2 and in H1 that theory or, for collocation, experience gives."""
    t = native_smoothness(kernel)
    return t - 0.5 + L2_GAIN[form], t - 0.5


def orders(kernel: Kernel, form: Form) -> tuple[float, float]:
    """Return the fitted orders in L2 and in H1, by the distance of neighboring centers."""
    errors = [model_error(kernel, count, form) for count in COUNTS[form]]
    gaps = [count - 1 for count in COUNTS[form]]
    l2, h1 = (fitted_order(gaps, [error[norm] for error in errors]) for norm in (0, 1))
    return l2, h1


def orders_table() -> Table:
    """Return the fitted orders of all kernels and both forms beside those expected."""
    rows = []
    for kernel in KERNELS:
        for form in FORMS:
            (l2, h1), (l2_expected, h1_expected) = (
                orders(kernel, form),
                expected_orders(kernel, form),
            )
            t = native_smoothness(kernel)
            rows.append(_Order(kernel.name, t, form, l2, l2_expected, h1, h1_expected))
    columns = (
        Column("kernel", "Kernel", "text"),
        Column("smoothness", "t", "count"),
        Column("form", "Form", "text"),
        Column("l2", "Order in L2", "number"),
        Column("l2_expected", "expected", "number"),
        Column("h1", "Order in H1", "number"),
        Column("h1_expected", "expected", "number"),
    )
    return Table.of(
        "future_orders",
        "Orders of convergence, centers inside",
        columns,
        rows,
        "The model -x'' - 2 x = f on even centers in [0, 1], support radius 2, calculated in 60 "
        "digits; t is the smoothness of the kernel's native space H^t. Half an order is lost at "
        "the ends of the interval, in both forms, and collocation loses another half in L2. "
        "For collocation the orders are those that experience shows; they are not proven here.",
    )


def model_errors_table() -> Table:
    """Return the errors from which the orders are fitted."""
    rows = [
        _Error(kernel.name, form, count, *model_error(kernel, count, form))
        for kernel in KERNELS
        for form in FORMS
        for count in COUNTS[form]
    ]
    columns = (
        Column("kernel", "Kernel", "text"),
        Column("form", "Form", "text"),
        Column("functions", "Functions", "count"),
        Column("l2", "Error in L2", "small"),
        Column("h1", "Error in H1", "small"),
    )
    return Table.of("future_model", "Errors on the linear model", columns, rows)
