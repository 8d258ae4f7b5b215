"""Stepper: takes a run from instant to instant; to go back, or to change something, it plays the run anew."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.project.building.project import Compiled
from aseme_dsl.project.stepping.running import Goal, Point, Run, Stage
from aseme_dsl.project.stepping.session import NotUnderstood, Session, understood
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.source import Source

SOON = 1_000_000
"""What is done now comes so many ns after the instant that is shown, in full milliseconds."""


class Stepper:
    """A run that is stepped through. `instant` is where it stands.

    The same seed gives the same run. So earlier instants are reached again from the beginning, and a change
    is one more statement of the scenario that is played.
    """

    def __init__(self, compiled: Compiled, stage: Stage, session: Session) -> None:
        """Raises NotUnderstood and NotPlayable."""
        self._compiled = compiled
        self._stage = stage
        self._memory = Memory()
        self._texts: dict[str, list[str]] = {}
        self.session = session
        self._given = len(session.statements)
        self._run = self._begun(session)
        self.instant = self._run.go(_first)

    def _begun(self, session: Session) -> Run:
        return Run(self._stage, understood(session, self._compiled, self._memory), session.seed)

    def step(self, count: int = 1) -> None:
        """Continue by so many instants in which something happens."""
        left = count

        def is_reached(point: Point) -> bool:
            nonlocal left
            left -= point.happens
            return left <= 0

        self.instant = self._run.go(is_reached)

    def to(self, moment: int) -> None:
        """Go to a moment (ns), after what happens then; backwards, too."""
        if moment < self.instant.picture.moment:
            self._again(self.session, lambda point: point.moment >= moment, moment)
        else:
            self.instant = self._run.go(lambda point: point.moment >= moment, moment)

    def go(self) -> None:
        """Continue to the next instant at which a condition occurs that halts, or to the end."""
        self.instant = self._run.go(lambda point: point.halts)

    def back(self, count: int = 1) -> None:
        """Go back by so many instants in which something happened."""
        events = max(self.instant.events - count + (not self.instant.happens), 0)
        self._again(self.session, lambda point: point.events >= events)

    def halt(self, condition: str) -> None:
        """Halt at a condition from now on. Raises NotUnderstood."""
        self._become(replace(self.session, halts=(*self.session.halts, condition)))

    def clear(self, place: int) -> None:
        """Do not halt at a condition any more."""
        halts = self.session.halts
        self._become(replace(self.session, halts=(*halts[:place], *halts[place + 1 :])))

    def do(self, statement: str) -> None:
        """Something happens just after this instant. Raises NotUnderstood."""
        moment = (self.instant.picture.moment // SOON + 1) * SOON
        self._become(self._with(f"at {moment // SOON}ms {statement}"))

    def undo(self) -> bool:
        """Take the last statement back that was done or added; whether there is one."""
        if not self.session.statements[self._given :]:
            return False
        moment = self.instant.picture.moment
        session = replace(self.session, statements=self.session.statements[:-1])
        self._again(session, lambda point: point.moment >= moment, moment)
        return True

    def add(self, statement: str) -> None:
        """One more statement, from the beginning on. Raises NotUnderstood."""
        moment = self.instant.picture.moment
        self._again(self._with(statement), lambda point: point.moment >= moment, moment)

    def _with(self, statement: str) -> Session:
        return replace(self.session, statements=(*self.session.statements, statement))

    def _become(self, session: Session) -> None:
        """The same instant in a session that differs only later."""
        events, moment = self.instant.events, self.instant.picture.moment
        self._again(session, lambda point: point.events >= events and point.moment >= moment, moment)
        self.instant = replace(self.instant, happened=())

    def _again(self, session: Session, goal: Goal, moment: int | None = None) -> None:
        """Play from the beginning; if that cannot be, all stays as it is."""
        run = self._begun(session)
        instant = run.go(goal, moment)
        self._run.close()
        self._run, self.session = run, session
        self.instant = replace(instant, happened=instant.last)

    @property
    def plans(self) -> Mapping[str, Plan]:
        """The plan of each agent."""
        charts = self._stage.loaded.charts
        return {agent.name: charts[agent.role].PLAN for agent in self.instant.picture.agents}

    def line_at(self, place: str) -> tuple[str, int, str]:
        """The file, the line and its text at a place of the model (`file:line:column`)."""
        path, line, _ = place.rsplit(":", 2)
        text, number = self.lines_of(path), int(line)
        return path, number, text[number - 1] if number <= len(text) else ""

    def lines_of(self, path: str) -> list[str]:
        """The lines of a file of the model; none if it cannot be read."""
        if path not in self._texts:
            self._texts[path] = _lines(self._compiled.root, path)
        return self._texts[path]

    def close(self) -> None:
        """End the run."""
        self._run.close()


def _first(point: Point) -> bool:
    return True


def _lines(root: Source | Path, path: str) -> list[str]:
    """The lines of a file whose path is that from the folder of the root."""
    if isinstance(root, Source):
        return root.text.splitlines()
    try:
        return outside.read_text(root.parent / path).splitlines()
    except (OSError, ValueError):
        return []


__all__ = ["NotUnderstood", "Stepper"]
