"""`asemec completion`: the script that lets a shell complete our command line."""

from __future__ import annotations

import click


@click.command(
    short_help="Print the completion script for a shell.",
    help="Print the script that completes commands, options and file names in SHELL. For bash and zsh, add"
    " the line of the example to ~/.bashrc or ~/.zshrc. For fish, write the output to"
    " ~/.config/fish/completions/asemec.fish.",
    epilog='Example: eval "$(asemec completion bash)"',
)
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@click.pass_context
def command(context: click.Context, shell: str) -> int:
    """Print click's script for the shell."""
    from click.shell_completion import get_completion_class

    completion = get_completion_class(shell)
    assert completion is not None
    group = context.find_root().command
    # The scripts of click contain names, not code of the moment: nothing has to be started for them.
    click.echo(completion(group, {}, "asemec", "_ASEMEC_COMPLETE").source())
    return 0
