"""The command `bodymeasure`, and how it ends."""

import errno
import importlib.metadata
import io
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import click

from bodymeasure.cli.atlases.check import check
from bodymeasure.cli.atlases.convert import convert
from bodymeasure.cli.atlases.info import info
from bodymeasure.cli.atlases.samples import samples
from bodymeasure.cli.console import print_error, print_note
from bodymeasure.cli.docs import docs
from bodymeasure.cli.landmarks.group import landmarks
from bodymeasure.cli.measuring.chart import chart
from bodymeasure.cli.measuring.compare import compare
from bodymeasure.cli.measuring.diagonals import diagonals
from bodymeasure.cli.measuring.report import report
from bodymeasure.cli.measuring.view import view
from bodymeasure.cli.options import EXIT_CODES
from bodymeasure.cli.study.bench import bench
from bodymeasure.cli.study.paper import paper
from bodymeasure.errors import BodymeasureError

EXIT_BAD_INPUT = 2
# As a shell reports a command that a signal ended: 128 + SIGINT, 128 + SIGPIPE.
EXIT_INTERRUPTED = 130
EXIT_BROKEN_PIPE = 141


# What writing to a stream fails with; anything else is no fault of the stream's.
STREAM_ERRORS = (errno.EPIPE, errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)


class _OutputError(Exception):
    """Stdout could not be written; told apart from what the command line library would do then."""

    def __init__(self, cause: OSError) -> None:
        super().__init__(cause.strerror or str(cause))
        self.is_closed_pipe = isinstance(cause, BrokenPipeError)


@contextmanager
def _output_errors() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        # Files have names, and errors of their own.
        if error.filename is not None or error.errno not in STREAM_ERRORS:
            raise
        raise _OutputError(error) from error


class _Commands(click.Group):
    """Lists the commands in the order in which they are added: the main one first."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        return list(self.commands)

    def make_context(self, *args: Any, **kwargs: Any) -> click.Context:
        with _output_errors():
            return super().make_context(*args, **kwargs)

    def invoke(self, ctx: click.Context) -> Any:
        with _output_errors():
            code = super().invoke(ctx)
            # Here, not when Python ends and can only complain.
            if sys.stdout is not None:
                sys.stdout.flush()
            return code


def _print_version(ctx: click.Context, _parameter: click.Parameter, wanted: bool) -> None:
    if not wanted or ctx.resilient_parsing:
        return
    try:
        version = importlib.metadata.version("bodymeasure")
    except importlib.metadata.PackageNotFoundError:
        version = "(a bare checkout, not installed)"
    click.echo(f"bodymeasure {version}")
    ctx.exit()


@click.group(
    cls=_Commands,
    invoke_without_command=True,
    subcommand_metavar="COMMAND [ARGS]...",
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog=EXIT_CODES,
)
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_version,
    help="Show the version and exit.",
)
@click.pass_context
def app(ctx: click.Context) -> int | None:
    """Measure digital bodies along their surface, as a tape measure does.

    A body is an atlas of bicubic Bezier patches; lengths are geodesics on the smooth surface, each
    with an error estimate and a status, and are checked against libigl on triangle meshes.

    ATLAS is a file, or the name of a sample (`bodymeasure samples` lists them).

    \b
    To begin:
      bodymeasure report                    measure the average female sample
      bodymeasure chart                     its girths, lengths and heights
      bodymeasure report body.atlas -o out  measure a body of yours
    """  # noqa: D301  (click wants the character itself)
    if ctx.invoked_subcommand is not None:
        return None
    click.echo(ctx.get_help(), err=True)
    return EXIT_BAD_INPUT


COMMANDS = (
    report,
    chart,
    compare,
    landmarks,
    diagonals,
    check,
    info,
    convert,
    view,
    samples,
    bench,
    paper,
    docs,
)
for command in COMMANDS:
    app.add_command(command)


def main(arguments: list[str] | None = None) -> None:
    """Run the command line and exit with its code; errors of the user's go to stderr in words."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A name that the terminal's encoding has no characters for is no reason to stop.
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        code = app.main(arguments, prog_name="bodymeasure", standalone_mode=False)
    except click.ClickException as error:
        error.show()
        code = error.exit_code
    except BodymeasureError as error:
        print_error(str(error))
        code = EXIT_BAD_INPUT
    except (KeyboardInterrupt, click.Abort):
        # Whoever presses the keys twice does not want to see how Python ends.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        print_note("Interrupted; no half-written file is left.", style="")
        code = EXIT_INTERRUPTED
    except _OutputError as error:
        if not error.is_closed_pipe:
            print_error(f"the output cannot be written ({error})")
        _discard_output()
        code = EXIT_BROKEN_PIPE if error.is_closed_pipe else EXIT_BAD_INPUT
    sys.exit(code or 0)


def _discard_output() -> None:
    """Leave nothing for Python to flush into a closed pipe or onto a full disk."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError):
        return
