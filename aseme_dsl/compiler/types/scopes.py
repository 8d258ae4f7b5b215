"""Scopes: what is visible in a file, in a role and in a participant, with its variables and lets typed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.amola.aip import AgentMessage, DeclaredVariable
from aseme_dsl.amola.expression import Literal
from aseme_dsl.amola.messages import AGENT, BOOL, BYTES, DOUBLE, STRING, Bounds, Kind, Type, list_of
from aseme_dsl.amola.python_names import taken_as_member
from aseme_dsl.compiler.names.bounds import bounds_of, list_variable
from aseme_dsl.compiler.names.scope import Party, Scope, TypedLet
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.blocks import lists, with_exchange
from aseme_dsl.compiler.read.builtins import OTHER_SPELLINGS, PERFORMATIVES, reserved
from aseme_dsl.compiler.read.names import declared_twice, unknown, unknown_performative
from aseme_dsl.compiler.types.typecheck import constant, measure, paths_in, type_value
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.absences import NoMessage, NoType
from aseme_dsl.diagnostics.problems.expressions.paths import LetInItself
from aseme_dsl.diagnostics.problems.expressions.values import NoTypeOfVariable
from aseme_dsl.diagnostics.problems.names import ReservedName
from aseme_dsl.diagnostics.problems.talk import InitialAgent
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class TypedRole:
    """The scope of an `srm` or `statechart`, and its variables (their keys are their names)."""

    scope: Scope
    variables: tuple[DeclaredVariable, ...]


@dataclass(frozen=True, slots=True)
class TypedParticipant:
    """The scope of a participant's control, its variables (their keys are their names) and its messages."""

    scope: Scope
    variables: tuple[DeclaredVariable, ...]
    sends: tuple[AgentMessage, ...]
    receives: tuple[AgentMessage, ...]
    inputs: tuple[DeclaredVariable, ...] = ()
    results: tuple[str, ...] = ()


def global_scope(symbols: Symbols) -> tuple[Scope, tuple[Diagnostic, ...]]:
    """The scope of a file's top: the symbols and the files' lets."""
    return with_lets(Scope(symbols), symbols.lets)


def role_scope(owner: tree.Srm | tree.Statechart, outer: Scope) -> tuple[TypedRole, tuple[Diagnostic, ...]]:
    """The scope inside a role: `outer` (the global one) with the role's variables and lets."""
    variables, found = type_variables(owner.variables, outer)
    scope = replace(outer, variables=_keys(variables), bounds=_bounds_of(variables))
    scope, more = with_lets(scope, owner.lets)
    return TypedRole(scope, variables), found + more


def protocol_scopes(
    protocol: tree.Aip, outer: Scope
) -> tuple[dict[str, TypedParticipant], tuple[Diagnostic, ...]]:
    """The scope of each participant of a protocol, by its name: the protocol's lets and its own names.

    A participant that is declared twice is reported and counts the first time.
    """
    diagnostics: list[Diagnostic] = []
    first: dict[str, tree.Participant] = {}
    listing = {item.span for item in protocol.participants if lists(item)}
    protocol = with_exchange(protocol)
    for item in protocol.participants:
        if first.setdefault(item.name.text, item) is not item:
            diagnostics.append(declared_twice("participant", item.name, first[item.name.text].name.span))
    parties: dict[str, Party] = {}
    for name, item in first.items():
        sends, wrong = _messages(item.sends, outer)
        diagnostics += wrong
        receives, wrong = _messages(item.receives, outer)
        diagnostics += wrong
        variables = frozenset(
            name.text for name in (*(v.name for v in _variables_of(item)), *(v.name for v in item.inputs))
        )
        unread = _words(item.sends, sends) | _words(item.receives, receives)
        parties[name] = Party(name, sends, receives, variables, item.name.span, unread, item.span in listing)
    scope, wrong_lets = with_lets(replace(outer, parties=parties), protocol.lets)
    diagnostics += wrong_lets
    typed = {}
    for name, item in first.items():
        # An input is typed as a variable, so that both cannot have one name.
        given = [tree.Var(one.name, one.type, None, one.span) for one in item.inputs]
        names = {one.name.span for one in item.inputs}
        declared, wrong_variables = type_variables((*_variables_of(item), *given), scope)
        own_variables = tuple(one for one in declared if one.span not in names)
        inputs = tuple(one for one in declared if one.span in names)
        own = replace(
            scope,
            participant=name,
            variables=_keys(own_variables),
            bounds=_bounds_of(own_variables),
            parameters={one.name.text: None for one in item.inputs} | {one.name: one.type for one in inputs},
            inputs=frozenset(one.name for one in inputs),
        )
        own, wrong_lets = with_lets(own, item.lets)
        diagnostics += (*wrong_variables, *wrong_lets)
        results = tuple(dict.fromkeys(one.name.text for one in item.results))
        typed[name] = TypedParticipant(
            own, own_variables, parties[name].sends, parties[name].receives, inputs, results
        )
    return typed, tuple(diagnostics)


def _variables_of(item: tree.Participant) -> tuple[tree.Var, ...]:
    """The variables of a participant, its results among them."""
    return (*item.variables, *item.results)


def _keys(variables: Iterable[DeclaredVariable]) -> dict[str, tuple[str, Type]]:
    return {item.name: (item.name, item.type) for item in variables}


def _bounds_of(variables: Iterable[DeclaredVariable]) -> dict[str, Bounds]:
    return {item.name: item.bounds for item in variables if item.bounds is not None}


# ---- variables ---------------------------------------------------------------------------------


def type_variables(
    variables: Sequence[tree.Var], scope: Scope
) -> tuple[tuple[DeclaredVariable, ...], tuple[Diagnostic, ...]]:
    """Variables with their types and initial values; by default 0, false, "", the first constant or nothing.

    One whose type is wrong is missing; one whose initial value is wrong has the default.
    """
    found: dict[str, DeclaredVariable] = {}
    diagnostics: list[Diagnostic] = []
    kinds = {item.name.text: _kind_of(item, scope) for item in variables}
    # All are visible: if an initial value names a variable, the error says that this is not a constant.
    scope = replace(scope, variables={name: (name, kind) for name, kind in kinds.items() if kind is not None})
    for item in variables:
        name = item.name
        reason = reserved(name.text)
        if reason is None and taken_as_member(name.text):
            reason = "generated"
        if reason is not None:
            diagnostics.append(Diagnostic(ReservedName("variable", name.text, reason), name.span))
        if name.text in found:
            diagnostics.append(declared_twice("variable", name, found[name.text].span))
            continue
        kind, wrong = _variable_type(item.type, scope)
        diagnostics += wrong
        if kind is None:
            if item.initial is not None:
                diagnostics += type_value(item.initial, scope)[1]
            continue
        if item.is_list:
            kind, length, wrong = list_variable(item, kind)
            diagnostics += wrong
            initial = Literal("", kind, item.span)
            found[name.text] = DeclaredVariable(name.text, kind, initial, name.span, length=length)
            continue
        initial = default_value(kind, scope)
        if item.initial is not None and kind.begins_unset:
            diagnostics.append(Diagnostic(InitialAgent(str(kind)), item.initial.span))
        elif item.initial is not None:
            written, problems = constant(item.initial, kind, scope)
            diagnostics += problems
            initial = written or initial
        bounds, wrong = bounds_of(item, kind, initial)
        diagnostics += wrong
        found[name.text] = DeclaredVariable(
            name.text, kind, replace(initial, span=item.span), name.span, bounds
        )
    return tuple(found.values()), tuple(diagnostics)


def _kind_named(name: str, scope: Scope) -> Type | None:
    """The type of that name; only variables hold agents."""
    return scope.symbols.type_named(name) or (AGENT if name == str(AGENT) else None)


def _kind_of(item: tree.Var, scope: Scope) -> Type | None:
    kind = _kind_named(item.type.text, scope)
    return list_of(kind) if item.is_list and kind is not None else kind


def _variable_type(name: tree.Name, scope: Scope) -> tuple[Type | None, tuple[Diagnostic, ...]]:
    kind = _kind_named(name.text, scope)
    usable = [*scope.symbols.type_names, str(AGENT)]
    if kind is None:
        if scope.symbols.is_excused(name.text):
            return None, ()
        other = OTHER_SPELLINGS.get(name.text)
        if other:
            return None, (Diagnostic(NoType(name.text, None, (), spelling=other), name.span, fix=other),)
        return None, (unknown(NoType, name, set(usable) - {"bytes"}),)
    if kind == BYTES:
        return None, (Diagnostic(NoTypeOfVariable(), name.span),)
    return kind, ()


def default_value(kind: Type, scope: Scope) -> Literal:
    """What a variable of this type holds when nothing is said: as in Protocol Buffers."""
    span = scope.symbols.nowhere
    if kind.kind is Kind.ENUM:
        enum = scope.symbols.enum(kind.name)
        return Literal(enum.constants[0][0] if enum and enum.constants else "", kind, span)
    if kind == DOUBLE:
        return Literal(0.0, kind, span)
    if kind == BOOL:
        return Literal(False, kind, span)
    return Literal("" if kind == STRING or kind.begins_unset else 0, kind, span)


# ---- messages of participants ------------------------------------------------------------------


def _messages(
    written: Iterable[tree.AgentMessage], scope: Scope
) -> tuple[tuple[AgentMessage, ...], tuple[Diagnostic, ...]]:
    found: dict[tuple[str, str], AgentMessage] = {}
    diagnostics: list[Diagnostic] = []
    for item in written:
        performative, message = item.performative, item.message
        if performative.text not in PERFORMATIVES:
            diagnostics.append(unknown_performative(performative))
            continue
        if scope.symbols.message(message.text) is None:
            if not scope.symbols.is_excused(message.text):
                pool = [one.name for one in scope.symbols.messages]
                diagnostics.append(unknown(NoMessage, message, pool))
            continue
        key = (performative.text, message.text)
        if key in found:
            called = tree.Name(f"{performative} {message}", item.span)
            diagnostics.append(declared_twice("message", called, found[key].span))
            continue
        by = tuple(dict.fromkeys(name.text for name in item.by))
        found[key] = AgentMessage(performative.text, message.text, item.span, by, item.repeatedly)
    return tuple(found.values()), tuple(diagnostics)


def _words(written: Iterable[tree.AgentMessage], understood: Iterable[AgentMessage]) -> frozenset[str]:
    """The performatives and messages of what was not understood."""
    known = {(item.performative, item.message) for item in understood}
    said = {(item.performative.text, item.message.text) for item in written}
    return frozenset(word for pair in said - known for word in pair)


# ---- lets --------------------------------------------------------------------------------------


def with_lets(outer: Scope, lets: Sequence[tree.Let]) -> tuple[Scope, tuple[Diagnostic, ...]]:
    """`outer` with these lets, which may use each other in any order but not in a circle (E510).

    A let hides one of the same name further out; beside a variable of the same scope it is an error.
    """
    diagnostics: list[Diagnostic] = []
    written: dict[str, tree.Let] = {}
    for item in lets:
        first = written.setdefault(item.name.text, item)
        if first is not item:
            diagnostics.append(declared_twice("let", item.name, first.name.span))
            continue
        reason = reserved(item.name.text)
        if item.name.text in outer.variables or item.name.text in outer.parameters:
            reason = "variable"
        if reason is not None:
            diagnostics.append(Diagnostic(ReservedName("let", item.name.text, reason), item.name.span))
    order, circles = _in_order(written)
    in_circle = {item.name.text for circle, _ in circles for item in circle}
    diagnostics += [_circle(circle, use) for circle, use in circles]
    typed_lets = dict(outer.lets)  # grows below, before other code can see it
    scope = replace(outer, lets=typed_lets)
    for item in order:
        value = None
        if item.name.text not in in_circle:
            value, problems = type_value(item.expression, scope)
            diagnostics += problems
        height, size = (0, 0) if value is None else measure(value, scope)
        typed_lets[item.name.text] = TypedLet(item.name.text, value, height, size, item.name.span)
    return scope, tuple(diagnostics)


_Circle = tuple[list[tree.Let], tree.Name]
"""Lets that use each other, and the use that closes the circle."""


def _in_order(written: Mapping[str, tree.Let]) -> tuple[list[tree.Let], list[_Circle]]:
    """The lets, each after those that it uses, and what goes round in circles."""
    uses = {
        name: [path.segments[0] for path in paths_in(item.expression) if path.segments[0].text in written]
        for name, item in written.items()
    }
    order: list[tree.Let] = []
    circles: list[_Circle] = []
    started: set[str] = set()
    for name in written:
        if name in started:
            continue
        started.add(name)
        chain = {name: iter(uses[name])}
        while chain:
            inner = next(reversed(chain))
            for use in chain[inner]:
                if use.text in chain:
                    around = list(chain)
                    circles.append(([written[item] for item in around[around.index(use.text) :]], use))
                elif use.text not in started:
                    started.add(use.text)
                    chain[use.text] = iter(uses[use.text])
                    break
            else:
                order.append(written[inner])
                del chain[inner]
    return order, circles


def _circle(circle: Sequence[tree.Let], use: tree.Name) -> Diagnostic:
    path = tuple(item.name.text for item in (*circle, circle[0]))
    related = (Related(use.span, "the circle closes here"),)
    return Diagnostic(LetInItself(path), circle[0].name.span, related)
