"""`bodymeasure landmarks`."""

import click

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.landmarks.check import check_landmarks
from bodymeasure.cli.landmarks.edit import add, remove
from bodymeasure.cli.landmarks.list import list_landmarks

DEFAULT = "list"


class _ListsByDefault(click.Group):
    """A group that lists the landmarks if no command is given."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        if not args or (args[0] not in self.commands and args[0] not in ctx.help_option_names):
            args = [DEFAULT, *args]
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002
        return list(self.commands)


@click.group(
    cls=_ListsByDefault,
    short_help="List, add, remove and check landmarks.",
    subcommand_metavar="[COMMAND] ATLAS [ARGS]...",
    epilog=EXIT_CODES,
)
def landmarks() -> None:
    """List, add, remove and check the landmarks of ATLAS, by whose names measurements are defined.

    \b
    For example:
      bodymeasure landmarks body.atlas
      bodymeasure landmarks add body.atlas "bust point left" --at 9.1 -16.0 116.4 --position-unit cm -o new.atlas
      bodymeasure landmarks add body.atlas "wrist point left" --mesh body.obj --vertex 4711 --position-unit m --in-place
      bodymeasure landmarks check body.atlas
    """  # noqa: D301, E501  (click needs the character itself, and lines as they are typed)


for command in (list_landmarks, add, remove, check_landmarks):
    landmarks.add_command(command)
