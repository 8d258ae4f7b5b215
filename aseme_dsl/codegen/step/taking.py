"""Taking transitions, those that stay in a state and those that lead on."""

from __future__ import annotations

from aseme_dsl.amola.expression import (
    After,
    taken_message,
    walk,
)
from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.tree import (
    FALSE,
    TRUE,
    Expr,
)
from aseme_dsl.codegen.program.moves import move_of
from aseme_dsl.codegen.program.uses import signals
from aseme_dsl.codegen.step.actions import Actions
from aseme_dsl.codegen.step.entering import Entering
from aseme_dsl.codegen.step.events import Events
from aseme_dsl.codegen.step.leaving import Leaving
from aseme_dsl.codegen.step.names import Method, Part, StepNames, mail_name


class Taking(Part):
    """Taking transitions, those that stay in a state and those that lead on."""

    def __init__(
        self, names: StepNames, actions: Actions, events: Events, leaving: Leaving, entering: Entering
    ) -> None:
        super().__init__(names)
        self.actions = actions
        self.events = events
        self.leaving = leaving
        self.entering = entering

    def take(
        self,
        method: Method,
        depth: int,
        region: int,
        source: str,
        leaf: State | None,
        complete: Expr,
        taken: tuple[int, ...],
    ) -> None:
        transitions = [self.flat.transition(number) for number in taken]
        method.add(depth, f"self.taken.append({taken!r})")
        plain = [t.expression for t in transitions if not taken_message(t.expression)]
        self.events.spend_events(method, depth, region, source, plain)
        for number, transition in zip(taken, transitions, strict=True):
            if taken_message(transition.expression):
                method.add(depth, f"self.take_letter({mail_name(number)})")
        move = move_of(self.flat, taken)
        scope, place = move.scope, move.region
        if place == region:
            self.leaving.leave_leaf(method, depth, region, scope, leaf, complete != FALSE)
        else:
            around = next(
                node
                for node in self.chart.ancestors(source)
                if node.type is StateType.AND and self.flat.region_number[node.label] == place
            )
            self.leaving.leave_leaf(method, depth, place, scope, around, False)
            method.add(depth, f"self.out = {place}")
        if self.history.suspended:
            method.add(depth, "self.held.clear()")
        looked_at = self.actions.actions(method, depth, region, source, taken, place)
        self.entering.enter(method, depth, place, scope, move.target, resume=move.resume, into=move.into)
        for channel, host in looked_at:
            self.actions.consume(method, depth, region, channel, host, place)

    def on(self, method: Method, depth: int, region: int, number: int, complete: Expr) -> None:
        """The tests of a transition that stays, around what it does.

        Without an event it is taken once for what it sees: again when something of that is news, or when its
        condition has not held in between.
        """
        transition = self.flat.transition(number)
        expression, source = transition.expression, transition.source
        if not expression.events and not expression.when and complete == FALSE:
            return
        method.add(depth, f"# {self.names.place(number)}")
        if not expression.events and not expression.when and complete != TRUE:
            method.add(depth, f"if {method.code(complete)}:")
            depth += 1
        there = [
            f"self.{self.names.past(number)} < {event.duration} <= now - self.{self.names.time_name(source)}"
            if isinstance(event, After)
            else self.events.there(region, source, event)
            for event in expression.events
        ]
        if there and not expression.when:
            method.add(depth, f"if {' or '.join(there)}:")
            depth += 1
        outside = depth
        asked = [] if expression.guard is None else signals(walk(expression.guard))
        for channel, host in asked:
            method.add(depth, f"{method.b}.ask({channel!r}, {host!r})")
        guard = ""
        if taken_message(expression):
            guard = f"({mail_name(number)} := {self.events.pick(region, number, expression)}) is not None"
        elif expression.guard is not None:
            guard = self.actions.guard(method, region, number, expression.guard)
        if guard:
            method.add(depth, f"if {guard}:")
            depth += 1
        if self.names.has_mark(number):
            slots = self.names.slots[region]
            news = [*there, *(f"{method.b}.{slots[signal]} is not None" for signal in asked)]
            news.append(f"self.is_news(self.{self.names.mark(number)}, self._seen_{number}())")
            method.add(depth, f"if {' or '.join(news)}:")
            depth += 1
        method.add(depth, f"self.taken.append(({number},))")
        spent = [
            f"self.{self.names.past(number)} = {event.duration}"
            if isinstance(event, After)
            else self.events.spent(region, source, event)
            for event in expression.events
        ]
        if taken_message(expression):
            method.add(depth, f"self.take_letter({mail_name(number)})")
            spent = there = []
        for index, (test, action) in enumerate(zip(there, spent, strict=True)):
            if len(spent) == 1 and not expression.when:
                method.add(depth, action)
            else:
                method.add(depth, f"{'elif' if index else 'if'} {test}:", f"    {action}")
        for channel, host in self.actions.actions(method, depth, region, source, (number,)):
            self.actions.consume(method, depth, region, channel, host)
        if self.names.has_mark(number):
            method.add(depth, f"self.{self.names.mark(number)} = self._seen_{number}()")
        method.add(depth, "return True")
        if self.names.has_mark(number) and guard:
            method.add(outside, "else:", f"    self.{self.names.mark(number)} = None")


__all__ = ["Taking"]
