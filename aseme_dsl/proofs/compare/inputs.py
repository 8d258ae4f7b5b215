"""Inputs: what may happen to both versions next, and what that is for each of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import combinations

from aseme_dsl.proofs.compare.decisions import Decisions
from aseme_dsl.proofs.compare.side import Side, shown
from aseme_dsl.proofs.explore.deciding.joining import called, end_of, related_in
from aseme_dsl.proofs.explore.deciding.staging import events, watched, writable
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import (
    LOST,
    REASONS,
    AgentMessage,
    Completed,
    Crashed,
    Happened,
    Input,
    Sample,
)
from aseme_dsl.runtime.chart.plan import Plan, is_in, terms_in

OTHER = "other1"
"""The agent from which messages come."""


@dataclass(frozen=True, slots=True)
class Move:
    """Something that may happen to both versions. `number` tells several of one name apart.

    `kind` is one of begin, end, fail, write, event, sample, message, lost, news, time and together. `name` is
    what it is about: an activity, an event, a channel, or a participant. `more` is what comes: an outcome, a
    reason, or what message from whom. The `parts` of what happens together happen at one moment.
    """

    kind: str
    text: str
    name: str = ""
    number: int = 0
    more: tuple[str, ...] = ()
    content: object = None
    parts: tuple[Move, ...] = ()

    @property
    def what(self) -> str:
        """What comes, as a plan says what else matters beside it."""
        match self.kind:
            case "sample" | "event":
                return self.name
            case "end":
                return end_of(self.name)
            case "message":
                return called(*self.more[:2])
            case "lost":
                return called(LOST)
        return ""


BEGIN = Move("begin", "it begins")
NEWS = Move("news", "new messages arrive")


class Surroundings:
    """What may happen to two versions of a role."""

    def __init__(self, old: Side, new: Side, decisions: Decisions) -> None:
        self._sides = old, new
        self._decisions = decisions
        plans = old.plan, new.plan
        self._events = tuple(dict.fromkeys(name for plan in plans for name in events(plan)))
        self._watched = watched(plans[0]) | watched(plans[1])
        self._fails = any(
            event == ("error",) for plan in plans for t in plan.transitions for event in t.events
        )
        self.is_limited = False
        """Whether messages that come early are looked at one at a time."""
        self._beside = frozenset(
            (_common(side, what), _common(side, other))
            for side in self._sides
            for what, others in related_in(side.plan).items()
            for other in others
        )
        """What makes a difference if it comes in the same step as something else."""
        self._reasons = REASONS if any(_asks_reason(plan) for plan in plans) else ("left",)

    @cached_property
    def left_out(self) -> str:
        """What of two versions is not compared; empty if nothing is."""
        ends = [
            {side.stage.version.name(item.name): item.ends for item in side.plan.activities}
            for side in self._sides
        ]
        for name, outcomes in ends[0].items():
            if name in ends[1] and set(ends[1][name]) != set(outcomes):
                return f"the outcomes of {name} are others"
        return ""

    # ---- what may happen ---------------------------------------------------------------------

    def moves(self) -> Iterator[Move]:
        """What may happen next, but for what time brings."""
        found: dict[Move, None] = {}
        for side in self._sides:
            if not side.is_over:
                found |= dict.fromkeys(self._ends(side))
                found |= dict.fromkeys(self._messages(side))
        found |= dict.fromkeys(self._samples())
        found |= {Move("event", f"the event {name} is raised", name): None for name in self._events}
        yield from found
        yield NEWS
        for one, other in combinations(found, 2):
            if (one.what, other.what) in self._beside or (other.what, one.what) in self._beside:
                yield Move("together", f"{one.text}; at the same moment {other.text}", parts=(one, other))

    def _ends(self, side: Side) -> Iterator[Move]:
        counts: Counter[str] = Counter()
        for item in side.running:
            number = counts[item.name]
            counts[item.name] += 1
            is_frozen = any(is_in(item.label, label) for label in side.frozen)
            outcomes = self._outcomes(item.activity)
            if item.label not in side.chart.WAITING and not is_frozen:
                for outcome in outcomes or ("",):
                    text = f"{item.name} ends" + (f" with {outcome}" if outcome else "")
                    yield Move("end", text, item.name, number, (outcome,))
            if self._fails:
                yield Move("fail", f"{item.name} fails", item.name, number)
            if not is_frozen and self._watched.intersection(writable(side.plan, item.label)):
                yield Move("write", f"{item.name} writes its variables", item.name, number)

    def _outcomes(self, activity: str) -> tuple[str, ...]:
        ends = [
            next((i.ends for i in side.plan.activities if side.stage.version.name(i.name) == activity), ())
            for side in self._sides
        ]
        if not (ends[0] and ends[1]):
            return ends[0] or ends[1]
        return tuple(item for item in ends[0] if item in ends[1])

    def _samples(self) -> Iterator[Move]:
        channels = dict.fromkeys(channel for side in self._sides for channel in side.chart.READERS)
        for channel in channels:
            if channel in self._sides[0].stage.open or not any(_is_free(s, channel) for s in self._sides):
                continue
            hosts = {host for side in self._sides for host in _hosts(side, channel)} or {None}
            for host in sorted(host or OTHER for host in hosts):
                for content in self._contents(channel.rpartition(".")[2]):
                    text = f"{channel} {shown(content)} arrives"
                    yield Move("sample", text, channel, 0, (host,), content)

    def _contents(self, message: str) -> tuple[object, ...]:
        return self._decisions.values.contents(message) if message else (None,)

    def _messages(self, side: Side) -> Iterator[Move]:
        counts: Counter[str] = Counter()
        for info in side.plan.branches:
            if not side.is_in_branch(info.label):
                continue
            part = side.stage.version.part_of(info)
            number = counts[part]
            counts[part] += 1
            leaves = [leaf for leaf in side.chart.configuration() if is_in(leaf, info.label)]
            kinds = sorted({kind for leaf in leaves for kind in side.plan.taken_from(info.label, leaf)})
            now = _taken_now(side.plan, leaves)
            waiting = {(i.performative, i.message, i.sender) for i in side.chart.mail[info.label]}
            for performative, message, participant in kinds:
                if not participant:
                    continue
                if waiting and (performative, message, participant) not in now:
                    self.is_limited = True
                    continue
                for sender in side.others(info.label, participant):
                    if (performative, message, sender) in waiting:
                        continue
                    for content in self._contents(message):
                        said = f"{performative} {message}{'' if content is None else f' {shown(content)}'}"
                        more = (performative, message, side.stage.version.part(participant), sender)
                        yield Move("message", f"{said} arrives from {sender}", part, number, more, content)
            for participant in info.loses:
                for sender in side.others(info.label, participant):
                    if (LOST, "", sender) not in waiting:
                        for reason in self._reasons:
                            text = f"{sender} is lost ({reason})"
                            gone = (side.stage.version.part(participant), sender, reason)
                            yield Move("lost", text, part, number, gone)

    # ---- what it is for one version ----------------------------------------------------------

    def inputs(self, side: Side, move: Move, now: int, number: int) -> list[Input]:
        """What a version is given. `number` is a new one for what is written or sent in this move."""
        match move.kind:
            case "end" | "fail" | "write":
                return self._of_activity(side, move, number)
            case "event":
                return [Happened(move.name)]
            case "sample":
                if move.name not in side.chart.READERS:
                    return []
                content = side.stage.as_own(move.content)
                sender = move.more[0]
                return [Sample(move.name, content, sender, now, (sender, number))]
            case "message" | "lost":
                return self._mail(side, move, number)
            case "together":
                parts = enumerate(move.parts, number)
                return [item for own, part in parts for item in self.inputs(side, part, now, own)]
        return []

    def _of_activity(self, side: Side, move: Move, number: int) -> list[Input]:
        found = [item for item in side.running if item.name == move.name]
        if len(found) <= move.number:
            return []
        item = found[move.number]
        if move.kind != "fail":
            side.write(item.label, number)
        if move.kind == "write" or (move.kind == "end" and item.label in side.chart.WAITING):
            return []
        side.running = tuple(other for other in side.running if other is not item)
        if move.kind == "fail":
            return [Crashed(item.label, item.token, "it has failed")]
        own = side.plan.by_label[item.label].activity
        info = next((info for info in side.plan.activities if info.name == own), None)
        has_it = info is not None and move.more[0] in info.ends
        return [Completed(item.label, item.token, move.more[0] if has_it else None)]

    def _mail(self, side: Side, move: Move, number: int) -> list[Input]:
        found = [
            info.label
            for info in side.plan.branches
            if side.stage.version.part_of(info) == move.name and side.is_in_branch(info.label)
        ]
        if len(found) <= move.number:
            return []
        branch = found[move.number]
        if move.kind == "lost":
            part, sender, reason = move.more
            participant = side.stage.version.own_part(part)
            return [AgentMessage(branch, LOST, "", reason, participant, sender, (sender, number))]
        performative, message, part, sender = move.more
        participant = side.stage.version.own_part(part)
        content = side.stage.as_own(move.content)
        return [AgentMessage(branch, performative, message, content, participant, sender, (sender, number))]


def _common(side: Side, what: str) -> str:
    """What comes, as both versions call it."""
    ended = what.removeprefix(end_of(""))
    return what if ended == what else end_of(side.stage.version.name(ended))


def _taken_now(plan: Plan, leaves: Sequence[str]) -> frozenset[tuple[str, ...]]:
    """The agent messages that a transition of an active state takes."""
    return frozenset(
        tuple(map(str, event[1:4]))
        for item in plan.transitions
        for event in item.events
        if event[0] == "received" and any(is_in(leaf, item.source) for leaf in leaves)
    )


def _asks_reason(plan: Plan) -> bool:
    return any(term[:1] == ("reason",) for term in terms_in(item.condition for item in plan.transitions))


def _is_free(side: Side, channel: str) -> bool:
    """Whether a message of a channel can be given to a version: none waits in one of its regions."""
    if side.is_over:
        return False
    boards, regions = side.chart.boards(), side.chart.REGIONS
    found = [
        boards[number]
        for number in side.chart.READERS.get(channel, ())
        if not any(is_in(regions[number], label) for label in side.frozen)
    ]
    return any(board is not None and not board.waits(channel) for board in found)


def _hosts(side: Side, channel: str) -> Iterator[str | None]:
    for number in side.chart.READERS.get(channel, ()):
        board = getattr(side.chart, f"b{number}")
        yield from (host for _, host in board.SLOTS.get(channel, ()))


__all__ = ["BEGIN", "NEWS", "Move", "Surroundings"]
