"""`python -m bodymeasure`, and the command `bodymeasure`."""

import sys

# The exit code of a command that SIGINT ended, as shells have it: 128 + 2.
EXIT_INTERRUPTED = 130


def main() -> None:
    """Run the command line, which takes some tenths of a second to import."""
    try:
        from bodymeasure.cli import main as run
    except KeyboardInterrupt:
        sys.stderr.write("Interrupted; no half-written file is left.\n")
        sys.exit(EXIT_INTERRUPTED)
    run()


if __name__ == "__main__":
    main()
