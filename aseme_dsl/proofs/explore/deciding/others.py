"""Others: agents beside the only one that is explored, of which nothing is known but what they may say.

When the agent looks for an agent message, there is one of any of them, with anything in it, or there is none.
What is not taken then is forgotten: it may be there again at the next look. How many have answered may be any
number at each look, too. What the agent says to others makes no difference. So all that an agent does in a
team, it does among such others.

A message that is there when a step comes to rest could as well come right after it: that is a move of its
own, the *look*. So within a step, a message comes only before a transition that is taken. Of several that
come together, one is taken; then the agent may pause, and looks again before it continues.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import cast

from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.later import Contents
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import LOST, REASONS, AgentMessage, Identity, Input, Outcome
from aseme_dsl.runtime.chart.plan import BranchInfo, terms_of
from aseme_dsl.runtime.conversation.conversation import Conversations
from aseme_dsl.runtime.conversation.participation import Participation
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD, AclMessage


class NothingNew(BaseException):
    """The same happens as in another way to make the move. Agents do not catch it as an Exception."""


Kind = tuple[str, str, str]
"""The performative and type of an agent message, and the participant whose it is."""


@dataclass(frozen=True, slots=True)
class Coming:
    """What may come from others next: its kind, what is said of it, and what it does."""

    kind: tuple[str, ...]
    text: str
    do: Callable[[], None]


class _Pause(BaseException):
    """A step ends before its round has done anything. Only `round` sees it."""


class Others:
    """What others do to the agent that is explored."""

    def __init__(self, conversations: Conversations, choices: Choices, contents: Contents) -> None:
        self._others: Sequence[Agent] = ()
        self._conversations = conversations
        self._members = conversations._members
        self._choices = choices
        self._contents = contents
        self._is_look = False
        """Whether the present move is made since a message may be there."""
        self._taken = 0
        """How many transitions former steps of the move have taken."""
        self._before = 0
        """How many the present step had taken when its round began."""
        self._asked = 0
        self._saying: dict[tuple[str, Kind], tuple[str, ...]] = {}
        """Who may say what to a branch."""
        self._came: set[tuple[str, Kind]] = set()
        """Who has said what in the present move."""
        self._lent: set[Identity] = set()
        """Which messages these are."""
        self._later: list[tuple[int, int]] = []
        """The decisions of the move that no message is there, or not to pause. Each stands with the number of
        transitions before it: if none follow, what comes could as well come after the move."""
        self._without: set[tuple[str, Kind]] = set()
        """Of which kinds there is no message in the present round."""
        self._goes_on = False
        """Whether that was decided in the present round."""
        self._again: list[int] = []
        """How many transitions had been taken when a second message of a kind and sender might have come."""
        self.paused: list[bool] = [False]
        """Whether the agent has paused in the midst of a step."""
        self.differ: Callable[[Sequence[str], Collection[str]], Sequence[str]] = lambda names, came: names
        """Those of some agents with which a move is not the same, if others have `come` in it."""
        self.is_bounded = False
        """Whether one agent may have said the same twice at one moment, which is not looked at."""
        self.matters: Callable[[str, str], bool] = lambda name, label: True
        """Whether a state of the agent matters to what is asked: elsewhere, nothing comes."""

    agent: Agent
    """The only one that is explored."""

    @property
    def agents(self) -> Sequence[Agent]:
        """The agents beside the one that is explored."""
        return self._others

    @property
    def busy(self) -> frozenset[str]:
        """Those of whom more is known than that they are there."""
        desks = ((other.name, self._members.desks[other.name]) for other in self._others)
        return frozenset(name for name, desk in desks if desk.branches or desk.free or desk.invitations.size)

    def meet(self, agent: Agent, others: Sequence[Agent]) -> None:
        """These are others to the agent that is explored."""
        self.agent = agent
        self._others = others
        self._asks_for_reason = ("reason",) in terms_of(agent.plan)

    @property
    def has_come(self) -> bool:
        """Whether a message of others has come in the present move."""
        return bool(self._came)

    def begin(self) -> None:
        """A move is made."""
        self._is_look = self._goes_on = False
        self._taken = self._before = self._asked = 0
        for known in (self._came, self._lent, self._later, self._again):
            known.clear()
        self.paused[0] = False

    def close(self) -> None:
        """The move is made: what could as well come after it need not be tried."""
        for place, taken in self._later:
            if taken == self._taken:
                self._choices.close(place)
        self.is_bounded = self.is_bounded or any(taken < self._taken for taken in self._again)

    def channels(self, bus: Bus) -> frozenset[str]:
        """The channels on which something of others may come to the agent."""
        return frozenset(
            channel
            for other in self._others
            for channel in bus._routes._writes.get(other.name, ())
            if channel in self.agent.chart.READERS
            and self.agent.name in bus._routes.receivers(other.name, channel).names
        )

    @property
    def left_out(self) -> str:
        """What of others is not looked at; empty if nothing is."""
        for term in terms_of(self.agent.plan):
            match term:
                case ("member", str(), channel, *_):
                    return f"{self.agent.role} asks who has sent {channel}"
                case _:
                    pass
        codes = (getattr(method, "__code__", None) for method in vars(type(self.agent.chart)).values())
        if any(code is not None and "since" in code.co_names for code in codes):
            return f"{self.agent.role} asks how old an agent message is"
        return ""

    # ---- what may come next ------------------------------------------------------------------

    def moves(self) -> Iterator[Coming]:
        """What may come now."""
        if self.agent.over or self.agent.down:
            return
        branches = self._members.desks[self.agent.name].branches
        for label, place in () if self.paused[0] else branches.items():
            if place.conversation is None and not place.suspended and self._matters(place):
                for other, info in self._opening(place.info):
                    for performative, message in dict.fromkeys(info.sends):
                        if (performative, message) in place.info.opens:
                            kind = ("other", "begin", label, other.name, info.participant, message)
                            text = f"{self.agent.name} gets {performative} {message} of {other.name}"
                            begin = partial(self._begin, label, other, info, performative, message)
                            yield Coming(kind, text, begin)
        if self.paused[0]:
            yield Coming(("continue",), f"{self.agent.name} continues", self.agent.begin)
        if any(place.conversation is not None and self._matters(place) for place in branches.values()):
            yield Coming(("other", "look"), f"{self.agent.name} looks for messages", self._look)

    def _look(self) -> None:
        self._is_look = True
        self.agent.begin()

    def _opening(self, own: BranchInfo) -> Iterator[tuple[Agent, BranchInfo]]:
        """Who may begin a conversation with a branch, and as what."""
        for _, players in self._players(own):
            yield from ((other, info) for other, info in players if set(info.sends) & set(own.opens))

    def _players(self, own: BranchInfo) -> Iterator[tuple[str, list[tuple[Agent, BranchInfo]]]]:
        """The others that play each participant which may talk to a branch."""
        for participant, *_ in own.participants:
            if participant == own.participant and _is_one(own, participant):
                continue
            found = [
                (other, info)
                for other in self._others
                for info in other.plan.branches
                if (info.protocol, info.participant) == (own.protocol, participant)
            ]
            yield participant, found

    def _begin(self, label: str, other: Agent, info: BranchInfo, performative: str, message: str) -> None:
        agent, conversations = self.agent, self._conversations
        own = self._members.desks[agent.name].branches[label].info
        name = self._members.begin(info.protocol, other.name, conversations._sending._life)
        self._members.conversations[name].members[info.participant] = [other.name]
        content = self._contents.new(message, ("said", 0), "with {}", f"{other.name}: {message}")
        acl = AclMessage(
            performative,
            other.name,
            (agent.name,),
            message,
            content,
            info.protocol,
            name,
            info.participant,
            own.participant,
            other.identity(),
            info.version,
            other.plan.system,
        )
        conversations._delivery.deliver(agent, acl)

    # ---- what the chart looks for ------------------------------------------------------------

    def methods(self, own: Mapping[str, object]) -> dict[str, object]:
        """The methods of the chart that look for messages, beside its `own`."""
        make = cast("Callable[[Chart], bool]", own["round"])
        return {
            "round": lambda chart: self._round(chart, make),
            "step": lambda chart, now, inputs: self._step(chart, now, inputs),
            "letters": lambda chart, branch, kinds: self._letters(chart, branch, kinds),
            "waiting_mail": lambda chart, branch, *kind: self._waiting(chart, branch, kind),
            "invited": lambda chart, branch, part: self._count(branch, part, "invited"),
            "answered": lambda chart, branch, part: self._count(branch, part, "answered"),
            "all_answered": lambda chart, branch, part: self._decided(
                branch, ("all answered", branch, part), (False, True), f"all_answered({part}) is {{}}"
            ),
        }

    def _round(self, chart: Chart, make: Callable[[Chart], bool]) -> bool:
        if self.paused[0]:
            return False
        self._before = len(chart.taken)
        self._goes_on = False
        self._without.clear()
        try:
            again = make(chart)
        except _Pause:
            self.paused[0] = True
            return False
        if self._has_lent(chart):  # it could as well not be there
            raise NothingNew
        return again

    def _step(self, chart: Chart, now: int, inputs: Iterable[Input]) -> Outcome:
        outcome = Chart.step(chart, now, inputs)
        self._taken += len(outcome.taken)
        return outcome

    def _has_lent(self, chart: Chart) -> bool:
        """Whether a message has come that was not taken yet."""
        return any(item.identity in self._lent for waiting in chart.mail.values() for item in waiting)

    def _letters(self, chart: Chart, branch: str, kinds: Iterable[Kind]) -> Iterator[AgentMessage]:
        for kind in kinds:
            yield from self._found(chart, branch, kind)

    def _waiting(self, chart: Chart, branch: str, kind: Kind) -> AgentMessage | None:
        return next(iter(self._found(chart, branch, kind)), None)

    def _found(self, chart: Chart, branch: str, kind: Kind) -> Sequence[AgentMessage]:
        """The messages of a kind that are there: one that was seen in this step, or may come now."""
        known = [
            item for item in chart.mail[branch] if (item.performative, item.message, item.participant) == kind
        ]
        if known or (branch, kind) in self._without or self._has_lent(chart):
            return known
        place = self._members.desks[self.agent.name].branches.get(branch)
        senders = () if place is None else tuple(self._senders(place, kind))
        if place is None or not senders or not self._matters(place):
            return ()
        taken = self._taken + len(chart.taken)
        is_passing = _is_passing(chart)
        if self._came and len(chart.taken) == self._before and not is_passing:
            self._may_pause(taken)
            return ()
        left = tuple(name for name in senders if (name, kind) not in self._came)
        if len(left) < len(senders):
            self._again.append(taken)
        if not left:
            return ()
        left = tuple(self.differ(left, {name for name, _ in self._came}))
        self._asked += 1
        number = self._choices.place
        performative, message, participant = kind
        text = f"{performative} {message}".strip()
        text = f"{self.agent.name} has {text} of {{}}"
        sender = self._choices.of(("comes", self._asked), (None, *left), text)
        if sender is None:
            self._without.add((branch, kind))
            if not is_passing and not (self._is_look and taken == 0):
                self._later.append((number, taken))
            return ()
        self._came.add((sender, kind))
        identity, content = self.agent.identity(), self._content(kind, sender)
        item = AgentMessage(branch, performative, message, content, participant, sender, identity)
        self._lent.add(identity)
        chart.mail[branch] += (item,)
        place.waiting[identity] = item
        return (item,)

    def _may_pause(self, taken: int) -> None:
        """What comes before a round may come while the agent pauses: then it looks for it."""
        if self._goes_on:
            return
        self._asked += 1
        place = self._choices.place
        if self._choices.of(("pause", self._asked), (None, True)):
            raise _Pause
        self._goes_on = True
        self._later.append((place, taken))

    def _matters(self, place: Participation) -> bool:
        return self.matters(self.agent.name, place.info.label)

    def _senders(self, place: Participation, kind: Kind) -> Iterator[str]:
        """Who may have sent a message of a kind."""
        conversation = self._members.of(place)
        if conversation is None:
            return
        key = place.info.label, kind
        if key not in self._saying:
            self._saying[key] = tuple(self._who_says(place.info, kind))
        participant = kind[2]
        known = conversation.members.get(participant, ()) if _is_one(place.info, participant) else ()
        yield from (name for name in self._saying[key] if not known or name in known)

    def _who_says(self, own: BranchInfo, kind: Kind) -> Iterable[str]:
        """The others that may say something to a branch."""
        performative, message, participant = kind
        return dict.fromkeys(
            other.name
            for part, players in self._players(own)
            for other, info in players
            if part == participant
            and (performative in (LOST, NOT_UNDERSTOOD) or (performative, message) in info.sends)
        )

    def _content(self, kind: Kind, sender: str) -> object:
        performative, message, _ = kind
        if performative == LOST:
            reasons = REASONS if self._asks_for_reason else REASONS[:1]
            return self._choices.of(("reason", self._asked), reasons, f"{sender}: {{}}")
        question = ("said", self._asked)
        return self._contents.new(message, question, "with {}", f"{sender}: {message}")

    def _count(self, branch: str, participant: str, what: str) -> int:
        place = self._members.desks[self.agent.name].branches.get(branch)
        players = {} if place is None else dict(self._players(place.info))
        most = len({other.name for other, _ in players.get(participant, ())})
        text = f"{what}({participant}) is {{}}"
        return self._decided(branch, (what, branch, participant), range(most + 1), text)

    def _decided(self, branch: str, question: tuple[str, ...], answers: Sequence[int], text: str) -> int:
        if not self.matters(self.agent.name, branch):
            return answers[0]
        self._asked += 1
        return self._choices.of((*question, self._asked), answers, text, is_of_others=True)

    # ---- what makes no difference ------------------------------------------------------------

    def forget(self) -> None:
        """Forget what the conversations of the agent remember of others."""
        members = self._members
        desk = members.desks[self.agent.name]
        desk.returned.clear()
        inside: dict[str, BranchInfo] = {}
        for place in desk.branches.values():
            for known in (place.taken, place.answered, place.said, place.told, place.spoken):
                known.clear()
            place.farewell = frozenset()
            place.was_full = False
            if place.conversation is not None:
                inside[place.conversation] = place.info
        for name in [name for name in members.conversations if name not in inside]:
            del members.conversations[name]
        members.over.clear()
        for name, info in inside.items():
            conversation = members.conversations[name]
            conversation.past.clear()
            # Who has begun it is known; of those that the agent has chosen, others may be there instead.
            chosen = {part for part in conversation.members if not _is_one(info, part)} | conversation.chosen
            for part in chosen & conversation.members.keys():
                del conversation.members[part]
            conversation.chosen.clear()
        self._conversations._sending._choosing._addressed.clear()
        self.agent.chart.rounds.load(())


def _is_one(info: BranchInfo, participant: str) -> bool:
    return info.size_of(participant)[1] == 1


def _is_passing(chart: Chart) -> bool:
    """Whether something in a step is not there after it."""
    asked = (board.asked for board in chart.boards() if board is not None)
    return bool(chart.writes or chart.events or chart.raised) or any(map(bool, asked))


__all__ = ["Coming", "Others"]
