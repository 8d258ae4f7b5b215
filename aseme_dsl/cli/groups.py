"""Groups of commands that load each command only when it is asked for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module

import click

from aseme_dsl.runtime.message.naming import usable


class LazyGroup(click.Group):
    """Commands that are modules of a package; each is the object `command` of the module of its name."""

    package = ""
    names: Sequence[str] = ()
    """The commands in the order of the help; a module has an underscore where that is a keyword."""
    moved: Mapping[str, str] = {}
    """Commands that have another name now, and that name: nothing is done under the old one."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.names)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in self.names:
            return None
        command = import_module(f"{self.package}.{usable(cmd_name)}").command
        assert isinstance(command, click.Command)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] not in self.names and not args[0].startswith("-"):
            from aseme_dsl.diagnostics import closest

            if args[0] in self.moved:
                raise click.UsageError(f"`asemec {args[0]}` is `asemec {self.moved[args[0]]}` now.", ctx)
            near = closest(args[0], self.names)
            hint = f"Did you mean {near!r}?" if near else f"Commands: {', '.join(self.names)}."
            raise click.UsageError(f"Unknown command {args[0]!r}. {hint}", ctx)
        return super().resolve_command(ctx, args)


__all__ = ["LazyGroup"]
