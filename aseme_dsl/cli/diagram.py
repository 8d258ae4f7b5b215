"""`asemec diagram`: drawings of a system's models."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from aseme_dsl.cli.progress import Progress
from aseme_dsl.cli.shared import (
    TARGET_HELP,
    FilePath,
    check_outputs,
    colour_option,
    diagnostics_json,
    json_option,
    one_system,
    print_diagnostics,
    print_json,
    print_written,
    target_argument,
)

OTHER_PICTURES = ("bmp", "eps", "gif", "jpeg", "jpg", "ps", "tif", "tiff", "webp")
"""Formats that one may expect, and that no folder is called after."""


@click.command(
    short_help="Draw the models of a system.",
    help="Draw all models of a system, or each MODEL: sag, iac.player, eac, 'srm.*'. A statechart has three"
    f" layouts: iac.player is compact, the others are iac.player.nested and iac.player.tree. {TARGET_HELP}",
    epilog="Example: asemec diagram team.aseme iac.player --at 0.2.5 --depth 2 -o player.svg",
)
@target_argument
@click.argument("models", nargs=-1, metavar="[MODEL]...")
@click.option(
    "-o",
    "--output",
    default="diagrams",
    show_default=True,
    type=FilePath(),
    help="Directory of the diagrams; for one diagram also a file, or - for standard output. A PDF file takes"
    " several diagrams, one a page.",
)
@click.option(
    "--format",
    "format_",
    type=click.Choice(["svg", "png", "pdf", "dot"]),
    help="Output format.  [default: by the suffix of the output file, else svg]",
)
@click.option(
    "--expressions",
    type=click.Choice(["numbered", "inline", "none"]),
    help="Transition expressions in the layouts nested and tree.  [default: the project's, else numbered]",
)
@click.option(
    "--at", metavar="STATE", help="Draw only the formula with this name, or the state with this label."
)
@click.option(
    "--depth",
    type=click.IntRange(min=1),
    help="Levels of nested states to draw; in the compact layout, of formulas.",
)
@click.option(
    "--layout",
    type=click.Choice(["compact", "nested", "tree"]),
    help="Layout of statecharts.  [default: compact]",
)
@click.option(
    "--page",
    type=click.Choice(["a4", "screen"]),
    help="In the compact layout: divide each chart into pages of this size.",
)
@click.option(
    "--labels",
    type=click.Choice(["plain", "original"]),
    help="State labels; original: as in the original ASEME tools.  [default: the project's, else plain]",
)
@click.option("--force", is_flag=True, help="Overwrite edited files and files that asemec did not write.")
@json_option
@colour_option
def command(
    target: str,
    models: tuple[str, ...],
    output: str,
    format_: str | None,
    expressions: str | None,
    at: str | None,
    depth: int | None,
    layout: str | None,
    page: str | None,
    labels: str | None,
    force: bool,
    as_json: bool,
    colour: str,
) -> int:
    """Draw and write; 1 if the file has errors or a drawing cannot be made or written."""
    from aseme_dsl.diagrams import FORMATS, DrawingFailed, Expressions, Layout, NoSuchState, Options, PageSize
    from aseme_dsl.diagrams.rendering.pdf import joined
    from aseme_dsl.project.building.build import with_labels
    from aseme_dsl.project.building.draw import (
        NoSuchDrawing,
        choose,
        draw_all,
        into_folder,
        larger_than_a_screen,
    )
    from aseme_dsl.project.files.outputs import marked
    from aseme_dsl.project.files.write import write_file

    if page is not None and (layout not in (None, "compact") or depth is not None):
        raise click.UsageError("--page is for the compact layout, without --depth.")
    compiled = one_system(target)
    if compiled.system is None:
        if as_json:
            print_json({"files": [], **diagnostics_json(compiled.diagnostics)})
        else:
            print_diagnostics(compiled.diagnostics, colour)
        return 1
    options = Options(
        Expressions(expressions or compiled.configuration.expressions or "numbered"),
        at,
        depth,
        Layout(layout or "compact"),
        PageSize(page) if page else None,
    )
    suffix = Path(output).suffix[1:]
    format_ = format_ or (suffix if suffix in FORMATS else "svg")
    if suffix in FORMATS and suffix != format_ and not Path(output).is_dir():
        raise click.UsageError(f"--format {format_} does not fit the suffix of {output}.")
    to_file = output == "-" or suffix == format_
    if suffix.lower() in OTHER_PICTURES and not Path(output).is_dir():
        raise click.UsageError(f"{output}: unsupported format; use svg, png, pdf or dot.")
    try:
        system = with_labels(compiled.system, labels or compiled.configuration.labels or "plain")
        chosen = choose(system, models, options)
        if expressions is not None and any(item.picture for item in chosen):
            raise click.UsageError("--expressions is for --layout nested and --layout tree: add one of them.")
        if to_file and (not chosen or (len(chosen) > 1 and format_ != "pdf")):
            names = ", ".join(item.name for item in chosen) or "none"
            raise click.UsageError(
                f"{output} is a file for one diagram, but {len(chosen)} are selected: {names}."
            )
        if to_file and output != "-" and not force:
            check_outputs([(Path(output), "drawing")], [target, *compiled.depends])
        progress = Progress()
        try:
            drawn = draw_all(
                chosen,
                format_,
                lambda number, of, name: progress.say(f"drawing {number} of {of}: {name}"),
            )
        finally:
            progress.end()
        if to_file and len(drawn.files) != len(chosen):
            raise click.ClickException(f"{'; '.join(drawn.notes)}: name a directory instead of {output}")
        content = joined(drawn.files) if to_file else b""
    except (NoSuchDrawing, NoSuchState) as problem:
        raise click.UsageError(f"{problem}.") from problem
    except DrawingFailed as problem:
        raise click.ClickException(str(problem)) from problem
    if output == "-":
        sys.stdout.buffer.write(content)
        return 0
    if to_file:
        written = write_file(Path(output), marked(content, f".{format_}", "diagram"))
    else:
        written = into_folder(compiled.system, Path(output), drawn, force=force)
    notes = (*drawn.notes, *(larger_than_a_screen(chosen) if page is None else ()))
    return print_written(written, notes, as_json, colour)
