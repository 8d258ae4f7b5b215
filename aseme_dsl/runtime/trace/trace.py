"""Traces: what happened in a run, as JSON lines that later tools can rely on.

The format is `schemas/trace.schema.json`. Every input has an identity (agent, sequence) in the line that
tells how it came to be; the line of the step that took it cites it. Under the virtual clock the same seed
gives the same bytes.

In real time a thread of its own writes them, so that no step waits for a disk. If the disk is so slow that
`trace_files.MOST_LINES` wait for it, further lines are dropped until half of them are written. A line `gap`
stands in their place, and has their number.
"""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable, Iterable, Mapping
from datetime import datetime
from functools import cache
from pathlib import Path

from aseme_dsl.runtime.chart.inputs import (
    Cancel,
    Fault,
    FunctionResult,
    Identity,
    MailTaken,
    Outcome,
    Sample,
    Start,
)
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.chart.saving import Saved
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.message.wire import Schema
from aseme_dsl.runtime.trace import checkpoint
from aseme_dsl.runtime.trace.checkpoint import state_of
from aseme_dsl.runtime.trace.fault_counts import FaultCounts
from aseme_dsl.runtime.trace.packed import packed
from aseme_dsl.runtime.trace.records import Record, Taken, as_record
from aseme_dsl.runtime.trace.state_names import titles_of
from aseme_dsl.runtime.trace.trace_files import (
    FORMAT,
    GZIP_SUFFIX,
    MCAP_SUFFIX,
    Background,
    Direct,
    Format,
    JsonLines,
    Output,
    part_of,
    reason_of,
)

Listener = Callable[[Record], None]
"""Is shown the lines: all, or if it has a method `wants(kind, what)` those of which that says so. It is asked
once for each kind and `what`, which is None where such a line has none."""

_encode = json.JSONEncoder(ensure_ascii=False, separators=(",", ":"), allow_nan=False).encode
_text = cache(_encode)
_NUMBERS = frozenset({"sequence"})
"""Members of the line of an activity that are always whole numbers."""
_TOO_SLOW = "the disk is slower than the run"
_MOST_REMARKS = 1000
"""After so many different ones it is forgotten which were told: some texts are different for ever."""


class Trace:
    """Writes the lines of a run, and shows each to those who listen. May be used from any thread.

    A trace that cannot be written any more ends with `error`; the run continues.
    """

    def __init__(
        self, path: Path | None = None, listeners: Iterable[Listener] = (), *, background: bool = False
    ) -> None:
        """`background`: a thread writes the file, as real time needs it.

        Raises:
            OSError: there cannot be a file at `path`.
            TraceError: a file of that kind needs a package that is not installed.
        """
        self.path = path
        self.error: str | None = None
        self.now: Callable[[], int] = _no_time
        """The time of the run, for what the trace has to say itself."""
        self._listeners = tuple(listeners)
        self._listening: dict[tuple[str, object], tuple[Listener, ...]] = {}
        self._ways: dict[tuple[str, str, tuple[int, ...]], str] = {}
        self._remarks: set[str] = set()
        self.faults = FaultCounts()
        """The faults so far; counted also where the trace has no reader."""
        self._lock = threading.Lock()
        self._output: Output | None = None
        self._dropped = 0
        self._has_gaps = False
        self.agents: list[Callable[[], None]] = []
        """What writes a checkpoint of each agent, or has it written at once."""
        self._since = 0
        """How many characters were written since the last checkpoints began."""
        self._checkpoints = 0
        """How many characters these have."""
        if path is not None:
            self._part = part_of(path)
            file = format_for(path, self._part)
            self._output = Background(file, self._give_up) if background else Direct(file)
        self.begun = False
        """Whether the header has been written, before which there is no other line."""
        self.active = self._output is not None or bool(self._listeners)
        """Whether the trace has a reader: to be asked before a costly line is made."""

    def write(self, kind: str, moment: int, **members: object) -> None:
        """Write a line. Members that are None or empty tuples are left out."""
        listening = self._who_wants(kind, members.get("what"))
        if self._output is None and not listening:
            return
        line: dict[str, object] = {"kind": kind, "time": moment}
        for name, value in members.items():
            if value is not None and value != ():
                line[name] = value
        with self._lock:
            for listener in listening:
                listener(as_record(line))
            self._put(_encode(line) if self._output is not None else "", last=kind == "finish")

    def _who_wants(self, kind: str, what: object = None) -> tuple[Listener, ...]:
        """The listeners that are shown such a line."""
        found = self._listening.get((kind, what))
        if found is None:
            found = tuple(item for item in self._listeners if getattr(item, "wants", _always)(kind, what))
            self._listening[kind, what] = found
        return found

    def _is_only_written(self, kind: str, what: str | None = None) -> bool:
        """Whether such a line goes nowhere but into the file: then it may be put together by hand."""
        return self._output is not None and not self._who_wants(kind, what)

    def _put_line(self, line: str) -> None:
        with self._lock:
            self._put(line)

    def _put(self, line: str, last: bool = False) -> None:
        output = self._output
        if output is None:
            return
        has_room = last or output.has_room(self._dropped > 0)
        if not has_room:
            self._dropped += 1
            if not self._has_gaps:
                self._has_gaps = True
                self._tell(f"the trace has gaps: {_TOO_SLOW}")
            return
        try:
            if self._dropped:
                gap = {"kind": "gap", "time": self.now(), "lines": self._dropped, "reason": _TOO_SLOW}
                self._dropped = 0
                output.put(_encode(gap))
            self._since += len(line)
            output.put(line)
        except (OSError, ValueError) as error:
            self._end(error)

    def close(self) -> None:
        """Put everything on disk, under the trace's own name."""
        with self._lock:
            output, self._output = self._output, None
            self.active = bool(self._listeners)
        if output is None or self.path is None:
            return
        try:
            output.close()
            self._part.replace(self.path)
        except (OSError, ValueError) as error:
            with self._lock:
                self._output = output
                self._end(error)

    def _give_up(self, error: Exception) -> None:
        with self._lock:
            self._end(error)

    def _end(self, error: Exception) -> None:
        """Nothing can be written any more: say so to who listens, once."""
        output, self._output = self._output, None
        self.active = bool(self._listeners)
        if output is None:
            return
        output.abandon()
        where = f"what was written is in {self._part.name}"
        self.error = f"the trace {self.path} ends early: {reason_of(error)}; {where}"
        self._tell(self.error)

    def _tell(self, reason: str) -> None:
        """Tell those who listen, at once, what has become of the trace."""
        for listener in self._who_wants("fault"):
            listener({"kind": "fault", "time": self.now(), "agent": "", "reason": reason})

    # ---- the lines ---------------------------------------------------------------------------

    def header(
        self,
        system: str,
        plans: Mapping[str, Plan],
        seed: int,
        virtual: bool,
        elsewhere: Iterable[str] = (),
        schema: Schema | None = None,
        queue: int | None = None,
        network: str | None = None,
        machine: Mapping[str, int] | None = None,
        sources: Mapping[str, str] | None = None,
    ) -> None:
        """The first line: which agents run which models, under which clock, and who runs elsewhere.

        Each of these adds a member:

        - `schema`: the types of the messages;
        - `queue`: how many signals that queue wait in a region, if it is not the usual number;
        - `network`: the words of the simulated network;
        - `machine`: which clock the machine has, and when the run began by it;
        - `sources`: the texts of the model by their paths, the first one's first.
        """
        if not self.active:
            return
        roles = {plan.name: plan for plan in plans.values()}
        messages = None
        if schema is not None:
            channels = {channel: schema.classes[kind] for channel, kind in schema.channels.items()}
            messages = {"descriptors": schema.descriptors, "channels": channels}
        start = datetime.fromtimestamp(time.time() - self.now() / 1e9).astimezone()
        self.write(
            "header",
            0,
            format=FORMAT,
            system=system,
            seed=seed,
            clock="virtual" if virtual else "real",
            start=None if virtual else start.isoformat(timespec="microseconds"),
            agents=[
                {"name": name, "role": plan.name, "model": plan.model, "source": plan.source}
                for name, plan in plans.items()
            ],
            names={name: titles_of(plan) for name, plan in roles.items()},
            elsewhere=list(elsewhere) or None,
            messages=messages,
            queue=queue,
            network=network,
            machine=machine,
            sources=packed(sources or {}),
        )

    def message(
        self,
        moment: int,
        identity: Identity,
        channel: str,
        message: object,
        to: Iterable[str],
        *,
        host: str | None = None,
        region: str | None = None,
        activity: str | None = None,
        sender: str | None = None,
        via: str | None = None,
    ) -> None:
        """A message was published and goes to the agents `to` (by radio: to each agent that hears it)."""
        if self._is_only_written("message"):
            line = (
                f'{{"kind":"message","time":{moment},"agent":{_text(identity[0])},"sequence":{identity[1]}'
                f',"channel":{_text(channel)},"message":{_encode(to_json(message))}'
            )
            told = (
                ("host", host),
                ("region", region),
                ("activity", activity),
                ("sender", sender),
                ("via", via),
            )
            for name, value in told:
                if value is not None:
                    line += f',"{name}":{_text(value)}'
            self._put_line(f'{line},"to":[{",".join(map(_text, to))}]}}')
        elif self.active:
            self.write(
                "message",
                moment,
                agent=identity[0],
                sequence=identity[1],
                channel=channel,
                message=to_json(message),
                host=host,
                region=region,
                activity=activity,
                sender=sender,
                via=via,
                to=list(to),
            )

    def step(
        self,
        moment: int,
        agent: str,
        plan: Plan,
        number: int,
        inputs: Iterable[Identity],
        ahead: Iterable[Sample],
        outcome: Outcome,
        configuration: tuple[str, ...] | None,
    ) -> None:
        """A step: the inputs it took, the transitions it took, the functions it called, where it led.

        `configuration` is None where it is the one after the agent's last step.
        """
        if not self.active:
            return
        further: dict[str, object] = {}
        functions = [
            {"function": effect.function, "value": to_json(effect.value)}
            for effect in outcome.effects
            if isinstance(effect, FunctionResult)
        ]
        if functions:
            further["functions"] = functions
        messages = [list(effect.identity) for effect in outcome.effects if isinstance(effect, MailTaken)]
        if messages:
            further["agent_messages"] = messages
        if configuration is not None:
            further["configuration"] = list(configuration)
        if outcome.again:
            further["again"] = True
        if outcome.finished:
            further["finished"] = True
        seen = [list(item.identity) for item in ahead]
        if self._is_only_written("step"):
            line = (
                f'{{"kind":"step","time":{moment},"agent":{_text(agent)},"step":{number}'
                f',"inputs":{_encode(list(inputs))}'
            )
            if seen:
                line += f',"ahead":{_encode(seen)}'
            line += f',"taken":[{",".join([self._way_text(plan, numbers) for numbers in outcome.taken])}]'
            self._put_line(f"{line},{_encode(further)[1:]}" if further else line + "}")
        else:
            self.write(
                "step",
                moment,
                agent=agent,
                step=number,
                inputs=[list(identity) for identity in inputs],
                ahead=seen or None,
                taken=[_way(plan, numbers) for numbers in outcome.taken],
                **further,
            )
        for effect in outcome.effects:
            if isinstance(effect, Fault):
                at = plan.transitions[effect.transition].at
                self._write_fault(moment, agent, effect.reason, at, transition=effect.transition)

    @property
    def is_kept(self) -> bool:
        """Whether the lines go into a file."""
        return self._output is not None

    def checkpoint_all(self) -> None:
        """Have the state of each agent written, if much was written since that was done last."""
        if self._since < checkpoint.EVERY or not self.is_kept:
            return
        with self._lock:
            if self._since < max(checkpoint.EVERY, checkpoint.SHARE * self._checkpoints):
                return
            self._since = self._checkpoints = 0
        for write in self.agents:
            write()

    def checkpoint(
        self,
        moment: int,
        agent: str,
        number: int,
        saved: Saved,
        parts: Iterable[tuple[str, str, str]],
        *,
        anew: bool,
    ) -> None:
        """The state of an agent's chart between two steps; `anew`: another chart has taken its place.

        `parts` are those that it has in conversations: conversation, participant and branch.
        """
        if not self.is_kept:
            return
        before = self._since
        self.write(
            "checkpoint",
            moment,
            agent=agent,
            step=number,
            model=saved.model,
            anew=anew or None,
            parts=[list(part) for part in parts] or None,
            state=state_of(saved),
        )
        self._checkpoints += self._since - before

    def _way_text(self, plan: Plan, numbers: tuple[int, ...]) -> str:
        """`_way` as it is written; it is the same each time."""
        key = (plan.name, plan.model, numbers)
        found = self._ways.get(key)
        if found is None:
            found = self._ways[key] = _encode(_way(plan, numbers))
        return found

    def activity(self, what: str, moment: int, agent: str, effect: Start | Cancel, **members: object) -> None:
        """An event of an activity: start, wait, missed, end, crash, cancel, late, overrun."""
        if members.keys() <= _NUMBERS and self._is_only_written("activity", what):
            # Most lines of a trace are these; put together by hand they cost a quarter.
            line = (
                f'{{"kind":"activity","time":{moment},"agent":{_text(agent)},"what":"{what}"'
                f',"label":"{effect.label}","activity":{_text(effect.activity)},"token":{effect.token}'
            )
            for name, value in members.items():
                line += f',"{name}":{value}'
            self._put_line(line + "}")
        elif self.active:
            self.write(
                "activity",
                moment,
                agent=agent,
                what=what,
                label=effect.label,
                activity=effect.activity,
                token=effect.token,
                **members,
            )

    def remark(self, moment: int, agent: str, reason: str, **members: object) -> None:
        """A fault that is the same for every agent: recorded once in a run."""
        with self._lock:
            known = reason in self._remarks
            if len(self._remarks) >= _MOST_REMARKS:
                self._remarks.clear()
            self._remarks.add(reason)
        if not known:
            self.fault(moment, agent, reason, "", **members)

    def fault(self, moment: int, agent: str, reason: str, at: str = "", **members: object) -> None:
        """Something could not be done; the agent continues."""
        self.count_fault(moment, agent, reason, at, str(members.get("activity") or ""))
        self._write_fault(moment, agent, reason, at, **members)

    def count_fault(self, moment: int, agent: str, reason: str, at: str = "", activity: str = "") -> None:
        """Count a fault; `step` writes those of a step."""
        with self._lock:
            self.faults.add(reason, agent, at, activity, moment)

    def _write_fault(self, moment: int, agent: str, reason: str, at: str, **members: object) -> None:
        self.write("fault", moment, agent=agent, reason=reason, at=at or None, **members)

    def failure(self, moment: int, agent: str, reason: str, at: str = "", **members: object) -> None:
        """The agent stops."""
        self.write("error", moment, agent=agent, reason=reason, at=at or None, **members)


def format_for(path: Path, part: Path) -> Format:
    """A new file at `part`, of the kind that the name `path` says.

    Raises:
        OSError: there cannot be a file.
        TraceError: the kind needs a package that is not installed.
    """
    if path.suffix == MCAP_SUFFIX:
        from aseme_dsl.runtime.trace.trace_mcap import McapFile

        return McapFile(part)
    if path.suffix == GZIP_SUFFIX:
        from aseme_dsl.runtime.trace.trace_gzip import GzipFile

        return GzipFile(part)
    return JsonLines(part)


def _no_time() -> int:
    return 0


def _always(kind: str, what: object) -> bool:
    return True


def _way(plan: Plan, numbers: tuple[int, ...]) -> Taken:
    """A transition taken, or the parts of a compound one."""
    parts = [plan.transitions[number] for number in numbers]
    text = " ; ".join(part.text for part in parts if part.text)
    ends: Taken = {
        "transitions": list(numbers),
        "source": parts[0].source,
        "target": parts[-1].target,
        "text": text,
    }
    return {**ends, "into": list(parts[-1].into)} if parts[-1].into else ends
