"""What transitions do, the conditions before it, and the signals that both look at."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from aseme_dsl.amola.expression import (
    Action,
    Assign,
    Evaluate,
    Expired,
    Member,
    Outcome,
    Publish,
    Raise,
    ReadMessages,
    RoundValue,
    Send,
    StartTimer,
    StateValue,
    TransitionExpression,
    Value,
    VariableValue,
    values_of,
    walk,
)
from aseme_dsl.amola.messages import DURATION, ChannelKind
from aseme_dsl.codegen.code.face import docstring
from aseme_dsl.codegen.code.tree import (
    NOW,
    TRUE,
    CallOf,
    Const,
    Expr,
    Field,
    Name,
    all_of,
    own,
    own_call,
)
from aseme_dsl.codegen.code.values import Piece, computed, converted, holds
from aseme_dsl.codegen.program.moves import raises
from aseme_dsl.codegen.program.uses import signals
from aseme_dsl.codegen.step.names import Method, Part, mail_name


class Actions(Part):
    """What transitions do, the conditions before it, and the signals that both look at."""

    def actions(
        self,
        method: Method,
        depth: int,
        region: int,
        source: str,
        taken: tuple[int, ...],
        place: int | None = None,
    ) -> list[tuple[str, str | None]]:
        """The actions of the segments in order; the signals that these and their conditions look at.

        They read what `region` knows; what they change they change in `place`, if that is another one.
        """
        transitions = [self.flat.transition(number) for number in taken]
        conditions = [t.expression.condition for t in transitions]
        looked_at = dict.fromkeys(
            found for item in conditions if item is not None for found in signals(walk(item))
        )
        still_seen = set(looked_at)  # until an action puts messages on the board
        for number, transition in zip(taken, transitions, strict=True):
            method.names.mail = mail_name(number)
            for action in transition.expression.actions:
                for channel, host in signals(_read_by(action)):
                    if (channel, host) not in still_seen:
                        method.add(depth, f"{method.b}.ask({channel!r}, {host!r})")
                        still_seen.add((channel, host))
                        looked_at[channel, host] = None
                self._action(
                    method, depth, region, number, source, action, region if place is None else place
                )
                if isinstance(action, ReadMessages):
                    still_seen.clear()
                elif isinstance(action, Publish):
                    still_seen = {seen for seen in still_seen if seen[0] != str(action.channel)}
        return list(looked_at)

    def _action(
        self,
        method: Method,
        depth: int,
        region: int,
        number: int,
        source: str,
        action: Action,
        place: int,
    ) -> None:

        def board() -> str:
            return method.b if place == region else f"self.b{place}"

        match action:
            case ReadMessages():
                method.add(depth, f"self.read_messages({place}, {board()})")
            case Publish(channel=channel):
                drafts = "" if place == region else f", {method.b}"
                method.add(depth, f"self.publish({place}, {board()}, {str(channel)!r}{drafts})")
            case Send(performative=performative, message=message, participant=participant):
                branch = self.chart.branch_of(source)
                letter = f"{branch!r}, {performative!r}, {message!r}, {participant!r}"
                self.computed(
                    method,
                    depth,
                    number,
                    action.values,
                    lambda *p: [_sending(method, letter, action, p)],
                    message=f"{performative} {message}",
                )
            case StartTimer(timer=timer, duration=duration):
                self.computed(
                    method,
                    depth,
                    number,
                    (duration,),
                    lambda piece: [f"{board()}.timers[{timer!r}] = {method.now} + {method.code(piece.code)}"],
                )
            case Assign(target=target, value=value):
                self.computed(
                    method,
                    depth,
                    number,
                    (value,),
                    lambda piece: self._assignment(method, region, target, value, piece, place),
                    can_raise=isinstance(target, VariableValue) and self.names.is_bounded(target.name),
                )
            case Raise(name=name):
                method.add(depth, f"self.raised += ({name!r},)")
            case Evaluate(value=value):
                self.computed(method, depth, number, (value,), lambda piece: [method.code(piece.code)])

    def _assignment(
        self,
        method: Method,
        region: int,
        target: VariableValue | Member,
        value: Value,
        piece: Piece,
        place: int,
    ) -> list[str]:
        result = converted(piece, value.type, target.type)
        if isinstance(target, VariableValue):
            result = self.names.bounded(target.name, result)
        code = method.code(result)
        if isinstance(target, Member):
            return [f"{method.b}.fill({str(target.channel)!r}, {target.host!r}, {target.path!r}, {code})"]
        lines = self.names.writing(region)
        self.write(lines, 0, region, target.name, code, place)
        return lines.lines

    def write(
        self, method: Method, depth: int, region: int, name: str, code: str, place: int | None = None
    ) -> None:
        """Write a variable in a region, and in `place`, if that is where it counts."""
        place = region if place is None else place
        attribute = self.names.variable(name, place)
        copies = dict.fromkeys((attribute, self.names.variable(name, region)))
        method.add(depth, "".join(f"self.{copy} = " for copy in copies) + code)
        if len(self.uses.variable_regions[name]) > 1:
            method.add(depth, f"self.writes.append(({place}, {name!r}, self.{attribute}))")

    def consume(
        self,
        method: Method,
        depth: int,
        region: int,
        channel: str,
        host: str | None,
        place: int | None = None,
    ) -> None:
        """Consume the signal that was looked at, for the region and for those around it.

        Those inside `place` have been left.
        """
        regions = list(self.flat.regions_around(region))
        if place is not None and place != region:
            regions = regions[regions.index(place) :]
        around = [n for n in regions if channel in self.uses.asked_signals.get(n, ())]
        outer = "".join(f", self.b{number}" for number in around)
        method.add(depth, f"{method.b}.spend({channel!r}, {host!r}{outer})")

    def seen(self, number: int) -> None:
        """A method with what the condition of a transition reads: messages, and values."""
        transition = self.flat.transition(number)
        region = self.flat.region_number[transition.source]
        condition = transition.expression.guard
        messages: dict[Expr, None] = {}
        values: dict[Expr, None] = {}
        for value in walk(condition) if condition is not None else ():
            match value:
                case Member(channel=channel, host=host) if channel.comm is not ChannelKind.SIGNAL:
                    messages.setdefault(self.names.seen[region][str(channel), host])
                case VariableValue(name=name):
                    values.setdefault(own(self.names.variable(name, region)))
                case Expired(timer=timer):
                    timers = Field(Name("b"), "timers")
                    values.setdefault(CallOf(Field(timers, "get"), (Const(timer),)))
                case Outcome(activity=activity):
                    labels = self.registers.asked_of(transition.source, activity)
                    values.setdefault(own_call("last_outcome", Const(labels)))
                case StateValue():
                    values.setdefault(self.names.about_states(transition.source, value))
                case RoundValue():
                    values.setdefault(self.names.about_rounds(transition.source, value))
        method = self.names.writing(region)
        parts = [
            "(" + "".join(f"{method.code(code)}, " for code in found).strip() + ")"
            for found in (messages, values)
        ]
        method.add(2, f"return {parts[0]}, {parts[1]}")
        place = docstring(self.names.place(number))
        self.names.method(f"_seen_{number}(self) -> Seen", f"What {place} reads.", method)

    def guard(self, method: Method, region: int, number: int, condition: Value) -> str:
        """The condition in line, or as a method of its own where evaluating it may raise; "" if it holds."""
        self.names.asked_by(number, method.names)
        code, _ = holds(condition, method.names)
        if not raises(condition):
            return "" if code == TRUE else method.code(code)
        if number not in self.names.guards:
            self.names.guards.add(number)
            guard = self.names.writing(region)
            self.names.asked_by(number, guard.names)
            code, _ = holds(condition, guard.names)
            guard.add(2, "try:", f"    return {guard.code(code)}", "except Exception as error:")
            guard.add(3, f"return self.fault({number}, error)")
            signature = f"_holds_{number}(self, b: Board{region}, now: int) -> bool"
            document = f"The condition of {docstring(self.names.place(number))}."
            self.names.method(signature, document, guard, has_board=True)
        return method.code(own_call(f"_holds_{number}", Name("b"), NOW))

    def computed(
        self,
        method: Method,
        depth: int,
        number: int,
        values: Sequence[Value],
        use: Callable[..., list[str]],
        *,
        can_raise: bool = False,
        message: str | None = None,
    ) -> None:
        """Compute values and use them; an absent or raising one is a fault.

        `can_raise`: the use may, too. `message` is what they are sent with, if they are: it is then not sent.
        """
        fault = f"self.fault({number}" if message is None else f"self.unsent({number}, {message!r}"
        self.names.asked_by(number, method.names)
        found = computed(values, method.names)
        can_raise = can_raise or found.raises
        if can_raise:
            method.add(depth, "try:")
            depth += 1
        if found.needs:
            method.add(depth, f"if {method.code(all_of(found.needs))}:")
            method.add(depth + 1, *use(*found.pieces))
            method.add(depth, "else:", f"    {fault}, {method.code(Name('ABSENT'))})")
        else:
            method.add(depth, *use(*found.pieces))
        if can_raise:
            method.add(depth - 1, "except Exception as error:", f"    {fault}, error)")


def _sending(method: Method, letter: str, action: Send, pieces: Sequence[Piece]) -> str:
    """The call that sends an agent message, with what its values have come to."""
    fills = action.fills
    count = len(fills or ())
    arguments = [letter]
    named: list[str] = []
    if fills is not None:
        given = zip(fills, pieces, strict=False)
        members = [f"{i.path!r}: {method.code(converted(p, i.value.type, i.type))}" for i, p in given]
        arguments.append(f"{{{', '.join(members)}}}")
    if action.rest is not None:
        named += [f"rest={method.code(pieces[count].code)}", f"taken={action.taken!r}"]
        count += 1
    if action.reply_by is not None:
        within = converted(pieces[count], action.reply_by.type, DURATION)
        named.append(f"reply_within={method.code(within)}")
        count += 1
    if action.to is not None:
        arguments.append(f"to={method.code(pieces[count].code)}")
        count += 1
    if action.excepts:
        arguments.append(f"excepts=({', '.join(method.code(piece.code) for piece in pieces[count:])},)")
    if action.one:
        named.append("one=True")
    return f"self.send({', '.join((*arguments, *named))})"


def _read_by(action: Action) -> Iterable[Value]:
    return values_of(TransitionExpression(actions=(action,)))


__all__ = ["Actions"]
