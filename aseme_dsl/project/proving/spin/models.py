"""Models: the team and the protocols of a system for SPIN, with what is to hold of them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from aseme_dsl import outside
from aseme_dsl.compiler.phases import watched_of
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.exporting import NotInModel
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import Compiled, compile_root
from aseme_dsl.project.playing.operate import generate_version
from aseme_dsl.project.proving.prove import of_scope
from aseme_dsl.project.proving.scopes import Scope, scopes_of
from aseme_dsl.project.proving.spin.promela import NotSaid, promela
from aseme_dsl.project.proving.written import loaded_with_writes
from aseme_dsl.source import Source, Span

File = tuple[str, str]


def models_of(compiled: Compiled, names: Sequence[str]) -> tuple[tuple[File, ...], tuple[Diagnostic, ...]]:
    """A file for the team and for each protocol alone, or for those of these names, and what cannot be said.

    Raises:
        LookupError: there is no team or protocol of a name; the text lists what there is.
        OperateError, LoadError: the code of the system cannot be made.
    """
    assert compiled.system is not None
    scopes = {scope.protocol or "team": scope for scope in scopes_of(compiled.root, compiled.system, 1)}
    missing = next((name for name in names if name not in scopes), None)
    if missing is not None:
        raise LookupError(f"there is no protocol {missing}; there are {', '.join(scopes) or 'none'}")
    files: list[File] = []
    found: list[Diagnostic] = []
    for name in names or scopes:
        try:
            files.append((f"{name}.pml", _model(scopes[name], compiled)))
        except NotSaid as problem:
            own = next((aip.span for aip in compiled.system.aips if aip.name == name), None)
            span = _span(problem.at, compiled.root) or own
            found.append(Diagnostic(NotInModel(scopes[name].what, problem.what), span))
    return (() if found else tuple(files)), tuple(found)


def _model(scope: Scope, compiled: Compiled) -> str:
    own = compiled if scope.protocol is None else compile_root(scope.root)
    if own.system is None:
        raise NotSaid("a participant that cannot be played alone", "")
    (watched,) = watched_of(own.inspection, dict(scope.team)).scripts
    script = of_scope(watched, scope)
    with TemporaryDirectory(prefix="asemec-export-") as folder:
        package, _ = generate_version(own.system, Path(folder), choose(own.configuration))
        loaded = loaded_with_writes(package, own.system, compiled.configuration)
        plans = {role: loaded.charts[role].PLAN for _, role in scope.team}
    named = [(f"p{number}", item) for number, item in enumerate(script.expectations, 1)]
    text = promela(scope.what, scope.team, plans, script.conditions, named)
    if scope.protocol is None:
        for agent in (agent for team in own.system.teams for agent in team.agents):
            if agent.name not in dict(scope.team):
                raise NotSaid(f"a second agent of the role {agent.role}", str(agent.span))
        for item in watched.silent:
            raise NotSaid(f"the property {item.name}: {item.reason}", str(item.span))
    return text


def _span(at: str, root: Path | Source) -> Span | None:
    """A place `file:line:column` in the source of the system."""
    source = root if isinstance(root, Source) else Source(str(root), outside.read_text(root))
    place = re.fullmatch(r"(.*):([0-9]+):([0-9]+)", at)
    lines = source.text.split("\n")
    if place is None or Path(place[1]).name != Path(source.path).name or int(place[2]) > len(lines):
        return None
    start = sum(len(line) + 1 for line in lines[: int(place[2]) - 1]) + int(place[3]) - 1
    return Span(source, start, min(start + 1, len(source.text)))


__all__ = ["models_of"]
