"""`bodymeasure samples`."""

import click
from rich.table import Table
from rich.text import Text

from bodymeasure.cli.console import print_table
from bodymeasure.samples import samples as all_samples


@click.command(short_help="List the atlases that come with bodymeasure.")
@click.option("--paths", is_flag=True, help="Print only the files, one a line.")
def samples(paths: bool) -> None:
    """List the atlases that come with bodymeasure.

    Every command takes such a name in place of a file.
    """
    if paths:
        for sample in all_samples():
            click.echo(sample.path)
        return
    table = Table(box=None, pad_edge=False)
    table.add_column("name", style="bold", no_wrap=True)
    table.add_column("what it is", overflow="fold")
    for sample in all_samples():
        table.add_row(sample.name, Text(sample.description))
    print_table(table)
