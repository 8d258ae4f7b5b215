"""Telling: what is shown on a terminal while a team plays."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from typing import IO, TYPE_CHECKING

import click

from aseme_dsl.cli.progress import shows_progress
from aseme_dsl.cli.shared import plural
from aseme_dsl.cli.terminal import harmless
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD
from aseme_dsl.runtime.trace.state_names import apart, titles_of

if TYPE_CHECKING:
    from aseme_dsl.runtime.chart.plan import Plan
    from aseme_dsl.runtime.trace.records import Record
    from aseme_dsl.runtime.version.loading import Loaded

_STATUS_SECONDS = 0.1
"""How often the time is renewed on a terminal."""
_QUIET_AFTER = 20
"""So many different faults are shown; of the others there is only the number."""
_SAME = 3
"""So many passed deadlines of an activity are shown; then there is only their number."""


class Telling:
    """Prints lines during a run, from its trace and from the output of the project.

    `alone` is the plan that plays instead of the team, if one does. The other parameters turn lines on:

    - `activities`: when an agent starts another activity than before in a region (or the same one behind a
      state that was left at once), and what activities log;
    - `transitions`: every transition and every start;
    - `progress`: the project's own lines, and on a terminal the time.

    Faults, failures and passed deadlines are always shown, on standard error. A line that several agents have
    in common is shown for the first. At the end stands the number of agent messages that no agent took.
    """

    def __init__(
        self,
        loaded: Loaded,
        *,
        alone: str | None = None,
        activities: bool,
        transitions: bool,
        progress: bool,
        colour: bool,
        stream: IO[str],
    ) -> None:
        self._alone = alone
        self._activities = activities
        self._transitions = transitions
        self._progress = progress
        self._colour = colour
        self._stream = stream
        self._roles = dict(loaded.team)
        self._plans = {plan.name: plan for plan in loaded.plans}
        self._width = max(map(len, self._roles or self._plans), default=1)
        self._doing: dict[tuple[str, str], str] = {}
        self._names: dict[str, dict[str, str]] = {}
        """What people call the states of each plan, by its hash."""
        self._faults: Counter[tuple[str, str]] = Counter()
        self._late: Counter[tuple[str, str, str]] = Counter()
        """How many deadlines have passed: by agent, activity and its place."""
        self.untaken = 0
        """How many agent messages were there for a participant that left without having taken them."""
        self.unexpected = 0
        """How many agent messages no agent expected."""
        self._followed: dict[str, Plan] = {}
        """The plans of agents that have changed to another one."""
        self._shown_at = 0.0
        self._status = False

    def line(self, text: str) -> None:
        """A line that the project tells."""
        if self._progress:
            self._print(text)

    def tick(self, moment: int) -> None:
        """It is `moment`: shown at the bottom of a terminal, if enough has passed since the last time."""
        if not self._progress or not shows_progress(self._stream):
            return
        now = time.monotonic()
        if now - self._shown_at >= _STATUS_SECONDS:
            self._shown_at = now
            self._status = True
            self._stream.write(f"\r\x1b[K{_time(moment)}")
            self._stream.flush()

    def wants(self, kind: str, what: str | None) -> bool:
        """Whether there may be something to show in such a line of the trace."""
        if kind == "activity":
            return what in ("crash", "cancel") or (what == "start" and self._activities)
        if kind == "module":
            return what == "crash"
        if kind == "step":
            return self._transitions
        if kind == "conversation":
            return what == "leave"
        if kind in ("fault", "error", "swap", "select", "unexpected"):
            return True
        return kind == "log" and self._activities

    def __call__(self, record: Record) -> None:
        """A line of the trace."""
        kind = record["kind"]
        if kind == "activity":
            if record["what"] == "crash":
                self._crashed(record)
            elif record["what"] == "cancel":
                if "reason" in record:  # its deadline has passed
                    self._passed(record)
                if record.get("started") is False:
                    self._passed_through(record)
            elif self._activities and record["what"] == "start":
                self._started(record)
        elif kind == "module":
            if record["what"] == "crash":
                self._crashed(record)
        elif kind == "log":
            if self._activities:
                self._say(record, f"{record['activity']}: {record['text']}")
        elif kind == "step":
            if self._transitions:
                for taken in record.get("taken", ()):
                    self._took(record, taken["transitions"])
        elif kind == "conversation":
            if record["what"] == "leave":  # its own report lost agents
                self.untaken += sum(sender != record["agent"] for sender, _ in record.get("untaken", ()))
        elif kind == "unexpected":
            self.unexpected += record["performative"] != NOT_UNDERSTOOD  # which only answers another one
        elif kind in ("swap", "select"):
            self._changed(record)
        elif kind in ("fault", "error"):
            self._wrong(record, "fault" if kind == "fault" else "failure", record["reason"], record.get("at"))

    def end(self) -> None:
        """Take the time away, and say how much there was that was not shown."""
        self._clear()
        again = self.faults - min(len(self._faults), _QUIET_AFTER)
        if again > 0:
            click.echo(f"... and {plural(again, 'fault')} more, see the trace", err=True)
        for (agent, activity, at), times in self._late.items():
            if times > _SAME:
                late = plural(times, "missed deadline")
                click.echo(f"... {late} of {activity} of {agent}{_place(at)}, see the trace", err=True)
        counts = ((self.untaken, "not consumed"), (self.unexpected, "unexpected"))
        if lost := [f"{plural(count, 'agent message')} {what}" for count, what in counts if count]:
            click.echo(f"... {', '.join(lost)}; for details: asemec sniff", err=True)

    @property
    def faults(self) -> int:
        """How many faults there were."""
        return sum(self._faults.values())

    def _started(self, record: Record) -> None:
        region = self._region(record["agent"], record["label"])
        activity = record["activity"]
        agent = record["agent"]
        for other in [other for name, other in self._doing if name == agent]:
            if _is_inside(region, other) or _is_inside(other, region):
                del self._doing[agent, other]  # it was left for this one
        if self._transitions or self._doing.get((agent, region)) != activity:
            self._doing[agent, region] = activity
            self._say(record, activity)

    def _passed_through(self, record: Record) -> None:
        """A state was left in the step that entered it: behind it, the last activity is shown again."""
        place = record["agent"], self._region(record["agent"], record["label"])
        if self._doing.get(place) != record["activity"]:
            self._doing[place] = ""

    def _changed(self, record: Record) -> None:
        """An agent follows another plan or another version of its own, or was refused that."""
        from aseme_dsl.runtime.chart.plan import plans

        what = record["plan"] if record["kind"] == "select" else "the new version"
        reasons = record.get("reasons") or ([record["reason"]] if "reason" in record else [])
        if reasons:
            about: Record = {"agent": ", ".join(map(str, record.get("agents", ()))), **record}
            for reason in reasons:
                self._wrong(about, "fault", f"switch to {what} refused: {reason}", None)
            return
        found = next((plan for plan in plans() if plan.model == record["model"]), None)
        if found is not None:
            self._followed[record["agent"]] = found
        if self._progress:
            self._say(record, f"swapped to {what}" if record["kind"] == "swap" else f"switched to {what}")

    def _took(self, record: Record, numbers: Sequence[int]) -> None:
        """A transition, or the parts of a compound one."""
        plan = self._plan(record["agent"])
        parts = [plan.transitions[number] for number in numbers]
        labels = (parts[0].source, parts[-1].target) if parts[0].kind == "external" else (parts[0].source,)
        names = self._names.get(plan.model)
        if names is None:
            names = self._names[plan.model] = apart(titles_of(plan))
        ends = [names[label] for label in labels]
        text = " ; ".join(part.text for part in parts if part.text)
        self._say(record, f"{' -> '.join(ends)}  {text}".rstrip())

    def _plan(self, agent: str) -> Plan:
        """The plan of an agent; one that plays alone may be called anything."""
        if agent in self._followed:
            return self._followed[agent]
        role = self._alone or self._roles.get(agent, agent)
        return self._plans.get(role) or next(iter(self._plans.values()))

    def _region(self, agent: str, label: str) -> str:
        """The innermost region around a state, of the agent's plan."""
        regions = {region.label for region in self._plan(agent).regions}
        while label and label not in regions:
            label = label.rpartition(".")[0]
        return label

    def _passed(self, record: Record) -> None:
        """An activity was not done in time: told the first times, and counted."""
        state = self._plan(record["agent"]).by_label.get(record["label"])
        key = (record["agent"], record["activity"], state.at if state is not None else "")
        self._late[key] += 1
        if self._late[key] <= _SAME:
            self._warn(record, "deadline", f"{record['activity']} is {record['reason']}", key[2])

    def _crashed(self, record: Record) -> None:
        """An activity raised: where in its code, innermost."""
        frames = record.get("traceback")
        place = f"{frames[-1]['file']}:{frames[-1]['line']}" if frames else None
        name = record.get("activity") or record["module"]
        self._wrong(record, "crash", f"{name}: {record['reason']}", place)

    def _wrong(self, record: Record, what: str, reason: str, at: str | None) -> None:
        key = (reason, at or "")
        self._faults[key] += 1
        if self._faults[key] == 1 and len(self._faults) <= _QUIET_AFTER:
            self._warn(record, what, reason, at)

    def _warn(self, record: Record, what: str, reason: str, at: str | None) -> None:
        self._clear()
        place = _place(at)
        mild = what in ("fault", "deadline")
        painted = click.style(what, fg="yellow" if mild else "red") if self._colour else what
        text = f"{_time(record['time'])}  {record['agent']}  {painted}: {harmless(reason)}{place}"
        click.echo(text, err=True, color=True)

    def _say(self, record: Record, text: str) -> None:
        self._print(f"{_time(record['time'])}  {record['agent']:<{self._width}}  {harmless(text)}")

    def _print(self, text: str) -> None:
        self._clear()
        click.echo(text, file=self._stream)

    def _clear(self) -> None:
        if self._status:
            self._status = False
            self._stream.write("\r\x1b[K")


def _is_inside(inner: str, outer: str) -> bool:
    """Whether a region is in a state of another one, so that they are never active side by side."""
    return inner != outer and (not outer or inner.startswith(outer + "."))


def _place(at: str | None) -> str:
    return f" ({at})" if at else ""


def _time(moment: int) -> str:
    return f"{moment / 1e9:8.2f} s"
