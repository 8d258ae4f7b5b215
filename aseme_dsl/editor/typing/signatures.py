"""Signatures: which arguments the call takes that is being written."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.amola.messages import Function, Type
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.builtins import FORMS
from aseme_dsl.editor.files.known import Known
from aseme_dsl.editor.files.place import place_at
from aseme_dsl.editor.typing.around import around
from aseme_dsl.editor.typing.ask import Ask
from aseme_dsl.editor.typing.completion import parameters_of, slot_of
from aseme_dsl.editor.typing.slots import Call
from aseme_dsl.editor.typing.values import form_parameters, signature, type_of
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source


@dataclass(frozen=True, slots=True)
class Signature:
    """How something is called: the whole, and where in it each parameter stands."""

    label: str
    parameters: tuple[tuple[int, int], ...]
    documentation: str


@dataclass(frozen=True, slots=True)
class Signatures:
    """All ways to make a call; the one that fits what has been written, and the parameter that is next."""

    signatures: tuple[Signature, ...]
    active: int
    parameter: int


def signatures(source: Source, offset: int, known: Known) -> Signatures | None:
    """What the innermost call around the cursor takes; None outside of calls, and of what is not known."""
    place = place_at(source.text, offset)
    if place.inside == "comment":
        return None
    block = around(place, known)
    for expected in place.expected:
        ask = Ask(place, expected, known, block, source.path)
        slot = slot_of(ask)
        if slot is None or not slot.calls:
            continue
        call = slot.calls[-1]
        if expected.terminal in ("FormulaToken", "ProcessToken"):
            return _of_formula(call, parameters_of(ask, call.function))
        return _of_call(call, ask.scope, known, source.text)
    return None


def _of_formula(call: Call, parameters: list[tuple[str, str]]) -> Signatures | None:
    """What an activity or a formula is given where a formula uses it."""
    parts = [f"{name} : {kind}" if kind else name for name, kind in parameters]
    if not parts:
        return None
    label = f"{call.function}({', '.join(parts)})"
    return Signatures((_made(label, parts, ""),), 0, call.argument)


def _of_call(call: Call, scope: Scope, known: Known, text: str) -> Signatures | None:
    if call.function in FORMS:
        example = FORMS[call.function]
        return Signatures((_made(example, form_parameters(call.function), ""),), 0, call.argument)
    overloads = scope.symbols.overloads(call.function)
    if not overloads:
        return None
    found = tuple(
        _made(
            signature(function),
            [f"{kind} {name}" for name, kind in function.parameters],
            known.documentation(function.span),
        )
        for function in overloads
    )
    given = [type_of(scope, tokens, text) for tokens in call.given]
    fitting = [index for index, function in enumerate(overloads) if _fits(function, call.argument, given)]
    return Signatures(found, fitting[0] if fitting else 0, call.argument)


def _fits(function: Function, argument: int, given: Sequence[Type | None]) -> bool:
    kinds = [kind for _, kind in function.parameters]
    return len(kinds) > argument and all(
        kind is None or kind == wanted for kind, wanted in zip(given, kinds, strict=False)
    )


def _made(label: str, parts: list[str], documentation: str) -> Signature:
    begin = label.index("(") + 1
    places = []
    for part in parts:
        begin = label.index(part, begin)
        places.append((begin, begin + len(part)))
        begin += len(part)
    return Signature(label, tuple(places), documentation)


__all__ = ["Signature", "Signatures", "signatures"]
