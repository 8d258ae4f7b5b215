"""Conditions, values and actions as the text of a script: ECMAScript or Python."""

from __future__ import annotations

import json
import math
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from typing import assert_never

from aseme_dsl.interop.export.machine import (
    All,
    Cond,
    Const,
    Given,
    If,
    In,
    Inverse,
    Op,
    Pick,
    Present,
    Ref,
    Set,
    Sign,
    Some,
    Term,
    Test,
    Truth,
)

_INFIX = {
    Sign.LESS: "<",
    Sign.MOST: "<=",
    Sign.MORE: ">",
    Sign.LEAST: ">=",
    Sign.PLUS: "+",
    Sign.MINUS: "-",
    Sign.TIMES: "*",
    Sign.OVER: "/",
}


class Script(ABC):
    """A language in which conditions are written."""

    and_: str
    or_: str
    not_: str
    true: str
    false: str
    null: str

    @abstractmethod
    def reference(self, name: str, path: tuple[str, ...] = ()) -> str:
        """A datum, or a member of it."""

    @abstractmethod
    def given(self, name: str) -> str:
        """What the event says for a name."""

    @abstractmethod
    def is_given(self, name: str) -> str:
        """Whether the event says something for a name."""

    @abstractmethod
    def is_there(self, text: str) -> str:
        """Whether a value is not absent."""

    @abstractmethod
    def constant(self, value: bool | int | float | str | None) -> str:
        """A constant."""

    @abstractmethod
    def active(self, state: str) -> str:
        """Whether a state is active."""

    @abstractmethod
    def computed(self, sign: Sign, parts: list[str]) -> str:
        """An operator that is not written alike everywhere."""

    @abstractmethod
    def picked(self, condition: str, yes: str, no: str) -> str:
        """One of two values."""

    @abstractmethod
    def milliseconds(self, delay: Term) -> str:
        """A duration in ns as SCXML writes it: a text such as `500ms`."""

    def condition(self, cond: Cond) -> str:
        """A condition, in brackets where it needs some."""
        match cond:
            case Truth(term=term):
                return self.term(term)
            case Present(what=what):
                if isinstance(what, Given):
                    return self.is_given(what.name)
                name, path = what.name, what.path
                steps = [self.is_there(self.reference(name, path[:end])) for end in range(len(path) + 1)]
                return steps[0] if len(steps) == 1 else f"({f' {self.and_} '.join(steps)})"
            case In(state=state):
                return self.active(state)
            case All(parts=parts):
                return self._joined(parts, self.and_, self.true)
            case Some(parts=parts):
                return self._joined(parts, self.or_, self.false)
            case Inverse(part=part):
                return f"{self.not_}({self.condition(part)})"
        assert_never(cond)

    def _joined(self, parts: Iterable[Cond], word: str, empty: str) -> str:
        texts = [self.condition(part) for part in parts]
        return f"({f' {word} '.join(texts)})" if texts else empty

    def term(self, term: Term) -> str:
        """A value, in brackets where it is computed."""
        match term:
            case Const(value=value):
                return self.constant(value)
            case Ref(name=name, path=path):
                return self.reference(name, path)
            case Given(name=name):
                return self.given(name)
            case Op(sign=sign, operands=operands):
                parts = [self.term(item) for item in operands]
                if sign in _INFIX:
                    return f"({parts[0]} {_INFIX[sign]} {parts[1]})"
                return f"(-{parts[0]})" if sign is Sign.NEGATIVE else self.computed(sign, parts)
            case Pick(condition=condition, yes=yes, no=no):
                return self.picked(self.condition(condition), self.term(yes), self.term(no))
            case Test(condition=condition):
                return self.condition(condition)
        assert_never(term)


class EcmaScript(Script):
    """`data` stands before the names of data, `event` for what the event says."""

    and_, or_, not_, true, false, null = "&&", "||", "!", "true", "false", "null"

    def __init__(self, data: str = "", event: str = "_event.data") -> None:
        self._data = data
        self._event = event

    def reference(self, name: str, path: tuple[str, ...] = ()) -> str:
        return f"{self._data}{name}" + "".join(f"[{self.constant(member)}]" for member in path)

    def given(self, name: str) -> str:
        return f"{self._event}.{name}"

    def is_given(self, name: str) -> str:
        return f"({self._event} != null && {self._event}.{name} !== undefined)"

    def is_there(self, text: str) -> str:
        return f"{text} != null"

    def constant(self, value: bool | int | float | str | None) -> str:
        if isinstance(value, str):
            return json.dumps(value)
        if value is None or isinstance(value, bool):
            return json.dumps(value)
        if isinstance(value, float) and not math.isfinite(value):
            return "NaN" if math.isnan(value) else "Infinity" if value > 0 else "-Infinity"
        return f"({value!r})" if value < 0 else repr(value)

    def active(self, state: str) -> str:
        return f"In('{state}')"

    def picked(self, condition: str, yes: str, no: str) -> str:
        return f"({condition} ? {yes} : {no})"

    def computed(self, sign: Sign, parts: list[str]) -> str:
        match sign:
            case Sign.EQUAL | Sign.UNEQUAL:
                return f"({parts[0]} {sign.value}= {parts[1]})"
            case Sign.REST:
                return f"((({parts[0]} % {parts[1]}) + {parts[1]}) % {parts[1]})"
            case Sign.FLOOR:
                return f"Math.floor({parts[0]} / {parts[1]})"
            case Sign.WHOLE:
                return f"Math.trunc({parts[0]})"
            case Sign.ABSOLUTE:
                return f"Math.abs({parts[0]})"
        return f"Math.{'min' if sign is Sign.SMALLEST else 'max'}({', '.join(parts)})"

    def milliseconds(self, delay: Term) -> str:
        return f"({self.term(delay)} / 1e6) + 'ms'"

    def statements(self, acts: Iterable[Set | If], indent: str) -> Iterator[str]:
        """The lines of assignments."""
        for act in acts:
            if isinstance(act, Set):
                yield f"{indent}{self.reference(act.name)} = {self.term(act.value)};"
                continue
            yield f"{indent}if ({self.condition(act.condition)}) {{"
            yield from self.statements(_assignments(act.then), indent + "  ")
            if act.otherwise:
                yield f"{indent}}} else {{"
                yield from self.statements(_assignments(act.otherwise), indent + "  ")
            yield f"{indent}}}"


class Python(Script):
    """`event` stands for what the event says, a dictionary."""

    and_, or_, not_, true, false, null = "and", "or", "not ", "True", "False", "None"

    def __init__(self, event: str = "_event.data", active: str = "In") -> None:
        self._event = event
        self._active = active

    def reference(self, name: str, path: tuple[str, ...] = ()) -> str:
        return name + "".join(f".get({member!r})" for member in path)

    def given(self, name: str) -> str:
        return f"{self._event}.get({name!r})"

    def is_given(self, name: str) -> str:
        return f"({self._event} or {{}}).get({name!r}, {self._active}) is not {self._active}"

    def is_there(self, text: str) -> str:
        return f"{text} is not None"

    def constant(self, value: bool | int | float | str | None) -> str:
        if isinstance(value, float) and not math.isfinite(value):
            return f"float('{value}')"
        if isinstance(value, str):
            return ascii(value)
        return f"({value!r})" if isinstance(value, int | float) and value < 0 else repr(value)

    def active(self, state: str) -> str:
        return f"{self._active}({state!r})"

    def picked(self, condition: str, yes: str, no: str) -> str:
        return f"({yes} if {condition} else {no})"

    def milliseconds(self, delay: Term) -> str:
        return f"str({self.term(delay)} / 1e6) + 'ms'"

    def condition(self, cond: Cond) -> str:
        found = super().condition(cond)
        return f"({found})" if isinstance(cond, Present | Inverse) else found

    def computed(self, sign: Sign, parts: list[str]) -> str:
        match sign:
            case Sign.EQUAL | Sign.UNEQUAL | Sign.REST | Sign.FLOOR:
                return f"({parts[0]} {sign.value} {parts[1]})"
        return f"{sign.value}({', '.join(parts)})"


def _assignments(acts: Iterable[object]) -> Iterator[Set | If]:
    return (act for act in acts if isinstance(act, Set | If))


__all__ = ["EcmaScript", "Python", "Script"]
