"""Session: what is played step by step, as the text of a scenario that grows with what the user does."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.compiler.phases import inspect_files, scenarios_of
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.diagnostics import Severity
from aseme_dsl.play.scenario import Scenario, Script
from aseme_dsl.project.building.project import Compiled, options_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.monitor.rules import Sometime
from aseme_dsl.source import Source

NAME = "asemec sim"
"""What the scenario is called that is added to the file."""
LATEST = "100000s"
LATEST_NS = 10**14
"""Until then a condition is awaited at which the run is to halt: later than any run ends."""


class NotUnderstood(Exception):
    """The statements are not a scenario; the text says why."""


@dataclass(frozen=True, slots=True)
class Session:
    """The statements of a scenario, the conditions at which it halts, and the file to which it is added."""

    source: Source
    statements: tuple[str, ...] = ()
    halts: tuple[str, ...] = ()
    seed: int = 1

    def scenario(self, title: str, halts: tuple[str, ...] = ()) -> str:
        """The statements as a scenario."""
        lines = (*self.statements, *(f"by {LATEST} {condition}" for condition in halts))
        return "\n".join((f'scenario "{title}" {{', *(f"  {line}" for line in lines), "}", ""))


@dataclass(frozen=True, slots=True)
class Understood:
    """A session as it is played: its script, and the number of the condition of each halt."""

    script: Script
    halts: tuple[int, ...]


def opened(compiled: Compiled, scenario: Scenario | None, seed: int) -> Session:
    """The session of a system without errors: of nothing, or of what a scenario says."""
    root = compiled.root
    if scenario is None:
        source = root if isinstance(root, Source) else Source(str(root), outside.read_text(root))
        return Session(source, seed=seed)
    whole = scenario.block.text if scenario.block is not None else "{}"
    body = whole[whole.index("{") + 1 : whole.rindex("}")]
    lines = tuple(line.strip() for line in body.splitlines() if line.strip())
    return Session(scenario.span.source, lines, seed=seed)


def understood(session: Session, compiled: Compiled, memory: Memory) -> Understood:
    """What is played.

    Raises:
        NotUnderstood: a statement or a condition is wrong, or cannot be played.
    """
    text = f"{session.source.text}\n{session.scenario(NAME, session.halts)}"
    is_file = isinstance(compiled.root, Path)
    inspection = inspect_files(
        compiled.root if is_file else Source(session.source.path, text),
        {session.source.path: text} if is_file else None,
        options_of(compiled.configuration),
        memory,
    )
    found = tuple(item for item in inspection.analysis.diagnostics if item.severity is Severity.ERROR)
    if found:
        hint = f" ({found[0].hint})" if found[0].hint else ""
        raise NotUnderstood(f"{found[0].message}{hint}")
    scenario = next(item for item in scenarios_of(inspection, {}) if item.name == NAME)
    if scenario.refused is not None:
        raise NotUnderstood(f"this is not played: {scenario.refused.reason}")
    script = scenario.scripts[0]
    halts = {
        place: item.rule.condition
        for place, item in enumerate(script.expectations)
        if isinstance(item.rule, Sometime) and item.rule.until == LATEST_NS
    }
    kept = tuple(item for place, item in enumerate(script.expectations) if place not in halts)
    return Understood(replace(script, expectations=kept), tuple(halts.values()))


def saved_text(session: Session, path: Path) -> str:
    """A file with the scenario of a session, which imports the file that it is about."""
    about = os.path.relpath(session.source.path, path.parent)
    title = path.stem.replace("-", " ").replace("_", " ")
    return f'import "{Path(about).as_posix()}"\n\n{session.scenario(title)}'


__all__ = ["NotUnderstood", "Session", "Understood", "opened", "saved_text", "understood"]
