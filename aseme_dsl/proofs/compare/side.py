"""Side: one version of a role in a run, and what is seen of it from outside."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import field

from aseme_dsl.proofs.compare.decisions import Decisions, Open
from aseme_dsl.proofs.compare.normal import Gone, Key, normal
from aseme_dsl.proofs.compare.staging import Stage, Version, staged
from aseme_dsl.proofs.compare.unread import Unread, decided
from aseme_dsl.proofs.explore.deciding.staging import writable
from aseme_dsl.proofs.explore.relevant import Relevant
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import (
    LOST,
    Addressed,
    AgentMessage,
    Cancel,
    Input,
    Left,
    Outcome,
    Publication,
    Sample,
    Sending,
    Start,
)
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan, is_in
from aseme_dsl.runtime.chart.saving import Saved
from aseme_dsl.runtime.message.as_json import to_json

SETTLES = 50
"""What makes so many steps at one moment goes round in circles."""


@dataclass(frozen=True, slots=True)
class Running:
    """An activity that runs in a state."""

    activity: str
    arguments: str
    label: str
    token: int

    @property
    def name(self) -> str:
        return f"{self.activity}{self.arguments}"


@dataclass(frozen=True, slots=True, order=True)
class Seen:
    """Something that is seen from outside: two are alike if these fields are equal."""

    kind: str
    what: str
    number: int = 0
    """Which one it is of those whose order matters: what is said on one channel, or to one participant."""
    at: str = field(default="", compare=False)
    """Where the line stands that does it."""

    @property
    def subject(self) -> str:
        """What it is about, without the content of what is said."""
        return f"{self.kind} {self.what.partition(' {')[0]}"

    @property
    def text(self) -> str:
        words = {"start": "starts", "stop": "stops", "publish": "publishes", "send": "sends"}
        return f"{words[self.kind]} {self.what}" if self.kind in words else self.what


@dataclass(frozen=True, slots=True)
class Stand:
    """The state of a version between two moves."""

    saved: Saved
    running: tuple[Running, ...]


class Side:
    """One version, whose next step can be made."""

    def __init__(self, version: Version, agent: str, decisions: Decisions, channels: frozenset[str]) -> None:
        self.stage = Stage(version, decisions, channels)
        self.chart = staged(version, agent, self.stage)
        self.plan: Plan = self.chart.PLAN
        self.running: tuple[Running, ...] = ()
        self.contexts = {state.label: _context(self.plan, state.label) for state in self.plan.states}
        self._relevant = Relevant(self.plan, frozenset())
        self._held = {
            f"held_{slot}" if hasattr(self.chart, f"held_{slot}") else slot: version.name(
                name.partition("@")[0]
            )
            for name, slots in self.chart.VARIABLES.items()
            for slot in slots
        }
        """The slots that hold the variables."""
        self._named = 0
        self.frozen: frozenset[str] = frozenset()
        """The regions whose activities need not end."""
        self.longest = 0
        """The longest time, in ns, that either version waits for."""
        self.ages: Mapping[str, int] = {}
        """From which age on it makes no difference to either version how old a message of a channel is."""

    def stand(self) -> Stand:
        return Stand(self.chart.save(), self.running)

    def take_back(self, stand: Stand) -> None:
        self.chart.load(stand.saved)
        self.running = stand.running

    @property
    def is_over(self) -> bool:
        return self.chart.finished or self.chart.failure is not None

    def due(self) -> int | None:
        """When time alone may bring something, after now."""
        if not self.chart.started or self.is_over:
            return None
        return self.chart.due(self.chart.now)

    # ---- moves -------------------------------------------------------------------------------

    def make(self, now: int, inputs: Iterable[Input]) -> tuple[Seen, ...]:
        """Step until nothing is left to do at this moment; what is seen of it."""
        found = _Found(self.plan)
        waiting = list(inputs)
        self.stage.begin(now)
        for _ in range(SETTLES):
            if self.is_over:
                break
            held = waiting if self.chart.raised else []  # an event that a line has raised comes alone
            outcome = self.chart.step(now, [] if held else waiting)
            waiting = [*held, *self._follow(now, outcome, found)]
            self.chart.woken = self.chart.drains = False
            if not (waiting or outcome.again):
                break
        else:
            found.add("circle", "goes round in circles at one moment")
        self.stage.now = None
        return found.done()

    def _follow(self, now: int, outcome: Outcome, found: _Found) -> list[Input]:
        """Carry out what a step asks for; the result is what comes back at once."""
        found.step(outcome)
        back: list[Input] = []
        cancelled = {item.token for item in outcome.of(Cancel)}
        begun: list[Running] = []
        for effect in outcome.effects:
            match effect:
                case Start() if effect.token not in cancelled:
                    begun.append(self._start(effect, found))
                case Cancel():
                    self._stop(effect, found)
                case Publication():
                    back += self._publish(now, effect, found)
                case Sending():
                    back += self._send(effect, found)
                case Left(branch, completed):
                    info = self.branch(branch)
                    text = "completes" if completed else "leaves before its end"
                    found.add("part", f"{text} its part {self.stage.version.part_of(info)}")
                case _:
                    pass
        self.running += tuple(sorted(begun, key=lambda item: (item.name, self.contexts[item.label])))
        if outcome.failure is not None:
            found.add("fail", "fails")
        elif outcome.finished:
            found.add("end", "ends")
        self._refuse(found)
        return back

    def _start(self, effect: Start, found: _Found) -> Running:
        known = self.stage.decisions.made
        given = ", ".join(shown(decided(value, known)) for _, value in effect.arguments)
        arguments = f"({given})" if effect.arguments else ""
        activity = self.stage.version.name(effect.activity)
        item = Running(activity, arguments, effect.label, effect.token)
        may = self._may_send(effect.label)
        found.add("start", item.name + (f", which may send {may}" if may else ""), effect.label)
        return item

    def _may_send(self, label: str) -> str:
        branch = self.plan.branch_of(label)
        if branch is None:
            return ""
        moves = self.branch(branch).moves
        return ", ".join(
            sorted(f"{move[0]} {move[1]}" for move in moves if any(is_in(label, state) for state in move[2]))
        )

    def _stop(self, effect: Cancel, found: _Found) -> None:
        item = next((item for item in self.running if item.token == effect.token), None)
        if item is not None:
            self.running = tuple(other for other in self.running if other is not item)
            found.add("stop", item.name)

    def _publish(self, now: int, effect: Publication, found: _Found) -> list[Input]:
        message = decided(effect.message, self.stage.decisions.made)
        to = "" if effect.host is None else f" to {effect.host}"
        found.say("publish", f"{effect.channel}{to}", shown(message))
        is_own = effect.channel in self.chart.READERS and effect.host in (None, self.chart.agent)
        if not is_own or effect.channel in self.stage.open:
            return []
        self._named += 1
        me = self.chart.agent
        return [Sample(effect.channel, message, me, now, (me, self._named), effect.region)]

    def _send(self, effect: Sending, found: _Found) -> list[Input]:
        part = self.stage.version.part(effect.participant)
        to = effect.to or f"{'one ' if effect.one else ''}{part}"
        if effect.excepts:
            to += f" except {', '.join(sorted(effect.excepts))}"
        content = shown(decided(effect.content, self.stage.decisions.made)) if effect.filled else ""
        found.say("send", f"{effect.performative} {effect.message} to {to}", content, effect.way)
        if (effect.branch, effect.participant) not in self.plan.counted:
            return []
        self._named += 1
        agents = tuple(name for name in self.others(effect.branch, effect.participant))
        kept = tuple(name for name in agents if name not in effect.excepts and effect.to in (None, name))
        return [Addressed(effect.branch, effect.participant, kept, f"m{self._named}")]

    def _refuse(self, found: _Found) -> None:
        """Refuse what waits and nothing takes any more."""
        for branch, waiting in self.chart.mail.items():
            refused = [item for item in waiting if not self.takes(item)]
            if refused and self.is_in_branch(branch):
                self.chart.mail[branch] = tuple(item for item in waiting if item not in refused)
                for item in refused:
                    found.add("refuse", f"answers {item.performative} {item.message} with not_understood")

    def write(self, label: str, number: int) -> None:
        """The activity of a state writes its variables: what, is decided when it is read."""
        for name in writable(self.plan, label):
            variable = self.plan.variable_of(name, label)
            if not variable.type.startswith("list of "):
                self.chart.set_variable(variable.name, Open(number))

    def opened(self) -> list[int]:
        """The numbers of what was written and not read, in a fixed order."""
        held = (getattr(self.chart, slot) for slot in self._held)
        return [value.number for value in held if isinstance(value, Open)]

    def renumber(self, numbers: Mapping[int, int]) -> None:
        """Give what was written and not read other numbers."""
        for slot in self._held:
            value = getattr(self.chart, slot)
            if isinstance(value, Open):
                setattr(self.chart, slot, Open(numbers[value.number]))

    def take_over(self, made: Mapping[object, object]) -> None:
        """Keep what was decided in a move, and forget what can make no difference any more."""
        for slot, name in self._held.items():
            value = getattr(self.chart, slot)
            if isinstance(value, Open):
                question = ("variable", name, value.number)
                if question in made:
                    setattr(self.chart, slot, self.stage.as_own(made[question]))
            elif isinstance(value, Unread | tuple):
                setattr(self.chart, slot, decided(value, made))
        for board in self.chart.boards():
            for members in board.drafts.values() if board is not None else ():
                members.update({path: decided(value, made) for path, value in members.items()})
        if self.chart.started and not self.is_over:
            self._relevant.forget(self.chart, Gone.GONE)

    def place(self) -> Key:
        """Where it is, without what it knows."""
        return (*self.chart.configuration(), *(item.label for item in self.running))

    def key(self) -> Key:
        """What of its state can make a difference."""
        names = tuple((item.name, item.label) for item in self.running)
        return (names, *normal(self.chart, self.longest, self.ages))

    # ---- questions ---------------------------------------------------------------------------

    def branch(self, label: str) -> BranchInfo:
        return next(info for info in self.plan.branches if info.label == label)

    def is_in_branch(self, branch: str) -> bool:
        return any(is_in(leaf, branch) for leaf in self.chart.configuration())

    def others(self, branch: str, participant: str) -> tuple[str, ...]:
        """The agents that play a participant."""
        several = self.branch(branch).size_of(participant)[1] != 1
        name = self.stage.version.part(participant)
        return (f"{name}1", f"{name}2") if several else (name,)

    def takes(self, item: AgentMessage) -> bool:
        """Whether its branch can take an agent message now or later."""
        if item.performative == LOST:
            return True
        within = f"{item.branch}."
        kind = item.performative, item.message
        for leaf in self.chart.configuration():
            if leaf.startswith(within):
                taken = self.plan.taken_from(item.branch, leaf)
                if (*kind, item.participant) in taken or (*kind, "") in taken:
                    return True
        return False


class _Found:
    """Gathers what is seen in a move."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._seen: list[Seen] = []
        self._ways: list[tuple[int, ...]] = []
        self._said: Counter[str] = Counter()

    def step(self, outcome: Outcome) -> None:
        self._ways += [tuple(way) for way in outcome.taken]

    def add(self, kind: str, what: str, label: str = "") -> None:
        """Something whose order among others does not matter."""
        self._seen.append(Seen(kind, what, 0, self._place(label)))

    def say(self, kind: str, to: str, content: str, way: tuple[int, ...] = ()) -> None:
        """Something that is said, after what was said there before."""
        number = self._said[f"{kind} {to}"]
        self._said[f"{kind} {to}"] += 1
        at = _line(self._plan, way or self._publishing(to.partition(" ")[0]))
        self._seen.append(Seen(kind, f"{to} {content}".rstrip(), number, at))

    def _place(self, label: str) -> str:
        """The line of the last transition that leads to a state; without one, of the last one."""
        if label:
            ends = ((way, self._plan.transitions[way[-1]].targets) for way in self._ways)
            fits = [way for way, targets in ends if any(is_in(label, target) for target in targets)]
        else:
            fits = [way for way in self._ways if any(self._plan.transitions[n].text for n in way)]
        found = fits or self._ways
        return _line(self._plan, found[-1]) if found else ""

    def _publishing(self, channel: str) -> tuple[int, ...]:
        """The last transition that publishes on a channel."""
        return next(
            way
            for way in reversed(self._ways)
            if any(("publish", channel) == a[:2] for n in way for a in self._plan.transitions[n].actions)
        )

    def done(self) -> tuple[Seen, ...]:
        return tuple(sorted(self._seen))


def _line(plan: Plan, way: tuple[int, ...]) -> str:
    """The place of the line that a compound transition has, and what it says; without one, of the formula."""
    items = [plan.transitions[number] for number in way]
    item = next((item for item in items[::-1] if item.text), items[-1])
    text = " ".join(item.text.split())
    return f"{item.at}: {text}" if text else item.at


def shown(value: object) -> str:
    """A value for readers."""
    if hasattr(type(value), "__dataclass_fields__"):
        data = to_json(value)
        assert isinstance(data, dict)
        inside = ", ".join(f"{name} = {_plain(item)}" for name, item in data.items())
        return f"{{ {inside} }}"
    try:
        return _plain(to_json(value))
    except TypeError:
        return str(value)


def _plain(data: object) -> str:
    if isinstance(data, dict):
        return f"{{ {', '.join(f'{name} = {_plain(item)}' for name, item in data.items())} }}"
    return (
        f'"{data}"' if isinstance(data, str) else str(data).lower() if isinstance(data, bool) else str(data)
    )


def _context(plan: Plan, label: str) -> tuple[str, ...]:
    """The names of the states around a state, outermost first, but for those that are only places."""
    found: list[str] = []
    state = plan.by_label[label]
    while state.parent is not None:
        state = plan.by_label[state.parent]
        if state.branch is not None or state.name.isidentifier():
            found.append(state.branch or state.name)
    return tuple(found[::-1])


__all__ = ["Running", "Seen", "Side", "Stand", "shown"]
