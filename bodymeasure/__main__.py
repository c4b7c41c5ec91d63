"""`python -m bodymeasure`, and the command `bodymeasure`."""

import gc
import sys

# The exit code of a command that SIGINT ended, as shells have it: 128 + 2.
EXIT_INTERRUPTED = 130
# The number of new objects after which Python looks for cycles among them: its own 700 is reached
# again and again while modules are imported, where nothing is garbage.
NEW_OBJECTS = 50_000


def main() -> None:
    """Run the command line, which takes some tenths of a second to import."""
    gc.set_threshold(NEW_OBJECTS, *gc.get_threshold()[1:])
    try:
        from bodymeasure.cli import main as run
    except KeyboardInterrupt:
        sys.stderr.write("Interrupted; no half-written file is left.\n")
        sys.exit(EXIT_INTERRUPTED)
    run()


if __name__ == "__main__":
    main()
