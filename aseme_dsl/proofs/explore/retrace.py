"""Retrace: a run that a search has found once more, with all that was decided in it, and when it can happen.

A search decides late what a message says or what an activity has written. Here each decision is given back to
what it is about: the message where it was made, the activity where it wrote. Times are found last: the moves
of a run have no moments, but deadlines, timers and ages tie some of them to each other.
"""

from __future__ import annotations

import contextlib
from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import partial
from typing import cast

from aseme_dsl.proofs.explore.ages import next_age, passing, thresholds_of
from aseme_dsl.proofs.explore.deciding.later import content_of
from aseme_dsl.proofs.explore.deciding.unread import Path
from aseme_dsl.proofs.explore.explored import Circling, Explored, Move
from aseme_dsl.proofs.explore.memory import Picture
from aseme_dsl.proofs.explore.reducing.spent import Dropped
from aseme_dsl.proofs.explore.search import Step
from aseme_dsl.proofs.explore.surroundings import NOW, Underway
from aseme_dsl.proofs.timed.stamp import Window
from aseme_dsl.proofs.timed.ties import Tie, before, found_for, just
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.inputs import Sample
from aseme_dsl.runtime.message.acl import AclMessage


class NotRetraced(Exception):
    """A run has something for which scenarios have no words; the text says what."""


class _Marked(int):
    """The moment at which an explored team stands, with the number of the move in which it was read."""

    step: int

    def __add__(self, other: int) -> _Marked:
        return _marked(int(self) + other, self.step)

    __radd__ = __add__


def _marked(moment: int, step: int) -> _Marked:
    found = _Marked(moment)
    found.step = step
    return found


# ---- what happens -----------------------------------------------------------------------------------


@dataclass(slots=True)
class Content:
    """What a message says: its members as far as something has read them, or all of it at once."""

    kind: str
    members: dict[Path, object] = field(default_factory=dict)
    whole: object = None


@dataclass(slots=True)
class Acts:
    """An activity runs, ends or fails, as `verb` says, and does something before."""

    agent: str
    activity: str
    verb: str
    outcome: str | None = None
    sets: dict[str, object] = field(default_factory=dict)
    writes: list[tuple[str, Content]] = field(default_factory=list)
    sends: list[tuple[str, Content, str]] = field(default_factory=list)
    """Agent messages: the performative, what it says, and the participant to which it goes."""
    prepares: list[Content] = field(default_factory=list)
    takes: list[tuple[str | None, str]] = field(default_factory=list)
    """Agent messages, with their performatives, and signals, by their channels."""


@dataclass(slots=True)
class Comes:
    """A message comes on a channel, from outside or from an activity of the agent itself."""

    agent: str
    channel: str
    content: Content
    sender: str | None
    earlier: int = 0
    """So long before its move (ns)."""


@dataclass(frozen=True, slots=True)
class Arrives:
    """What was on its way arrives, or is lost; `what` is a channel, or a performative and a type."""

    agent: str
    sender: str
    what: str
    is_lost: bool


@dataclass(frozen=True, slots=True)
class Event:
    """An event is raised."""

    agent: str
    event: str


@dataclass(frozen=True, slots=True)
class Crash:
    agent: str


@dataclass(frozen=True, slots=True)
class Gives:
    """A function gives a value from now on; `random` draws it."""

    agent: str
    function: str
    value: object


Happening = Acts | Comes | Arrives | Event | Crash | Gives


@dataclass(frozen=True, slots=True)
class Retraced:
    """What happens in each move of a run, and the moments of the moves (ns)."""

    happenings: tuple[tuple[Happening, ...], ...]
    moments: tuple[int, ...]


def retrace(
    explored: Explored, first: Picture, steps: Sequence[Step], moments: Sequence[int] | None = None
) -> Retraced:
    """Make the moves of a run again, from the first state on; at these moments, if they are known.

    Raises:
        NotRetraced: what happens, or when, cannot be said in a scenario.
    """
    return _Retrace(explored, first, moments).run(steps)


def renewals(explored: Explored, first: Picture, steps: Sequence[Step]) -> Mapping[int, tuple[Window, ...]]:
    """When messages become old that may be renewed at any moment: a window more, by the moves of a run with
    times."""
    found = _Retrace(explored, first, [0] * len(steps))
    with contextlib.suppress(NotRetraced):
        found.run(steps)
    return found.windows(steps)


@dataclass(frozen=True, slots=True)
class _Renewed:
    """A message that became old in move `step` was renewed `age` ns before: not before move `since`, and not
    after move `until`, if there is one."""

    step: int
    age: int
    since: int
    until: int | None


class _Retrace:
    def __init__(self, explored: Explored, first: Picture, moments: Sequence[int] | None) -> None:
        self._moments = moments
        self._explored = explored
        self._first = first
        self._step = 0
        self._happenings: list[list[Happening]] = []
        self._contents: dict[int, Content] = {}
        self._forgotten: dict[int, int] = {}
        """The contents that may be renewed at any moment, with the moves since which they may."""
        self._lasting: dict[int, int] = {}
        """Those that are not renewed any more, with the last moves in which they might be."""
        self._renewed: list[_Renewed] = []
        self._anew: set[int] = set()
        """The contents that are decided anew in the present move."""
        self._standing: dict[str, int] = {}
        """Messages that may have come, or not, by how they are called when functions are given them."""
        self._places: dict[int, tuple[str, str, str | None]] = {}
        """Where contents came to that may come again: the agent, the channel and the sender."""
        self._wrote: dict[tuple[str, str], Acts] = {}
        """What has written a variable of an agent last."""
        self._ended: dict[str, Acts] = {}
        """The activity of an agent that has ended last."""
        self._overtaken: list[Underway] = []
        self._dropped: list[Dropped] = []
        """What does nothing any more where it comes: it comes with what was sent after it."""
        self._about: Acts | None = None
        """What acts in the present move, if an activity does."""
        self._kind: tuple[str, ...] = ()
        self._origins: dict[tuple[str, ...], tuple[int, int]] = {}
        """From when something is counted: so long (ns) after which move."""
        self._ties: list[Tie] = []

    def run(self, steps: Sequence[Step]) -> Retraced:
        explored = self._explored
        clock = explored.driver.clock
        heard: list[tuple[Hashable, object]] = []
        try:
            explored.take_back(self._first)
            if self._moments is None:
                self._note_origins()
            for number, step in enumerate(steps, 1):
                self._step = number
                self._happenings.append([])
                self._note_standing()
                self._anew.clear()
                move = step.among(list(explored.moves()))
                self._kind = move.kind
                aged = self._age(move)
                if self._moments is None:
                    self._pend(move, aged)
                    self._keep_assumed(move)
                heard.clear()
                explored.choices.heard = heard
                explored.spent.heard = self._dropped
                explored.choices.follow(step.way)
                if self._moments is None:
                    clock.moment = _marked(NOW, number)
                else:
                    explored.next_moment()
                self._about = self._begin(move)
                with contextlib.suppress(Circling):
                    explored.make(move)
                self._hear(heard)
                explored.choices.heard = None
                explored.spent.heard = None
                if self._moments is None:
                    clock.moment = NOW
                explored.picture()
                self._note_lasting()
                if self._moments is None:
                    self._keep_joined()
                    self._tie_age()
                    self._note_origins()
                    if aged is not None:
                        self._origins.update((key, (number, -aged.age)) for key in self._keys(move))
        finally:
            explored.choices.heard = None
            explored.spent.heard = None
            clock.moment = NOW
        if self._moments is None:
            self._await_assumed()
        moments = found_for(len(steps), self._ties) if self._moments is None else self._moments
        if moments is None:
            raise NotRetraced("its times exclude each other")
        return Retraced(tuple(map(tuple, self._happenings)), tuple(moments))

    def windows(self, steps: Sequence[Step]) -> Mapping[int, tuple[Window, ...]]:
        """See `renewals`."""
        origins = [0, *(step.origin for step in steps)]
        found: dict[int, tuple[Window, ...]] = {}
        for item in self._renewed:
            windows = [Window(origins[item.since], item.age, None)]
            if item.until is not None:
                windows.append(Window(origins[item.until], 0, item.age))
            found[origins[item.step]] = tuple(windows)
        return found

    # ---- moves -------------------------------------------------------------------------------

    def _begin(self, move: Move) -> Acts | None:
        """What a move is, without what is decided in it."""
        match move.kind:
            case ("end" | "act" | "fail" as what, agent, label):
                found = self._execution(agent, label)
                verbs = {"end": "ends", "act": "does", "fail": "fails"}
                acts = Acts(agent, found.activity, verbs[what])
                if what != "fail":
                    for name in self._explored.written(found, is_end=what == "end"):
                        self._wrote[agent, name] = acts
                if what == "end":
                    self._ended[agent] = acts
                self._add(acts)
                return acts
            case ("arrive" | "lose" as what, sender, receiver, *_):
                item = cast("Underway", _argument(move))
                if what == "arrive":
                    self._overtake(sender, receiver, item)
                if not item.overtakes:
                    self._follow_dropped(sender, receiver)
                self._add(Arrives(receiver, sender, _what(item), what == "lose"))
            case ("event", agent, event):
                self._add(Event(agent, event))
            case ("crash", agent):
                self._add(Crash(agent))
            case ("begin",):
                self._ties.append(just(self._step, 0, 0))
            case ("input" | "time" | "timer" | "pace" | "pause", *_):
                pass  # what is decided in it says what comes; or time passes
            case _:
                raise NotRetraced(f"no statement says `{move.text}`")
        return None

    def _overtake(self, sender: str, receiver: str, item: Underway) -> None:
        """A state overtakes others: they come at the same moment, just before it, and make no difference.

        Raises NotRetraced: one that was overtaken comes later.
        """
        if item in self._overtaken:
            raise NotRetraced("a message comes that another one has overtaken")
        waiting = self._explored.ways.ways[sender, receiver]
        if not item.overtakes or item.what.split(".")[1] != "state":
            return
        for older in waiting[: waiting.index(item)]:
            if older.what == item.what and older not in self._overtaken:
                self._overtaken.append(older)
                self._add(Arrives(receiver, sender, _what(older), False))

    def _follow_dropped(self, sender: str, receiver: str) -> None:
        """What was dropped before a message that comes now comes just before it."""
        left: list[Dropped] = []
        for dropped in self._dropped:
            if (dropped.sender, dropped.receiver) != (sender, receiver):
                left.append(dropped)
            elif dropped.before:
                left.append(replace(dropped, before=dropped.before - 1))
            else:
                self._add(Arrives(receiver, sender, _what(dropped.item), False))
        self._dropped[:] = left

    def _execution(self, agent: str, label: str) -> Execution:
        running = [item for item in self._explored.driver.running if item.agent == agent]
        found = next(item for item in running if item.label == label)
        if next(item for item in running if item.activity == found.activity) is not found:
            raise NotRetraced(f"{agent} runs {found.activity} twice at once")
        return found

    def _add(self, item: Happening) -> None:
        self._happenings[-1].append(item)

    def _put_before(self, item: Happening) -> None:
        """What comes with a move stands before it."""
        own = self._happenings[-1]
        place = len(own) - (1 if own and isinstance(own[-1], Acts | Arrives | Event) else 0)
        own.insert(place, item)

    # ---- decisions ---------------------------------------------------------------------------

    def _hear(self, heard: Sequence[tuple[Hashable, object]]) -> None:
        acts = self._about
        comes: tuple[str, str] | None = None
        publishes = ""
        given: dict[tuple[str, str], object] = {}
        joined = iter(self._explored.joined)
        for what, value in heard:
            match what:
                case ("ends",):
                    if acts is not None:
                        acts.outcome = str(value)
                case ("come", str() as agent, str() as channel):
                    comes = (agent, channel) if value else None
                case ("publish", str() as channel):
                    publishes = channel if value else ""
                case ("input",):
                    self._came(comes or self._channel(), Content("", whole=value))
                    comes = None
                case ("published", str() as channel):
                    assert acts is not None
                    acts.writes.append((channel, Content("", whole=value)))
                case ("made", int() as number, str() as kind):
                    content = self._contents[number] = Content(kind)
                    if publishes and acts is not None:
                        acts.writes.append((publishes, content))
                        publishes = ""
                    else:
                        self._came(comes or self._channel(), content, number)
                        comes = None
                case ("forgotten", int() as number):
                    self._forgotten.setdefault(number, self._step)
                case ("member", int() as number, str() as kind, tuple() as path):
                    self._content(number, kind).members[path] = value
                case ("variable", str() as agent, str() as name, _):
                    self._set(agent, name, value)
                case ("send", str() as performative, str() as part):
                    if value is not None and acts is not None:
                        acts.sends.append((performative.split()[0], Content("", whole=value), part))
                case ("read", str() as performative, str() as message, _):
                    if value and acts is not None:
                        acts.takes.append((performative, message))
                case ("signal", str() as channel):
                    if value and acts is not None:
                        acts.takes.append((None, channel))
                case ("content", str() as agent, _):
                    self._prepare(agent, Content("", whole=value))
                case ("function", str() as agent, str() as name, str() as arguments):
                    if given.setdefault((agent, name), value) != value:
                        raise NotRetraced(f"{name} gives two values at one moment")
                    self._stands(arguments)
                    self._put_before(Gives(agent, name.partition("(")[0], value))
                case ("split", _):
                    pass  # what it stands for is heard, too
                case ("steps", _):
                    pass  # what it does not take at once, it takes with what comes
                case ("joins", "way", str() as sender, str() as agent, str() as channel, _):
                    if value:
                        if not next(joined).overtakes:
                            self._follow_dropped(sender, agent)
                        self._add(Arrives(agent, sender, channel, False))
                case ("joins", "event", str() as agent, str() as event):
                    if value:
                        self._add(Event(agent, event))
                case ("age", *_):
                    pass  # its moment makes it old
                case ("random", str() as agent, _):
                    if given.setdefault((agent, "random"), value) != value:
                        raise NotRetraced("random() gives two values at one moment")
                    self._put_before(Gives(agent, "random", value))
                case _:
                    raise NotRetraced(f"no statement decides {what}")

    def _channel(self) -> tuple[str, str]:
        """Where the message comes that the present move gives."""
        match self._kind:
            case ("input", agent, channel):
                return agent, channel
            case _:
                raise NotRetraced("a message comes from nowhere")

    def _came(self, place: tuple[str, str], content: Content, number: int | None = None) -> None:
        agent, channel = place
        sender = agent if self._explored.coming.brief[agent].get(channel) else None
        if number is not None:
            self._places[number] = agent, channel, sender
        self._put_before(Comes(agent, channel, content, sender))

    def _content(self, number: int, kind: str) -> Content:
        """A content of which a member is decided: a new one, if the one before was forgotten."""
        if number in self._forgotten:
            if number not in self._places:
                raise NotRetraced(f"a {kind} that was taken is decided again")
            self._anew.add(number)
            self._renew(number, kind)
        if number not in self._contents:
            raise NotRetraced(f"a {kind} was decided before the run began")
        return self._contents[number]

    def _renew(self, number: int, kind: str, earlier: int = 0) -> None:
        """Another message comes in the place of one, so long before the present move."""
        del self._forgotten[number]
        agent, channel, sender = self._places[number]
        self._contents[number] = Content(kind)
        self._put_before(Comes(agent, channel, self._contents[number], sender, earlier))

    def _note_standing(self) -> None:
        """Messages stand for what may have come: they come when something is decided of them."""
        for agent, channel, content in self._explored.coming.standing_now():
            if content.number not in self._places:
                sender = agent if self._explored.coming.brief[agent][channel] else None
                self._places[content.number] = agent, channel, sender
                self._standing[f"{content.kind.__name__} {content.number} ("] = content.number
                self._forgotten.setdefault(content.number, self._step)

    def _stands(self, arguments: str) -> None:
        """What a function is given has come, even if nothing has asked for a member of it."""
        for text, number in self._standing.items():
            if text in arguments and number not in self._contents:
                self._content(number, text.split()[0])

    def _set(self, agent: str, name: str, value: object) -> None:
        acts = self._wrote.get((agent, name))
        if acts is None:
            raise NotRetraced(f"nothing has written {name}")
        acts.sets[name.partition("@")[0]] = value

    def _prepare(self, agent: str, content: Content) -> None:
        acts = self._ended.get(agent)
        if acts is None:
            return  # it sends the values of a new message: whether the run needs others, its replay shows
        kind = type(content.whole).__name__
        acts.prepares[:] = [item for item in acts.prepares if type(item.whole).__name__ != kind]
        acts.prepares.append(content)

    # ---- times -------------------------------------------------------------------------------

    def _age(self, move: Move) -> _Renewed | None:
        """A message becomes old that may have been renewed: then it comes so long before."""
        if move.kind[0] != "time" or move.kind[2] != "message":
            return None
        for item in self._aging(move):
            number = None if (content := content_of(item.message)) is None else content.number
            if content is None or number not in self._forgotten or number not in self._places:
                continue
            agent = next(one for one in self._explored.agents if one.name == move.kind[1])
            ages = thresholds_of(agent.plan)[0][item.channel]
            age = next_age(0, ages)
            assert age is not None and number is not None
            found = _Renewed(self._step, age, self._forgotten[number], self._lasting.get(number))
            self._renew(number, content.kind.__name__, age)
            self._renewed.append(found)
            return found
        return None

    def _aging(self, move: Move) -> Iterator[Sample]:
        """The messages that become old in a move, and were new before."""
        _, name, _, channel = move.kind
        agent = next(item for item in self._explored.agents if item.name == name)
        for board in agent.chart.boards():
            item = None if board is None else board.newest(channel)
            if item is not None and item.time == NOW:
                yield item

    def _keys(self, move: Move) -> list[tuple[str, ...]]:
        return [key for key in self._origins if key[:3] == ("message", move.kind[1], move.kind[3])]

    def _note_lasting(self) -> None:
        """Which messages may still be renewed after the present move."""
        coming = self._explored.coming
        agents = {agent.name: agent for agent in self._explored.agents}
        for number in [*self._lasting]:
            if self._forgotten.get(number, self._step) >= self._step:
                del self._lasting[number]
        for number in self._forgotten:
            if number in self._places and number not in self._lasting:
                name, channel, _ = self._places[number]
                if channel in coming.brief[name] and not coming.may_come(agents[name], channel):
                    self._lasting[number] = self._step

    def _pend(self, move: Move, aged: _Renewed | None) -> None:
        """Tie a move to what is pending before it: it is due with the move, or not before it."""
        if aged is not None:
            self._ties.append(Tie(self._step, aged.since, aged.age))
            if aged.until is not None:
                self._ties.append(Tie(self._step, aged.until, 0, aged.age))
        for key, (origin, offset), duration in self._pending():
            is_it = key == (move.kind if move.kind[0] in ("time", "timer") else ())
            if not is_it:
                self._ties.append(before(self._step, origin, offset + duration))
            elif aged is None:
                self._ties.append(just(self._step, origin, offset + duration))

    def _keep_assumed(self, move: Move) -> None:
        """A message takes as long, and an activity lasts as long, as is assumed."""
        match move.kind:
            case ("end", agent, label):
                found = self._execution(agent, label)
                since, bounds = found.started, self._explored.lasts(found)
            case ("arrive", *_):
                item = cast("Underway", _argument(move))
                since, bounds = item.sent, self._explored.on_the_way(item)
            case _:
                return
        if bounds is not None:
            self._ties.append(Tie(self._step, _step_of(since), *bounds))

    def _keep_joined(self) -> None:
        """What has come with something else takes as long as is assumed, too."""
        for item in self._explored.joined:
            bounds = self._explored.on_the_way(item)
            if bounds is not None:
                self._ties.append(Tie(self._step, _step_of(item.sent), *bounds))

    def _await_assumed(self) -> None:
        """What is on its way at the end, and runs there, may still come in time."""
        explored = self._explored
        found = [(item.started, explored.lasts(item)) for item in explored.driver.running]
        found += [
            (item.sent, explored.on_the_way(item))
            for waiting in explored.ways.ways.values()
            for item in waiting
            if item not in self._overtaken
        ]
        for since, bounds in found:
            if bounds is not None and bounds[1] is not None:
                self._ties.append(Tie(self._step, _step_of(since), 0, bounds[1]))

    def _tie_age(self) -> None:
        """What has come in this move is as old as was decided."""
        for came in self._explored.came:
            if not isinstance(came.since, _Marked):
                continue
            if came.least:
                self._ties.append(just(self._step, came.since.step, came.least))
            elif came.until is not None:
                self._ties.append(before(self._step, came.since.step, came.until + 1))

    def _note_origins(self) -> None:
        """Since which move the times run that run now."""
        explored = self._explored
        there: set[tuple[str, ...]] = set()
        for agent in explored.agents:
            if agent.over or agent.down:
                continue
            chart = agent.chart
            for label, slot in chart.TIMES.items():
                self._origin(("state", agent.name, label), getattr(chart, slot), there)
            for board in chart.boards():
                if board is None:
                    continue
                for name, due in board.timers.items():
                    self._origin(("timer", agent.name, name), due, there)
                for channel, senders in board._states.items():
                    for item in senders.values():
                        key = ("message", agent.name, channel, *map(str, item.identity))
                        content = content_of(item.message)
                        if content is not None and content.number in self._anew and item.time == NOW:
                            self._origins.pop(key, None)
                        self._origin(key, item.time, there)
                for channel, items in board._signals.items():
                    for item in items:
                        key = ("message", agent.name, channel, *map(str, item.identity))
                        self._origin(key, item.time, there)
        for timer in explored.driver.timers:
            if timer.call is not None:
                self._origin(("pause", str(id(timer))), timer.moment, there)
        for key in [key for key in self._origins if key not in there]:
            del self._origins[key]

    def _origin(self, key: tuple[str, ...], moment: int, there: set[tuple[str, ...]]) -> None:
        there.add(key)
        if isinstance(moment, _Marked):
            self._origins.setdefault(key, (moment.step, 0))
            if self._origins[key][0] < moment.step:
                self._origins[key] = (moment.step, 0)
        else:
            self._origins.setdefault(key, (self._step, 0))

    def _pending(self) -> Iterator[tuple[tuple[str, ...], tuple[int, int], int]]:
        """What may pass now, with the move from which on it is counted, and how long it takes."""
        explored = self._explored
        for agent in explored.agents:
            if agent.over or agent.down:
                continue
            for item in passing(agent.chart, {}):
                if item.what == "state" and explored.matters(agent.name, item.name):
                    origin = self._origins["state", agent.name, item.name]
                    yield ("time", agent.name, "state", item.name), origin, item.duration
            yield from self._of_boards(agent)
        for timer in explored.driver.timers:
            if timer.call is not None:
                yield ("timer",), self._origins["pause", str(id(timer))], timer.moment - NOW

    def _of_boards(self, agent: Agent) -> Iterator[tuple[tuple[str, ...], tuple[int, int], int]]:
        thresholds = thresholds_of(agent.plan)[0]
        for board in agent.chart.boards():
            if board is None:
                continue
            for name, due in board.timers.items():
                if due > NOW:
                    origin = self._origins["timer", agent.name, name]
                    yield ("time", agent.name, "timer", name), origin, int(due) - NOW
            for channel, ages in thresholds.items():
                for item in board._states.get(channel, {}).values():
                    older = next_age(NOW - item.time, ages)
                    if older is not None:
                        key = ("message", agent.name, channel, *map(str, item.identity))
                        yield ("time", agent.name, "message", channel), self._origins[key], older
            for channel, longest in board.EXPIRES.items():
                for item in board._signals.get(channel, ()):
                    if NOW - item.time < longest:
                        key = ("message", agent.name, channel, *map(str, item.identity))
                        yield ("time", agent.name, "signal", channel), self._origins[key], longest


def _step_of(moment: int) -> int:
    """The move in which a moment was read; the beginning, if none is known."""
    return moment.step if isinstance(moment, _Marked) else 0


def _argument(move: Move) -> object:
    """What a move is about that something on its way makes."""
    assert isinstance(move.do, partial)
    return move.do.args[-1]


def _what(item: Underway) -> str:
    """What is on its way, as a scenario says it."""
    if item.kind != "mail":
        return item.what
    given = item.give.args if isinstance(item.give, partial) else ()
    acl = next((part for part in given if isinstance(part, AclMessage)), None)
    return item.what if acl is None else f"{acl.performative} {acl.message}".rstrip()


__all__ = [
    "Acts",
    "Arrives",
    "Comes",
    "Content",
    "Crash",
    "Event",
    "Gives",
    "Happening",
    "NotRetraced",
    "Retraced",
    "renewals",
    "retrace",
]
