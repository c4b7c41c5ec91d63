"""The commands by name. None is imported before it is asked for, so that `--help` is quick."""

import importlib
from typing import NamedTuple

import click

EXIT_CODES = (
    "Exit codes: 0 done; 1 done, but with something to look at: the check found errors, a length "
    "disagrees with the mesh, a measurement could not be taken, or differences exceed what ISO "
    "20685-1 allows; 2 bad input or usage, and nothing written; 130 interrupted."
)


class Listed(NamedTuple):
    """A command: the module in this package that defines it under its name, and what it does."""

    module: str
    words: str


# In the order of the help, the main one first. A command is added by its module and one line.
COMMANDS = {
    "report": Listed("measuring.report", "Measure a body, check the lengths, write a report."),
    "chart": Listed("measuring.chart", "Chart the body measurements of a body."),
    "fit": Listed("fitting.fit", "Fit a body to a scan: a triangle mesh in, an atlas out."),
    "make": Listed("making.make", "Make a body from its measurements."),
    "compare": Listed(
        "measuring.compare", "Compare two bodies, or a chart with hand measurements."
    ),
    "survey": Listed("surveys.survey", "Take the charts of many bodies into one table."),
    "sizes": Listed("surveys.sizes", "Make a table of sizes from a survey."),
    "landmarks": Listed("landmarks.group", "List, add, remove and check landmarks."),
    "pattern": Listed("patterns.pattern", "Make the flat pieces of a garment from a body."),
    "diagonals": Listed("measuring.diagonals", "Print both diagonals of every patch."),
    "check": Listed("atlases.check", "List the faults of an atlas."),
    "info": Listed("atlases.info", "Describe an atlas."),
    "convert": Listed("atlases.convert", "Convert an atlas from one format to another."),
    "view": Listed("viewing.view", "Look at a body and measure it by clicking, in the browser."),
    "samples": Listed("atlases.samples", "List the atlases that come with bodymeasure."),
    "bench": Listed("study.bench", "Compare methods: error against time."),
    "paper": Listed("study.paper", "Reproduce the paper of 2007: its tables, beside the truth."),
    "docs": Listed("docs", "Print the documentation, or open it."),
}


class LazyGroup(click.Group):
    """The commands, each of which is imported when it is first asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        """Return the names of the commands, in the order of the help."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command:
        """Import a command; an unknown one ends the program with the name that is meant."""
        if cmd_name not in COMMANDS:
            from bodymeasure.wording import hint

            ctx.fail(f"No such command {cmd_name!r}; {hint(cmd_name, COMMANDS)}")
        module = importlib.import_module(f"bodymeasure.cli.{COMMANDS[cmd_name].module}")
        command: click.Command = getattr(module, cmd_name)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:  # noqa: ARG002
        """Write the list of commands, for which click itself would import all of them."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, listed.words) for name, listed in COMMANDS.items()])
