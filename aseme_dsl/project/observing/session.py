"""Session: one log, or the logs of the processes of one run, observed from the first line to the last."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field

from aseme_dsl.play.replay import NotReplayable
from aseme_dsl.play.scenario import Refused
from aseme_dsl.project.observing.model import Model, Team, are_alike, model_in, plans_in
from aseme_dsl.project.observing.statements import Plans, Statement, Statements
from aseme_dsl.project.observing.talks import Deviation, Message, ProtocolSum, Talks
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.packed import unpacked
from aseme_dsl.runtime.trace.records import Record, agents_of, as_record

_KINDS = frozenset(("agent_message", "received", "conversation", "swap"))
"""What is looked into for the protocols alone."""
MOST = 100
"""So many deviations are listed; the others are counted."""


class NoModel(Exception):
    """There is no model to observe a log against."""


@dataclass(frozen=True, slots=True)
class Observed:
    """What has become of all that a model says of a log."""

    events: int
    statements: tuple[Statement, ...]
    deviations: tuple[Deviation, ...]
    protocols: Mapping[str, ProtocolSum]
    notes: tuple[str, ...] = ()

    @property
    def is_broken(self) -> bool:
        """Whether a statement is broken, or a protocol is not kept."""
        is_broken = any(item.watched.verdict == "broken" for item in self.statements)
        return is_broken or any(item.broken for item in self.protocols.values())

    @property
    def is_decided(self) -> bool:
        """Whether nothing is undecided, and something was observed at all."""
        is_undecided = any(item.watched.verdict == "undecided" for item in self.statements)
        is_partial = any(item.from_the_middle or item.unchecked for item in self.protocols.values())
        return not is_undecided and not is_partial and bool(self.statements or self.protocols)


@dataclass(slots=True)
class Tell:
    """Who hears of what is broken, when it is seen."""

    statement: Callable[[Statement], None] = field(default=lambda item: None)
    deviation: Callable[[Deviation], None] = field(default=lambda item: None)


class Session:
    """Observes lines in the order of their times. First comes a header, or `begin`."""

    def __init__(self, model: Model | None, tell: Tell | None = None, *, from_start: bool = False) -> None:
        """Without a `model`, that in the header counts. `from_start`: see `Talks`."""
        self._model = model
        self._models: dict[str, Model] = {}
        """What was compiled of traces."""
        self._tells = tell is not None
        self._tell = tell or Tell()
        self._is_hasty = False
        self._from_start = from_start
        self._talks = Talks({}, from_start=from_start)
        self._statements: Statements | None = None
        self._agents: frozenset[str] = frozenset()
        self._deviations: list[Deviation] = []
        self._notes: list[str] = []
        self._count = 0
        self._events = 0
        self._moment = 0
        self._has_several = False

    def hasty(self) -> Session:
        """Another one that sees the same, in a fraction of the time, and collects nothing for stories.

        It raises StoryWanted where a statement is broken. If this one tells at once what is broken, so does
        the other one, and collects stories as well: it reports nothing twice.
        """
        found = Session(self._model, self._tell, from_start=self._from_start)
        found._models, found._is_hasty = self._models, not self._tells
        return found

    # ---- the beginning ---------------------------------------------------------------------------

    def headers(self, headers: Iterable[Record]) -> None:
        """The first lines of the traces of one run.

        Raises:
            NoModel: there is none in them, and none was given.
            NotReplayable: this version of asemec does not compile it.
        """
        known = list(headers)
        model = self._model
        if model is None:
            first = next((item for item in known if "sources" in item), None)
            if first is None:
                raise NoModel
            packed = first["sources"]
            model = self._models.get(packed) or model_in(unpacked(packed))
            self._models[packed] = model
        team = {
            str(item["name"]): str(item.get("role", "")) for header in known for item in agents_of(header)
        }
        self._agents = frozenset(team)
        self._has_several = len(known) > 1
        self._start(model, self._known(model, team), lambda: self._plans(model, known), is_trace=True)
        if self._statements is not None:
            for header in known:
                self._statements.header(header)

    def begin(self) -> None:
        """The log has agent messages, and nothing else. Raises NoModel, NotReplayable."""
        if self._model is None:
            raise NoModel
        self._start(self._model, self._model.team, self._model.plans, is_trace=False)
        if self._statements is not None:
            self._statements.begin(self._model.team)

    def _known(self, model: Model, team: Team) -> Team:
        """The agents whose roles the model has; all of its team, if these are among them."""
        roles = {chart.name for chart in model.system.iacs}
        for name, role in team.items():
            if role not in roles:
                self._notes.append(f"the model has no role {role}, which {name} plays")
        found = {name: role for name, role in team.items() if role in roles}
        whole = model.team
        return whole if found.items() <= whole.items() else found

    def _plans(self, model: Model, headers: Sequence[Record]) -> Plans:
        """What the agents of some traces may run; what another model has counts if it is like it.

        It stays what it is, for the lines of stories."""
        found = model.plans()
        ran = {(item.get("role"), item.get("model")) for header in headers for item in agents_of(header)}
        first = next((item for item in headers if "sources" in item), None)
        if ran <= found.keys() or first is None:
            return found
        try:
            others = plans_in(unpacked(first["sources"]))
        except NotReplayable:  # it is said of each agent that it ran another version
            return found
        own = {role: plan for (role, _), plan in found.items()}
        alike = {key: plan for key, plan in others.items() if key[0] in own and are_alike(plan, own[key[0]])}
        return alike | found

    def _start(self, model: Model, team: Team, plans: Callable[[], Plans], *, is_trace: bool) -> None:
        self._talks = Talks(model.contracts, from_start=self._from_start)
        script = model.script(team) if team else None
        if isinstance(script, Refused):
            self._notes.append(f"properties and clauses are not watched: {script.span}: {script.reason}")
        elif script is not None:
            self._statements = Statements(
                script,
                model.topics,
                plans,
                self._tell.statement,
                is_trace=is_trace,
                is_hasty=self._is_hasty,
            )

    # ---- lines -----------------------------------------------------------------------------------

    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of lines of which more counts than the time, who it is about, and their number."""
        statements = self._statements
        return _KINDS | statements.kinds if statements is not None and statements.is_needed else _KINDS

    def see(self, record: Record) -> None:
        """The next line of a trace behind the header."""
        self._events += 1
        if self._statements is not None and self._statements.is_needed:
            self._statements.see(record)
        match record["kind"]:
            case "agent_message":
                self._say(record, record["agent"], tuple(record["to"]), record["sequence"])
            case "received":
                sender, number = record["input"]
                if sender not in self._agents:
                    self._say(record, str(sender), (record["agent"],), number)
                elif self._has_several:
                    self._talks.arrived(_message(record, str(sender), (record["agent"],), number))
            case "conversation":
                if record["what"] == "open":
                    self._talks.opened(record["conversation"])
            case "swap":
                self._swap(record)
            case _:
                pass

    def hear(self, message: Message) -> None:
        """The next message of a log that has nothing else."""
        self._events += 1
        statements = self._statements
        if statements is not None and statements.is_needed:
            self._moment = max(self._moment, message.moment)
            statements.see(_record(message, self._moment, self._events))
        found = self._talks.see(message)
        if found:
            self._told(found)

    def _say(self, record: Record, sender: str, to: tuple[str, ...], number: str | int) -> None:
        if record["protocol"]:
            self._told(self._talks.see(_message(record, sender, to, number if self._has_several else None)))

    def _swap(self, record: Record) -> None:
        """The protocols of the new version count for conversations that begin from now on."""
        if "sources" in record and record.get("what", "done") == "done" and self._model is None:
            try:
                self._talks.renew(model_in(unpacked(record["sources"])).contracts)
            except NotReplayable as problem:
                self._notes.append(f"protocols are those from before the swap: {problem}")

    def _told(self, found: Iterable[Deviation]) -> None:
        for item in found:
            self._count += 1
            if len(self._deviations) < MOST:
                self._deviations.append(item)
                self._tell.deviation(item)

    def note(self, text: str) -> None:
        """Something is to be said of the log."""
        self._notes.append(text)

    # ---- the end ---------------------------------------------------------------------------------

    def end(self) -> Observed:
        """What has become of everything."""
        self._told(self._talks.end())
        statements = self._statements.end() if self._statements is not None else ()
        notes = (*self._notes, *self._said_of_talks())
        return Observed(self._events, statements, tuple(self._deviations), self._talks.sums, notes)

    def _said_of_talks(self) -> Iterable[str]:
        talks = self._talks
        if self._count > len(self._deviations):
            yield f"{self._count - len(self._deviations)} further conversations leave their protocols"
        for name, number in sorted(talks.too_large.items()):
            yield f"the protocol {name} is too large to be checked ({number} messages of it)"
        for name, number in talks.others.most_common(5):
            yield f"the model has no protocol {name} ({number} messages of it)"
        if talks.has_let_go:
            yield "too many conversations at once: the oldest were not followed to their ends"


def _message(record: Record, sender: str, to: tuple[str, ...], number: str | int | None) -> Message:
    """An agent message as a trace has it; with a `number`, lines of several traces may be about it."""
    return Message(
        record["time"],
        record["conversation"],
        record["protocol"],
        sender,
        to,
        record["performative"],
        str(record["message"]),
        record["content"],
        parts=(record["participant"], record["receiver"]),
        is_one=True,
        name="" if number is None else f"{sender}-{number}",
    )


def _record(message: Message, moment: int, number: int) -> Record:
    """A message as a trace would have it."""
    return as_record(
        {
            "kind": "agent_message",
            "time": moment,
            "agent": message.sender,
            "sequence": number,
            "performative": message.performative,
            "message": message.message or "",
            "content": message.content if isinstance(message.content, dict) else {},
            "protocol": message.protocol,
            "conversation": message.conversation,
            "to": list(message.to),
        }
    )


__all__ = ["NoModel", "Observed", "Session", "Tell"]
