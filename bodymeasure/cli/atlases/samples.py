"""`bodymeasure samples`."""

import click
from rich.text import Text

from bodymeasure.cli.console import print_table
from bodymeasure.cli.tables import new_table
from bodymeasure.samples import samples as all_samples


@click.command()
@click.option("--paths", is_flag=True, help="Print only the paths of the files, one on each line.")
def samples(paths: bool) -> None:
    """List the atlases that come with bodymeasure.

    Every command accepts such a name in place of a file.
    """
    if paths:
        for sample in all_samples():
            click.echo(sample.path)
        return
    table = new_table("name", "what it is", words=("what it is",))
    table.columns[0].no_wrap = True
    for sample in all_samples():
        table.add_row(Text(sample.name, "bold"), Text(sample.description))
    print_table(table)
