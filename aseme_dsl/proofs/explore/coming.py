"""Coming: what comes to agents from outside, and from their own activities, when something looks for it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Container, Iterator, Mapping, Sequence
from functools import cached_property

from aseme_dsl.proofs.explore.alone import Alone
from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.later import Content, Contents, Later, content_of
from aseme_dsl.proofs.explore.deciding.staging import by_lines_of, copied
from aseme_dsl.proofs.explore.needed import Needed
from aseme_dsl.proofs.explore.reducing.faded import faded_in
from aseme_dsl.proofs.explore.surroundings import NOW
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.channel.bus import Bus
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.inputs import Sample


class Coming:
    """The channels of a team on which a new message may come whenever an agent steps.

    These are states and data from outside, and those that its own activities publish for it alone. Such a
    message needs no step of its own: several may come at one moment, with what the agent steps for.
    """

    def __init__(
        self,
        agents: Sequence[Agent],
        bus: Bus,
        choices: Choices,
        contents: Contents,
        later: Later,
        of_modules: Collection[str],
        told: Collection[str],
        is_asked: Callable[[str], bool],
        has: Mapping[str, Mapping[str, Mapping[tuple[str, ...], object]]],
        alone: Alone | None = None,
        is_timed: bool = False,
        of_others: frozenset[str] = frozenset(),
    ) -> None:
        """Modules publish on the channels `of_modules`. Of messages of the types `told`, something else asks
        what they say, or when they come; `is_asked` says whether anything but activities asks for those of a
        channel. `has` says what their members hold, by agent and channel, as far as that is known. Agents
        that are not explored publish on the channels `of_others`."""
        self._agents = agents
        self._bus = bus
        self._choices = choices
        self._contents = contents
        self._later = later
        self._of_modules = frozenset(of_modules)
        self._plans = list({agent.role: agent.plan for agent in agents}.values())
        self._kept = frozenset(told).union(*map(copied, self._plans))
        timeless = not is_timed and alone is None
        self._faded = {plan.name: faded_in(plan) if timeless else {} for plan in self._plans}
        self._is_asked = is_asked
        self._has = has
        self._alone = alone
        self._is_timed = is_timed
        self._of_others = of_others
        self.needed: Needed | None = None
        """The regions that matter, if not all do."""
        self._may_come: dict[str, set[str]] = {}
        """The channels, by agent, of which a message may have come in the next move."""
        self._is_open = False
        """Whether a move is made now."""

    def writers(self) -> Mapping[str, frozenset[str]]:
        """The agents that may publish on each channel."""
        found: dict[str, set[str]] = {}
        for name, channels in self._bus._routes._writes.items():
            for channel in channels:
                found.setdefault(channel, set()).add(name)
        return {channel: frozenset(names) for channel, names in found.items()}

    def reaches(self, writer: str, reader: str, channel: str) -> bool:
        """Whether what a role publishes on a channel comes to agents of another, or to itself."""
        readers = {agent.name for agent in self._agents if agent.role == reader}
        return self._alone is None and any(
            readers.intersection(self._bus._routes.receivers(agent.name, channel).names)
            for agent in self._agents
            if agent.role == writer
        )

    # ---- which they are ----------------------------------------------------------------------

    @cached_property
    def inputs(self) -> Mapping[str, tuple[str, ...]]:
        """The channels, by agent, on which messages come from outside: it reads them, and no agent publishes
        there. What modules publish is such an input, too."""
        return {agent.name: self._inputs(agent) for agent in self._agents}

    def _inputs(self, agent: Agent) -> tuple[str, ...]:
        writers = self.writers()
        rules = {info.name: info for info in agent.plan.channels}
        return tuple(
            channel
            for channel in agent.chart.READERS
            if channel in rules
            and self._is_asked(channel)
            and (
                self._alone is not None
                or channel not in writers
                or channel in self._of_others
                or channel in self._of_modules
                or rules[channel].is_from_outside
            )
            and (self.needed is None or channel in self.needed.reads[agent.role])
        )

    @cached_property
    def brief(self) -> Mapping[str, Mapping[str, frozenset[str]]]:
        """The channels, by agent, with its activities that publish there; none for an input."""
        within: set[str] = set()
        if self._alone is None:
            within.update(channel for plan in self._plans for i in plan.activities for channel in i.writes)
            within -= self._of_others
            within.update(*map(by_lines_of, self._plans))
        return {
            agent.name: {
                **{
                    channel: frozenset[str]()
                    for channel in self.inputs[agent.name]
                    if channel not in within and self._is_brief(channel)
                },
                **self.own(agent),
            }
            for agent in self._agents
        }

    @cached_property
    def standing(self) -> Mapping[str, frozenset[str]]:
        """The channels of `brief`, by agent, for which a message that may say anything stands while one may
        come: whether one has come makes no difference.

        That is so where nothing can tell absence (see `absence`). A channel is looked at by its newest
        message of all senders alone.
        """
        return {agent.name: frozenset(self._standing(agent)) for agent in self._agents}

    def _standing(self, agent: Agent) -> Iterator[str]:
        if self._alone is not None or self._is_timed:
            return
        for channel in self.brief[agent.name]:
            if (
                channel.split(".", 2)[1] == "state"
                and channel not in self._has[agent.name]
                and not self._contents.tells_absence(agent.plan, channel)
            ):
                yield channel

    def stands(self, agent: Agent, channel: str) -> bool:
        """Whether a message that may say anything is there on a channel, as one may come now. Where others
        publish, what the agent itself does adds nothing to that."""
        if channel in self._of_others and channel in self.brief[agent.name]:
            return True
        if channel not in self.standing[agent.name] or not self.may_come(agent, channel):
            return False
        found = [board.newest(channel) for board in _boards(agent, channel)]
        return bool(found) and all(item is not None and item.time == NOW for item in found)

    def standing_now(self) -> Iterator[tuple[str, str, Content]]:
        """The messages that stand now: the agents, the channels and the contents."""
        for agent in self._agents:
            for channel in self.standing[agent.name]:
                for board in _boards(agent, channel):
                    item = board.newest(channel)
                    content = None if item is None else content_of(item.message)
                    if content is not None:
                        yield agent.name, channel, content

    def _stand(self, agent: Agent, coming: Container[str]) -> None:
        """Let a message stand for what may have come, or not, on the channels on which one may."""
        for channel in self.standing[agent.name]:
            if channel not in coming:
                continue
            boards = _boards(agent, channel)
            if any(board.newest(channel) for board in boards):
                continue
            is_own = bool(self.brief[agent.name][channel])
            content = self._contents.standing(agent.name, channel)
            identity = agent.identity() if is_own else self._bus.outside()
            item = Sample(channel, content, agent.name if is_own else "input", NOW, identity)
            for board in boards:
                board.put(item, NOW)

    def _is_brief(self, channel: str) -> bool:
        _, kind, message = channel.split(".", 2)
        if self._alone is not None:
            return message not in self._kept and channel not in self._alone.kept
        return kind != "signal" and message not in self._kept

    def own(self, agent: Agent) -> dict[str, frozenset[str]]:
        """The channels on which what activities of an agent publish comes to it alone, with these."""
        if self._alone is not None:
            return {}
        found = {
            channel: frozenset(info.name for info in agent.plan.activities if channel in info.writes)
            for channel in agent.chart.READERS
            if self._is_brief(channel) and self._is_asked(channel)
        }
        return {
            channel: activities
            for channel, activities in found.items()
            if activities and self._is_alone(agent, channel)
        }

    def _is_alone(self, agent: Agent, channel: str) -> bool:
        """Whether only activities of an agent publish for it on a channel, at once and for it alone."""
        routes = self._bus._routes
        rule = next((info for info in agent.plan.channels if info.name == channel), None)
        others = (name for name in self.writers().get(channel, ()) if name != agent.name)
        return (
            (rule is None or (rule.every is None and rule.radio is None and not rule.sources))
            and not any(agent.name in routes.receivers(name, channel).names for name in others)
            and routes.receivers(agent.name, channel).names == (agent.name,)
            and channel not in by_lines_of(agent.plan)
            and channel not in self._of_modules
        )

    # ---- in a run ----------------------------------------------------------------------------

    def may_come(self, agent: Agent, channel: str) -> bool:
        """Whether a new message may come at this moment on a channel of `brief`."""
        return channel in self.all_that_may_come(agent)

    def all_that_may_come(self, agent: Agent) -> set[str]:
        """The channels of `brief` on which a new message may come at this moment."""
        if agent.over or agent.down:
            return set()
        by_label = agent.plan.by_label
        running = {by_label[leaf].activity for leaf in agent.chart.configuration()}
        return {
            channel
            for channel, writers in self.brief[agent.name].items()
            if not writers or not running.isdisjoint(writers)
        }

    def is_new(self, agent: Agent, channel: str) -> bool:
        """Whether the newest message of a channel may be another one whenever the agent looks for it.

        Not if it has become old: then a new one has to come.
        """
        return channel in self.brief[agent.name] and all(
            item is None or item.time == NOW
            for item in (board.newest(channel) for board in _boards(agent, channel))
        )

    def look(self) -> None:
        """Note what may come in the moves from this state on."""
        self._may_come = {agent.name: self.all_that_may_come(agent) for agent in self._agents}

    def has_more(self, name: str) -> bool:
        """Whether anything may come to an agent in these moves."""
        return bool(self._may_come[name])

    def has_more_from_outside(self, name: str) -> bool:
        """Whether anything but what other agents publish may come to an agent in these moves."""
        return not self._may_come[name] <= self._of_others

    def begin(self) -> None:
        """A move is made now."""
        self._is_open = True

    def end(self) -> None:
        """The move is made: nothing looks for anything."""
        self._is_open = False

    def look_for(self, name: str, channel: str) -> None:
        """An agent looks for a message that is not there: it may just have come."""
        if not self._is_open or channel not in self._may_come.get(name, ()):
            return
        message = channel.rpartition(".")[2]
        is_of_others = channel in self._of_others
        text = f"{name}: {message} has come"
        if self._choices.of(("come", name, channel), (None, True), text, is_of_others=is_of_others):
            agent = next(item for item in self._agents if item.name == name)
            is_own = bool(self.brief[name][channel])
            fixed = self._has[name].get(channel, {})
            content = self._contents.new(message, ("input",), "{}", f"{name}: {message}", fixed, True)
            identity = agent.identity() if is_own else self._bus.outside()
            now = agent.driver.clock.now()
            item = Sample(channel, content, name if is_own else "input", now, identity)
            for number in agent.chart.READERS[channel]:
                board = agent.chart.boards()[number]
                if board is not None and board.newest(channel) is None:
                    board.put(item, NOW)

    def forget(self, agent: Agent) -> None:
        """What was decided of the newest messages may be otherwise, as far as new ones may come now."""
        if self._alone is not None:
            self._drop(agent)
            return
        brief = self.brief[agent.name]
        coming = brief if agent.over or agent.down else self.all_that_may_come(agent)
        for channel in brief:
            if channel not in coming:
                continue
            last = None
            for board in _boards(agent, channel):
                item = board.newest(channel)
                if item is not None and item is not last and item.time == NOW:
                    self._later.forget(item.message)
                last = item  # most boards have the same one
        if agent.chart.started and not (agent.over or agent.down):
            self._stand(agent, coming)
        self._fade(agent)
        self._unhear(agent)

    def _unhear(self, agent: Agent) -> None:
        """Forget the signals that wait where no line looks for them, but activities alone."""
        for board in agent.chart.boards():
            if board is not None and board.waiting():
                gone = [name for name in board._signals if name not in board.SLOTS and self._is_plain(name)]
                if gone:
                    board.part()
                    for channel in gone:
                        del board._signals[channel]

    def _is_plain(self, channel: str) -> bool:
        """Whether nothing but lines asks for the messages of a channel, and these keep none as a whole."""
        return channel.rpartition(".")[2] not in self._kept

    def _fade(self, agent: Agent) -> None:
        """Forget what messages say that are too old for anything to ask for it."""
        for channel, age in self._faded[agent.role].items():
            for board in _boards(agent, channel):
                item = board.newest(channel)
                if item is not None and NOW - item.time >= age:
                    self._later.fade(item.message)

    def _drop(self, agent: Agent) -> None:
        """What came to an agent alone may be there, or not, whenever it looks for it."""
        for channel in self.brief[agent.name]:
            for board in agent.chart.boards():
                item = None if board is None else board.newest(channel)
                if board is None or item is None:
                    continue
                self._later.forget(item.message)
                if self._alone is not None and channel in self._alone.fixed:
                    continue  # once it is there, what is known of it is so
                board.part()
                for held in (board._states, board._data, board._signals):
                    held.pop(channel, None)
                board._refresh(channel)

    def forget_kept(self, agent: Agent, ages: Mapping[str, tuple[int, ...]]) -> None:
        """What is kept of messages, but not always: what they say, once no condition asks whether they are
        older, and of the others the members that do not matter."""
        assert self._alone is not None
        for channel in self._alone.kept:
            for board in agent.chart.boards():
                item = None if board is None else board.newest(channel)
                if item is None:
                    continue
                is_old = NOW - item.time >= max(ages.get(channel, ()), default=0)
                kept = (
                    frozenset[tuple[str, ...]]() if is_old else self._alone.members.get(channel, frozenset())
                )
                self._later.forget(item.message, kept)

    def may_change(self, agent: Agent, channel: str) -> bool:
        """Whether a message that comes from outside makes a difference. It takes the place of a signal that
        waits, which may say anything itself."""
        boards = _boards(agent, channel)
        waiting = [board.newest(channel) if board.waits(channel) else None for board in boards]
        return (
            not waiting
            or channel in self.queued[agent.name]
            or any(
                item is None or item.time != NOW or not self._later.is_open(item.message) for item in waiting
            )
        )

    @cached_property
    def queued(self) -> Mapping[str, tuple[str, ...]]:
        """The inputs, by agent, of which several wait."""
        return {
            agent.name: tuple(
                info.name
                for info in agent.plan.channels
                if info.queued and info.name in self.inputs[agent.name]
            )
            for agent in self._agents
        }

    def in_line(self, agent: Agent) -> int:
        """How many messages of an input wait for an agent, at the most."""
        return max(
            (board.waits(name) for name in self.queued[agent.name] for board in _boards(agent, name)),
            default=0,
        )

    def give(self, agent: Agent, channel: str) -> None:
        """A message comes from outside."""
        for board in agent.chart.boards():
            if board is not None and channel in board._data:  # of data, the newest is all that is read
                board.part()
                del board._data[channel]
        self._bus.give(agent, channel, self.content(agent, channel))

    def content(self, agent: Agent, channel: str) -> object:
        """The content of a message that comes to an agent."""
        message = channel.rpartition(".")[2]
        fixed = self._has[agent.name].get(channel, {})
        return self._contents.new(message, ("input",), "{}", f"{agent.name}: {message}", fixed)


def _boards(agent: Agent, channel: str) -> list[Board]:
    """The blackboards of active regions on which the messages of a channel stand."""
    boards = agent.chart.boards()
    found = (boards[number] for number in agent.chart.READERS[channel])
    return [board for board in found if board is not None]


__all__ = ["Coming"]
