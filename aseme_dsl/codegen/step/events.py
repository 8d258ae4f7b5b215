"""The events that transitions wait for, and what spends them."""

from __future__ import annotations

from aseme_dsl.amola.expression import (
    After,
    Event,
    Failed,
    Lost,
    Raised,
    Received,
    TransitionExpression,
)
from aseme_dsl.codegen.code.face import docstring
from aseme_dsl.codegen.code.values import holds
from aseme_dsl.codegen.program.moves import raises
from aseme_dsl.codegen.step.names import Method, Part

LOST = "lost"
"""What stands for the performative where an agent is lost."""


class Events(Part):
    """The events that transitions wait for, and what spends them."""

    def there(self, region: int, source: str, event: Event) -> str:
        match event:
            case After(duration=duration):
                return f"now - self.{self.names.time_name(source)} >= {duration}"
            case Received() | Lost():
                return f"self.waiting_mail({self._letter(source, event)}) is not None"
            case Raised(name=name):
                return f"{name!r} in self.events and ({region}, {name!r}) not in self.spent"
            case Failed():
                return f"self.failed_inside({source!r})"

    def _letter(self, source: str, event: Received | Lost) -> str:
        branch = self.chart.branch_of(source)
        return f"{branch!r}, {', '.join(map(repr, mail_kind(event)))}"

    def pick(self, region: int, number: int, expression: TransitionExpression) -> str:
        """A method that finds the agent message which a transition takes, if its condition depends on it."""
        if number not in self.names.guards:
            self.names.guards.add(number)
            pick = self.names.writing(region)
            pick.names.mail = "mail"
            self.names.asked_by(number, pick.names)
            branch = self.chart.branch_of(self.flat.transition(number).source)
            kinds = tuple(
                mail_kind(event) for event in expression.events if isinstance(event, Received | Lost)
            )
            pick.add(2, f"for mail in self.letters({branch!r}, {kinds!r}):")
            if expression.guard is None:
                pick.add(3, "return mail")
            else:
                code = pick.code(holds(expression.guard, pick.names)[0])
                can_raise = raises(expression.guard)
                depth = 4 if can_raise else 3
                if can_raise:
                    pick.add(3, "try:")
                pick.add(depth, f"if {code}:", "    return mail")
                if can_raise:
                    pick.add(3, "except Exception as error:", f"    self.fault({number}, error)")
            pick.add(2, "return None")
            signature = f"_picks_{number}(self, b: Board{region}, now: int) -> Any"
            document = f"What is taken by {docstring(self.names.place(number))}."
            self.names.method(signature, document, pick, has_board=True)
        return f"self._picks_{number}(self.b{region}, now)"

    def spend_events(
        self, method: Method, depth: int, region: int, source: str, segments: list[TransitionExpression]
    ) -> None:
        """Spend the first event of each segment that is there, one that several name once."""
        spending = [
            item for item in segments if any(isinstance(e, Received | Lost | Raised) for e in item.events)
        ]
        if not spending:
            return
        if len(spending) == 1:
            events = [
                (self.there(region, source, e), self.spent(region, source, e)) for e in spending[0].events
            ]
            if len(events) == 1 and not spending[0].when:
                method.add(depth, events[0][1])
                return
            for index, (test, action) in enumerate(events):
                method.add(depth, f"{'elif' if index else 'if'} {test}:", f"    {action}")
            return
        actions: dict[str, int] = {}  # what was there is seen before any of it is consumed
        choices = []
        for item in spending:
            tests = [
                f"{actions.setdefault(self.spent(region, source, e), len(actions))} "
                f"if {self.there(region, source, e)} else "
                for e in item.events
            ]
            choices.append("".join(tests) + "-1")
        method.add(depth, f"for event in dict.fromkeys(({', '.join(choices)})):")
        for action, index in actions.items():
            method.add(depth + 1, f"{'elif' if index else 'if'} event == {index}:", f"    {action}")

    def spent(self, region: int, source: str, event: Event) -> str:
        """What consumes an event; time and failures are not consumed."""
        match event:
            case Received() | Lost():
                return f"self.take_mail({self._letter(source, event)})"
            case Raised(name=name):
                around = [n for n in self.flat.regions_around(region) if name in self.uses.awaited.get(n, ())]
                if not around:
                    return f"self.spent.add(({region}, {name!r}))"
                gone = ", ".join(f"({number}, {name!r})" for number in (region, *around))
                return f"self.spent.update(({gone}))"
        return "pass"


def mail_kind(event: Received | Lost) -> tuple[str, str, str]:
    """The agent messages that an event waits for: performative, message and participant."""
    if isinstance(event, Lost):
        return LOST, "", event.participant
    return event.performative, event.message, event.participant


__all__ = ["Events", "mail_kind"]
