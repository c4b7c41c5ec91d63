"""The command `bodymeasure`, and how it ends."""

from __future__ import annotations

import os
import sys

import click

from bodymeasure.cli.check import check
from bodymeasure.cli.console import ERRORS
from bodymeasure.cli.diagonals import diagonals
from bodymeasure.cli.report import report
from bodymeasure.cli.samples import samples
from bodymeasure.cli.view import view
from bodymeasure.errors import BodymeasureError

EXIT_BAD_INPUT = 2
# As a shell reports a command that a signal ended: 128 + SIGINT, 128 + SIGPIPE.
EXIT_INTERRUPTED = 130
EXIT_BROKEN_PIPE = 141


@click.group(
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Exit codes: 0 done; 1 done, but with something to look at: the check found errors, or "
    "a length disagrees with the mesh; 2 bad input or usage, and nothing written; 130 interrupted.",
)
@click.version_option(package_name="bodymeasure")
def app() -> None:
    """Measure digital bodies along their surface, as a tape measure does.

    A body is an atlas of bicubic Bezier patches; lengths are geodesics on the smooth surface, each
    with an error estimate and a status, and are checked against libigl on triangle meshes.

    ATLAS is a file, or the name of a sample (`bodymeasure samples` lists them).
    """


for command in (report, diagonals, check, view, samples):
    app.add_command(command)


def main(arguments: list[str] | None = None) -> None:
    """Run the command line and exit with its code; errors of the user's go to stderr in words."""
    try:
        code = app.main(arguments, prog_name="bodymeasure", standalone_mode=False)
    except click.exceptions.NoArgsIsHelpError as help_page:
        help_page.show()
        code = EXIT_BAD_INPUT
    except click.ClickException as error:
        error.show()
        code = error.exit_code
    except BodymeasureError as error:
        ERRORS.print(f"[bold red]error:[/] {_plain(error)}", highlight=False, soft_wrap=True)
        code = EXIT_BAD_INPUT
    except (KeyboardInterrupt, click.Abort):
        ERRORS.print("interrupted; no file was written", highlight=False)
        code = EXIT_INTERRUPTED
    except BrokenPipeError:
        # Whoever read our output has gone; leave nothing for Python to flush into the void.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = EXIT_BROKEN_PIPE
    sys.exit(code or 0)


def _plain(error: BaseException) -> str:
    """A message's text with nothing in it that rich would take for markup."""
    return str(error).replace("[", r"\[")
