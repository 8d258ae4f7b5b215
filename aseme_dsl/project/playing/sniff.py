"""Sniffing: what agents say to each other in a run, taken from the lines of its traces as they come."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field
from datetime import datetime
from fnmatch import fnmatchcase

from aseme_dsl.diagrams.sequence.sequence import Arrow, Lifeline, Mark, Row, SequenceDiagram, seconds
from aseme_dsl.project.files.duration import duration
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.records import Record, agents_of

_AFTER = re.compile(r"\bafter\(([^)]*)\)")
_EXPIRED = re.compile(r"(?<![!\w])expired\((\w+)\)")
_ACTIVITY = re.compile(r"^activity (\w+) of state [0-9.]+ failed: ")
_CONTENT = 60
"""Letters of a content that are shown."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """Which rows are wanted; what is empty or None leaves all. Times are in ns, and both ends belong to it.

    Conversations and protocols may have `*` in them.
    """

    conversations: tuple[str, ...] = ()
    protocols: tuple[str, ...] = ()
    agents: tuple[str, ...] = ()
    since: int | None = None
    until: int | None = None


@dataclass(slots=True)
class _Agent:
    role: str
    inside: dict[str, tuple[str, str]] = field(default_factory=dict)
    """By branch: the conversation in which it takes part there, and as what."""
    left: dict[str, int] = field(default_factory=dict)
    """The conversations that it has left, and when."""
    entered: dict[str, int] = field(default_factory=dict)
    """When its states were entered last, by label."""


class Sniffer:
    """Follows the lines of one run, or of the processes of one run, and says what they show.

    Of a message from one process to another, the sender's trace counts where it is there.
    """

    def __init__(self, wanted: Wanted | None = None) -> None:
        self._wanted = wanted or Wanted()
        self._agents: dict[str, _Agent] = {}
        self._protocols: dict[str, str] = {}
        self._parts: dict[str, dict[str, None]] = {}
        self._names: dict[str, dict[tuple[str, int], str]] = {}
        """What was said, by conversation and by the message's identity."""
        self._left_out: Counter[str] = Counter()
        self._others: set[str] = set()
        self._shown: set[str] = set()
        self._seen: set[str] = set()
        """Who takes part in anything, wanted or not."""
        self.system = ""
        self.clock = "virtual"
        self.start: datetime | None = None

    def header(self, record: Record) -> None:
        """The first line of a trace; of several, those of the other processes."""
        self.system = str(record["system"])
        self.clock = str(record["clock"])
        if isinstance(record.get("start"), str):
            began = datetime.fromisoformat(record["start"])
            self.start = began if self.start is None else min(self.start, began)
        for agent in agents_of(record):
            self._agents.setdefault(str(agent["name"]), _Agent(str(agent["role"])))

    def rows(self, record: Record) -> Iterator[Row]:
        """What a line shows, if it is wanted."""
        for row in self._all(record):
            self._seen.update(_who(row))
            protocol = self._protocols.get(row.conversation, "")
            if self._is_wanted(row, protocol):
                self._shown.update(_who(row))
                yield row
            elif row.conversation:
                self._others.add(row.conversation)
                self._left_out["messages" if isinstance(row, Arrow) else "events"] += 1

    def lifelines(self) -> tuple[Lifeline, ...]:
        """Those who take part in what was shown: the team in its order, then others."""
        names = [name for name in self._agents if name in self._shown]
        names += sorted(self._shown - self._agents.keys())
        return tuple(Lifeline(name, self._role(name)) for name in names)

    @property
    def team(self) -> tuple[str, ...]:
        """The agents of the run, in their order."""
        return tuple(self._agents)

    def unknown(self) -> tuple[str, ...]:
        """The agents that are asked for, and that are neither in the team nor take part in anything."""
        asked = dict.fromkeys(self._wanted.agents)
        return tuple(name for name in asked if name not in self._agents and name not in self._seen)

    def remarks(self) -> tuple[str, ...]:
        """What was left out, in words; nothing if nothing was."""
        if not self._left_out:
            return ()
        what = " and ".join(
            f"{number} {name}" for name, number in sorted(self._left_out.items(), reverse=True)
        )
        count = len(self._others)
        return (f"left out: {what} of {count} conversation{'' if count == 1 else 's'}",)

    def title(self) -> str:
        """The system, and what the times are."""
        began = f"began {self.start.isoformat(sep=' ', timespec='seconds')}" if self.start else "virtual time"
        return f"{self.system} · {began}"

    def diagram(self, rows: Iterable[Row]) -> SequenceDiagram:
        """A diagram of all that was shown."""
        return SequenceDiagram(self.title(), self.lifelines(), tuple(rows), self.remarks())

    def _role(self, name: str) -> str:
        agent = self._agents.get(name)
        parts = ", ".join(self._parts.get(name, {}))
        role = agent.role if agent is not None else "not of the team"
        return role if not parts or parts == role else f"{role}: {parts}"

    # ---- which -------------------------------------------------------------------------------

    def _is_wanted(self, row: Row, protocol: str) -> bool:
        wanted = self._wanted
        return (
            _fits(row.conversation, wanted.conversations)
            and _fits(protocol, wanted.protocols)
            and (not wanted.agents or not _who(row).isdisjoint(wanted.agents))
            and (wanted.since is None or row.moment >= wanted.since)
            and (wanted.until is None or row.moment <= wanted.until)
        )

    # ---- what a line says --------------------------------------------------------------------

    def _all(self, record: Record) -> Iterator[Row]:
        moment, name = int(record["time"]), str(record.get("agent", ""))
        agent = self._agents.get(name)
        match record["kind"]:
            case "agent_message":
                self._remember(record, name, int(record["sequence"]))
                yield self._said(record, name, tuple(record["to"]))
            case "received":
                sender, number = record["input"]
                self._remember(record, str(sender), int(number))
                if sender not in self._agents:
                    yield self._said(record, str(sender), (name,))
            case "conversation" if agent is not None:
                yield from self._takes_part(record, agent, moment, name)
            case "step" if agent is not None:
                yield from _deadlines(record, agent, moment, name)
            case "unexpected":
                said = f"{record['performative']} {record.get('message', '')}".strip()
                if (
                    "message" not in record
                ):  # an external agent sends a message without meaning: no record tells that it came
                    yield self._meaningless(record, name)
                text = f"did not expect {said}: {record['reason']}"
                yield Mark(moment, name, text, str(record.get("conversation", "")))
            case "unsent":
                said = f"{record['performative']} {record['message']}"
                yield Mark(moment, name, f"{said} is not sent: {record['reason']}", _any_of(agent))
            case "lost" if "conversation" in record:
                text = f"a message to {record['peer']} is lost: {record['reason']}"
                yield Mark(moment, name, text, record["conversation"])
            case "fault" if "input" in record:  # what came for an agent that is down
                sender, number = record["input"]
                for conversation, names in self._names.items():
                    if (str(sender), int(number)) in names:
                        yield Mark(moment, name, str(record["reason"]), conversation)
            case "error":
                for conversation in _at_the_end(agent, moment):
                    reason = _ACTIVITY.sub(r"\1: ", str(record["reason"]))
                    yield Mark(moment, name, f"breaks down: {reason}", conversation, ends=True)
            case _:
                return

    def _remember(self, record: Record, sender: str, number: int) -> None:
        said = f"{record['performative']} {record['message']} of {sender}"
        self._names.setdefault(str(record["conversation"]), {})[sender, number] = said

    def _said(self, record: Record, sender: str, receivers: tuple[str, ...]) -> Arrow:
        conversation = str(record["conversation"])
        if record["protocol"]:
            self._protocols.setdefault(conversation, str(record["protocol"]))
        for who, part in (
            (sender, record.get("participant")),
            *((to, record.get("receiver")) for to in receivers),
        ):
            if part:
                self._parts.setdefault(who, {}).setdefault(str(part))
        return Arrow(
            int(record["time"]),
            sender,
            receivers,
            str(record["performative"]),
            str(record["message"]),
            _short(record["content"]),
            json.dumps(record["content"], ensure_ascii=False),
            conversation,
        )

    def _meaningless(self, record: Record, receiver: str) -> Arrow:
        content = str(record.get("content", ""))
        return Arrow(
            int(record["time"]),
            str(record["sender"]),
            (receiver,),
            str(record["performative"]),
            "",
            _short(content),
            content,
            str(record.get("conversation", "")),
        )

    def _takes_part(self, record: Record, agent: _Agent, moment: int, name: str) -> Iterator[Row]:
        conversation, branch = str(record["conversation"]), str(record["branch"])
        match record["what"]:
            case "open" | "join":
                agent.inside[branch] = (conversation, str(record["participant"]))
            case "leave":
                agent.inside.pop(branch, None)
                agent.left[conversation] = moment
                # Its own report lost agents.
                untaken = [(str(who), int(n)) for who, n in record.get("untaken", ()) if who != name]
                if untaken:
                    messages = f"{len(untaken)} messages"
                    if len(untaken) == 1:
                        messages = self._names.get(conversation, {}).get(untaken[0], "a message")
                    yield Mark(moment, name, f"leaves without having taken {messages}", conversation)
            case "suspend":
                yield Mark(moment, name, "is suspended", conversation)
            case "resume":
                yield Mark(moment, name, "is resumed", conversation)
            case "queue":
                yield Mark(moment, name, f"is busy: the invitation of {record['peer']} waits", conversation)
            case "busy":
                yield Mark(
                    moment, name, f"is busy: the invitation of {record['peer']} is answered", conversation
                )
            case "back":
                yield Mark(moment, name, f"meets {record['peer']} again", conversation)
            case "gone" if record.get("reason") != "completed":  # that is how most parts end
                reason = f" ({record['reason']})" if "reason" in record else ""
                yield Mark(moment, name, f"lost {record['peer']}{reason}", conversation)


def of_conversation(diagram: SequenceDiagram, name: str) -> SequenceDiagram:
    """What of a diagram belongs to one conversation, with those who take part in it."""
    rows = tuple(row for row in diagram.rows if row.conversation == name)
    shown = {who for row in rows for who in _who(row)}
    lifelines = tuple(line for line in diagram.lifelines if line.name in shown)
    return SequenceDiagram(f"{diagram.title} · {name}", lifelines, rows, diagram.remarks)


def _deadlines(record: Record, agent: _Agent, moment: int, name: str) -> Iterator[Mark]:
    """The deadlines that have passed in a step, of the participants that the agent is."""
    for way in record["taken"]:
        source, text = str(way["source"]), str(way["text"])
        head = text.partition(" / ")[0]
        place = _branch_of(source, agent)
        stays = source == way["target"] and text.startswith("on ")
        if place is not None and "(" in head:
            entered = _entered(source, agent)
            passed = [limit for limit in _AFTER.findall(head) if moment - entered >= _nanoseconds(limit)]
            passed += [f"the timer {timer}" for timer in _EXPIRED.findall(head)]
            if passed:
                what = "continues to wait" if stays else "waits no longer"
                yield Mark(moment, name, f"{what} ({passed[0]})", place)
        if not stays:
            agent.entered[str(way["target"])] = moment


def _branch_of(label: str, agent: _Agent) -> str | None:
    """The conversation of the innermost participant that a state is of."""
    around = [branch for branch in agent.inside if label == branch or label.startswith(f"{branch}.")]
    return agent.inside[max(around, key=len)][0] if around else None


def _entered(label: str, agent: _Agent) -> int:
    """When a state was entered: as the target of a transition, or with a state around it."""
    parts = label.split(".")
    around = (".".join(parts[:length]) for length in range(len(parts), 0, -1))
    return max((agent.entered[item] for item in around if item in agent.entered), default=0)


def _nanoseconds(text: str) -> int:
    try:
        return duration(text)
    except ValueError:
        return 0


def _inside(agent: _Agent | None) -> Iterable[tuple[str, str]]:
    return () if agent is None else agent.inside.values()


def _at_the_end(agent: _Agent | None, moment: int) -> tuple[str, ...]:
    """The conversations in which an agent is that breaks down: it has left them a moment ago."""
    if agent is None:
        return ("",)
    just_left = [name for name, when in agent.left.items() if when == moment]
    return tuple(dict.fromkeys([*(item[0] for item in agent.inside.values()), *just_left])) or ("",)


def _any_of(agent: _Agent | None) -> str:
    return next((item[0] for item in _inside(agent)), "")


def _who(row: Row) -> set[str]:
    return {row.agent} if isinstance(row, Mark) else {row.sender, *row.receivers}


def _fits(name: str, patterns: tuple[str, ...]) -> bool:
    return not patterns or any(fnmatchcase(name, pattern) for pattern in patterns)


def _short(content: object) -> str:
    """The members of a content that say something, in a short text."""
    if not isinstance(content, Mapping):
        text = str(content)
    else:
        said = [(name, value) for name, value in content.items() if value not in ("", None, [], {})]
        text = ", ".join(
            f"{name} {value if isinstance(value, str) else json.dumps(value)}" for name, value in said
        )
    return text if len(text) <= _CONTENT else f"{text[: _CONTENT - 1]}…"


# ---- for a terminal ------------------------------------------------------------------------------


def line_of(row: Row, width: int) -> str:
    """A row as a line of text; `width` is that of the longest name."""
    moment = seconds(row.moment)
    where = f"   [{row.conversation}]" if row.conversation else ""
    if isinstance(row, Mark):
        sign = "x" if row.ends else "!"
        return f"{moment:>12}  {row.agent:<{width}}  {sign} {row.text}{where}"
    content = f" ({row.content})" if row.content else ""
    to = ", ".join(row.receivers) or "nobody"
    return f"{moment:>12}  {row.sender:<{width}}  -- {row.text}{content} --> {to}{where}"


__all__ = ["Sniffer", "Wanted", "line_of", "of_conversation"]
