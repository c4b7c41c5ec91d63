"""The command `bodymeasure`, and how it ends."""

import errno
import io
import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Literal

import click

from bodymeasure.cli.commands import EXIT_CODES, LazyGroup
from bodymeasure.errors import BodymeasureError

EXIT_BAD_INPUT = 2
# The exit codes of a command that a signal ended, as shells have them: 128 + SIGINT, SIGPIPE or
# SIGTERM.
EXIT_INTERRUPTED = 130
EXIT_BROKEN_PIPE = 141
EXIT_TERMINATED = 143

# The errors of writing to a stream; any other has nothing to do with the stream.
STREAM_ERRORS = (errno.EPIPE, errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)


class _OutputError(Exception):
    """Stdout could not be written. Click would handle an `OSError` in its own way."""

    def __init__(self, cause: OSError) -> None:
        super().__init__(cause.strerror or str(cause))
        self.is_closed_pipe = isinstance(cause, BrokenPipeError)


class _TerminatedError(BaseException):
    """The process was asked to end. No handler of exceptions takes it for a failure."""


@contextmanager
def _ended_in_order() -> Iterator[None]:
    """Let SIGTERM end this process as an interrupt does, so that nothing half-written is left."""
    if threading.current_thread() is not threading.main_thread():
        # Only the main thread may say what a signal does; programs that run this in another do.
        yield
        return
    process = os.getpid()

    def end(number: int, _frame: object) -> None:
        if os.getpid() == process:
            raise _TerminatedError
        # A worker, which has inherited this, ends at once.
        signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)

    before = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


@contextmanager
def _output_errors() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        # An error with the name of a file is about that file, not about the stream.
        if error.filename is not None or error.errno not in STREAM_ERRORS:
            raise
        raise _OutputError(error) from error


class _Commands(LazyGroup):
    """The commands; what goes wrong with the output is not their fault."""

    def make_context(self, *args: Any, **kwargs: Any) -> click.Context:
        with _output_errors():
            return super().make_context(*args, **kwargs)

    def invoke(self, ctx: click.Context) -> Any:
        with _output_errors():
            code = super().invoke(ctx)
            # A failure is handled here; when Python exits, it could only be reported.
            if sys.stdout is not None:
                sys.stdout.flush()
            return code


def _print_version(ctx: click.Context, _parameter: click.Parameter, wanted: bool) -> None:
    if not wanted or ctx.resilient_parsing:
        return
    import importlib.metadata  # A slow import, which nothing else needs.

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


def main(arguments: list[str] | None = None) -> None:
    """Run the command line and exit with its code; errors of input are printed to stderr."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A name whose characters the terminal's encoding lacks is no reason to stop.
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        with _ended_in_order():
            code = app.main(arguments, prog_name="bodymeasure", standalone_mode=False)
    except click.ClickException as error:
        error.show()
        code = error.exit_code
    except BodymeasureError as error:
        _say("error", str(error))
        code = EXIT_BAD_INPUT
    except (KeyboardInterrupt, click.Abort):
        # A second interrupt must not show a traceback while Python exits.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        _say("note", "Interrupted; no half-written file is left.")
        code = EXIT_INTERRUPTED
    except _TerminatedError:
        _say("note", "Terminated; no half-written file is left.")
        code = EXIT_TERMINATED
    except _OutputError as error:
        if not error.is_closed_pipe:
            _say("error", f"the output cannot be written ({error})")
        _discard_output()
        code = EXIT_BROKEN_PIPE if error.is_closed_pipe else EXIT_BAD_INPUT
    sys.exit(code or 0)


def _say(kind: Literal["error", "note"], text: str) -> None:
    """Print to stderr."""
    from bodymeasure.cli.console import print_error, print_note  # Slow imports.

    if kind == "error":
        print_error(text)
    else:
        print_note(text, style="")


def _discard_output() -> None:
    """Leave nothing for Python to flush into a closed pipe or onto a full disk."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (OSError, ValueError):
        return
