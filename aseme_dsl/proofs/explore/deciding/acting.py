"""Acting: what activities do in a team that is explored: anything that they may do."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import partial
from typing import Protocol, cast

from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.later import Contents, content_of
from aseme_dsl.proofs.explore.deciding.lists import placed
from aseme_dsl.proofs.explore.deciding.order import AnyNumber, Order, Some, Unanswerable
from aseme_dsl.proofs.explore.deciding.outcomes import Outcomes
from aseme_dsl.proofs.explore.deciding.staging import OPEN, assigned, by_lines, receivers, watched
from aseme_dsl.proofs.explore.deciding.values import Values
from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.agent.prepared import Prepared
from aseme_dsl.runtime.chart import inputs
from aseme_dsl.runtime.chart.functions import find_function, is_of_library
from aseme_dsl.runtime.chart.plan import Plan, is_in
from aseme_dsl.runtime.library.agents import how_many, without

DRAWN = (0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 0.9999)
"""What stands for random numbers."""


class Called(Protocol):
    """A function of a document."""

    def __call__(self, *arguments: object) -> object: ...


Function = tuple[str, str, str, str]
"""A function of a document, as a plan has it."""


class Acting:
    """Decides what activities and functions do, and does it. Nothing of it belongs to the state of a team."""

    def __init__(
        self,
        choices: Choices,
        values: Values,
        contents: Contents,
        plans: Sequence[Plan],
        is_new: Callable[[Agent, str], bool],
        outcomes: Outcomes,
        is_asked: Callable[[str], bool],
        kept: frozenset[str],
        order: Order,
        stands: Callable[[Agent, str], bool],
    ) -> None:
        """`is_new` says whether what activities of an agent publish on a channel is there for it whenever it
        looks for it, and for no other agent. `stands` says whether a message that may say anything is there
        for an agent on a channel: then another one makes no difference. `is_asked` says whether anything but
        activities asks for the messages of a channel, and `kept` has the variables that something beside the
        plans looks at.
        """
        self._is_new = is_new
        self._order = order
        self._stands = stands
        self._choices = choices
        self._outcomes = outcomes
        self._values = values
        self._contents = contents
        self._plans = {plan.name: plan for plan in plans}
        self._watched = {plan.name: watched(plan) | kept for plan in plans}
        self._writes: dict[tuple[str, str], list[str]] = {}
        self._is_asked = is_asked
        self._reads = 0
        self.publishes = True
        """Whether what activities publish matters."""

    def acts(self, execution: Execution) -> bool:
        """Whether an activity may do something that others see, and continue."""
        info = execution.info
        agent = cast("Agent", execution.owner.agent)
        seen = self._watched[agent.role]
        sets = any(name in seen for name in self._writable(agent, execution))
        sends = execution.branch is not None and any(
            is_in(execution.label, state)
            for *_, states, _ in agent.branch_info(execution.branch).moves
            for state in states
        )
        writes = any(self.matters(channel) and not self._is_new(agent, channel) for channel in info.writes)
        return bool(sets or writes or sends or self._signals(execution))

    def written(self, agent: Agent, execution: Execution, *, is_end: bool) -> list[str]:
        """The variables that an activity writes when it runs or ends."""
        found = self._writable(agent, execution)
        return [name for name in found if is_end or name in self._watched[agent.role]]

    def _writable(self, agent: Agent, execution: Execution) -> list[str]:
        """The variables that an activity may write: those that it declares, and of its participant those
        that no line of the protocol writes, but to give them their initial value."""
        known = self._writes.get((agent.role, execution.label))
        if known is None:
            inner = [
                item.name.partition("@")[0]
                for item in agent.plan.variables
                if item.scope is not None
                and not item.type.startswith("list of ")
                and is_in(execution.label, item.scope)
                and item.name not in assigned(agent.plan)
            ]
            there = {
                item.name.partition("@")[0]
                for item in agent.plan.variables
                if item.scope is None or is_in(execution.label, item.scope)
            }
            declared = (name for name in execution.info.variables if name in there)  # of other roles, too
            known = self._writes[agent.role, execution.label] = [*dict.fromkeys((*declared, *inner))]
        return known

    def end(self, execution: Execution) -> None:
        """An activity ends: it has done anything that it may do."""
        self.act(execution, is_end=True)
        if execution.info.ends:
            text = f"{execution.activity} ends with {{}}"
            execution.result = self._choices.of(("ends",), execution.info.ends, text)
        execution.returned(None)

    def act(self, execution: Execution, *, is_end: bool = False) -> None:
        """An activity does anything that it may do."""
        agent = cast("Agent", execution.owner.agent)
        info = execution.info
        self._read(agent, execution)
        if not is_end:
            self._take(execution)
        for channel in info.writes:
            if (is_end or not self._is_new(agent, channel)) and not self._stands(agent, channel):
                self._publish(agent, execution, channel)
        if execution.branch is not None:
            self._send(agent, execution, execution.branch)
        written = self.written(agent, execution, is_end=is_end)
        for name in written:  # at last: only the agent's step shows it
            self._set(agent, execution, name)
        # The agent steps at once, or only when more has come: what it takes in one step.
        if written and not is_end and self._choices.of(("steps", agent.name), (True, False)):
            agent.begin()

    def _set(self, agent: Agent, execution: Execution, name: str) -> None:
        """An activity writes a variable: what, is decided when it is read."""
        variable = agent.plan.variable_of(name, execution.label)
        if not variable.type.startswith("list of "):
            agent.chart.set_variable(variable.name, OPEN)

    def decide(self, role: str, agent: str, variable: str) -> object:
        """What an activity has written to a variable."""
        plan = self._plans[role]
        found = next(item for item in plan.variables if item.name == variable)
        value = self._order.made(
            self._choices.of(
                ("variable", agent, variable, self._anew()),
                self._values.held(found),
                f"{agent}: {variable.partition('@')[0]} is {{}}",
            )
        )
        if found.bounds is not None:
            self._order.suppose(value, *found.bounds)
        return value

    def draw(self, agent: str) -> float:
        """A random number: one of a few, or any."""
        if self._values.may_be_any:
            number = self._order.number(is_whole=False)
            self._order.suppose(number, 0, 1)
            return cast("float", number)
        self._values.bounds["random()"] = f"random() in {', '.join(map(str, DRAWN))}"
        return self._choices.of(("random", agent, self._anew()), DRAWN, f"{agent}: random() is {{}}")

    def _anew(self) -> int:
        self._reads += 1
        return self._reads

    def _publish(self, agent: Agent, execution: Execution, channel: str) -> None:
        message = channel.rpartition(".")[2]
        if not self.matters(channel):
            return
        text = f"{execution.activity} publishes {message}"
        if self._choices.of(("publish", channel), (None, True), text):
            name = f"{agent.name}: {message}"
            content = self._contents.new(message, ("published", channel), "with {}", name)
            doing = c.Publish(channel, content, None)
            if execution.opens is not None:
                execution.held.append(doing)
            else:  # what is decided later is of another class than the plan's
                agent.requests.perform(execution, doing)

    def matters(self, channel: str) -> bool:
        """Whether it matters that an activity publishes on a channel."""
        return self.publishes and self._is_asked(channel)

    def _send(self, agent: Agent, execution: Execution, branch: str) -> None:
        """The messages of the protocol that activities send, where this one may."""
        info = agent.branch_info(branch)
        for performative, message, states, _ in info.moves:
            if not any(is_in(execution.label, state) for state in states):
                continue
            for part in receivers(info, performative, message, [*self._plans.values()]):
                contents = self._values.contents(message)
                answers = (None, *contents)
                what = f"{performative} {message}"
                text = f"{execution.activity} sends {what} to {part}{': {}' if len(contents) > 1 else ''}"
                chosen = self._choices.of(("send", what, part), answers, text)
                if chosen is not None:
                    with suppress(LookupError):  # it is not sent, and the activity would hear why
                        execution.do(c.Send(performative, self._order.made(chosen), part))

    def _read(self, agent: Agent, execution: Execution) -> None:
        """The agent messages that no transition takes are for activities."""
        if execution.branch is None:
            return
        waiting = agent.chart.mail[execution.branch]
        lines = by_lines(agent.plan, execution.branch)
        for item in list(waiting):
            if (item.performative, item.message) not in lines and item.performative != inputs.LOST:
                question = ("read", item.performative, item.message, item.sender)
                text = f"{execution.activity} takes {item.performative} {item.message}"
                if self._choices.of(question, (True, None), text):
                    agent.requests.take_mail(execution, item.performative, item.message, item.sender)

    def _signals(self, execution: Execution) -> list[str]:
        """The signals that wait where the code of an activity may take them, before a condition sees them."""
        signals = (name for name in execution.info.reads if name.split(".")[-2] == "signal")
        return [name for name in signals if self._is_asked(name) and execution.board.waits(name)]

    def _take(self, execution: Execution) -> None:
        for channel in self._signals(execution):
            text = f"{execution.activity} takes {channel.rpartition('.')[2]}"
            if self._choices.of(("signal", channel), (None, True), text):
                execution.take(channel, None)

    def prepared(self, agent: str, message: str) -> object:
        """What an activity has prepared for a message."""
        contents = self._values.contents(message)
        text = f"{agent} has prepared {{}}"
        return self._order.made(self._choices.of(("content", agent, message), contents, text))

    def function(self, role: str, agent: str, function: Function) -> Called:
        """What is called instead of a function of the document.

        Those of the library do what they do, but of messages whose members are not decided.
        """
        if not is_of_library(function[1]):
            return partial(self._answer, agent, function)
        known = find_function(function[1])
        if function[0] in self._values.free.get(role, ()):
            return partial(self._placed, agent)

        def call(*arguments: object) -> object:
            if any(content_of(item) is not None for item in arguments):
                return self._answer(agent, function, *arguments)
            if any(type(item) is AnyNumber for item in arguments):
                raise Unanswerable(f"{function[0]} is given a number that may be any")
            return known(*arguments)

        return call

    def _placed(self, agent: str, listed: str, who: str, number: float) -> str:
        """A list of agents with one more, which may get any place: what it is ranked by may be any number."""
        rest = how_many(without(listed, who))
        text = f"{who} gets place {{}} of a list"
        place = self._choices.of(("place", agent, self._anew()), range(1, rest + 2), text)
        return placed(listed, who, place - 1)

    def _answer(self, agent: str, function: Function, *arguments: object) -> object:
        """What a function of the document gives: anything, and the same for the same."""
        name, _, result, _ = function
        kinds: Mapping[str, tuple[object, ...]] = {"bool": (False, True)}
        answers = kinds.get(result) or self._values.results(name, result)
        text = f"{name.partition('(')[0]}() is {{}}"
        question = "function", agent, name, repr(arguments)
        answer = self._outcomes.of(question, answers, text)
        if type(answer) is Some:  # for the same, it is the same number in a move
            return self._choices.of(("number", *question), (self._order.made(answer),))
        return self._order.made(answer)


class Free(Prepared):
    """What activities have prepared: anything, at the moment at which it is sent."""

    def __init__(self, acting: Acting, agent: str) -> None:
        super().__init__()
        self._acting = acting
        self._agent = agent

    def clear(self) -> None:
        """There is nothing to forget."""

    def take(self, plan: Plan, branch: str, message: str, source: str) -> object:
        return self._acting.prepared(self._agent, message)


__all__ = ["Acting", "Free"]
