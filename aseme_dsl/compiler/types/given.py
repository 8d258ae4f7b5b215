"""Given: what activities, formulas and participants are given, and the types of parameters."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace

from aseme_dsl.amola.aip import DeclaredVariable
from aseme_dsl.amola.expression import (
    Conditional,
    Element,
    Member,
    Named,
    ParameterValue,
    Random,
    Value,
    VariableValue,
    walk,
)
from aseme_dsl.amola.liveness import Formula, names
from aseme_dsl.amola.messages import DOUBLE, INT, ChannelKind, Kind, Parameter, Type
from aseme_dsl.amola.statechart import Argument
from aseme_dsl.compiler.formula.formulas import Formulas, cut
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.builtins import reserved
from aseme_dsl.compiler.read.names import declared_twice, unknown
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.diagnostics import Diagnostic, Related, surely
from aseme_dsl.diagnostics.problems import names as of_names
from aseme_dsl.diagnostics.problems.absences import NoType
from aseme_dsl.diagnostics.problems.expressions import arguments as problems
from aseme_dsl.diagnostics.problems.expressions.bounds import ResultWithOtherBounds
from aseme_dsl.diagnostics.problems.expressions.values import RandomInCondition
from aseme_dsl.diagnostics.problems.names import ReservedName
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


def give(
    formulas: Formulas, scope: Scope, participants: Collection[str] = ()
) -> tuple[Formulas, tuple[Diagnostic, ...]]:
    """The formulas with their typed parameters, and with what each name in them is given.

    `participants` are the names of played participants, which are given nothing. Reports E308 to E310, E523
    and E524.
    """
    work = _Work(formulas, scope, frozenset(participants))
    parameters = work.parameters()
    given: dict[Formula, tuple[Argument, ...]] = {}
    formulas = replace(formulas, parameters=parameters)
    for name, item in formulas.named.items():
        own = inside_formula(scope, formulas, name)
        for node in names(item.formula):
            found = work.given(node, own, parameters)
            if found:
                given[node] = found
    return replace(formulas, given=given), tuple(work.diagnostics)


def inside_formula(scope: Scope, formulas: Formulas, name: str) -> Scope:
    """The scope of the control and the arguments of a formula: with its parameters, if it has any.

    Where their type is not known, that has been said.
    """
    written = formulas.named[name].parameters
    if not written:
        return scope
    known = {item.name: item.type for item in formulas.parameters.get(name, ())}
    own = {item.name.text: known.get(item.name.text) for item in written}
    return replace(scope, parameters={**scope.parameters, **own}, inputs=scope.inputs - own.keys())


@dataclass(slots=True)
class _Work:
    formulas: Formulas
    scope: Scope
    participants: frozenset[str]
    diagnostics: list[Diagnostic] = field(default_factory=list)
    unsure: set[str] = field(default_factory=set)
    """The formulas of whose parameters something is wrong: their uses are not reported again."""

    # ---- parameters ------------------------------------------------------------------------------

    def parameters(self) -> dict[str, tuple[Parameter, ...]]:
        """The parameters of each formula that has any, with their types."""
        written = {name: item for name, item in self.formulas.named.items() if item.parameters}
        known: dict[tuple[str, str], tuple[Type, Span]] = {}
        for name, item in written.items():
            self._check_names(name, item)
            for parameter in item.parameters:
                kind = self._said(name, parameter)
                if kind is not None:
                    known[name, parameter.name.text] = (kind, parameter.span)
        changed = bool(written)
        while changed:
            changed = False
            for name, item in written.items():
                for parameter in item.parameters:
                    key = (name, parameter.name.text)
                    if key not in known and parameter.type is None:
                        found = next(self._passed_on(item, parameter.name.text, known), None)
                        if found is not None:
                            known[key] = found
                            changed = True
        result: dict[str, tuple[Parameter, ...]] = {}
        for name, item in written.items():
            found_parameters = []
            for parameter in item.parameters:
                kind = self._settled(name, item, parameter, known)
                if kind is not None:
                    text = parameter.name.text
                    found_parameters.append(Parameter(text, kind, parameter.name.span))
            result[name] = tuple(found_parameters)
        return result

    def _check_names(self, name: str, item: tree.NamedFormula) -> None:
        if name == self.formulas.root:
            self.unsure.add(name)
            span = item.parameters[0].span.to(item.parameters[-1].span)
            self.diagnostics.append(Diagnostic(problems.RootWithParameters(name), span))
        seen: dict[str, tree.Name] = {}
        for parameter in item.parameters:
            reason = reserved(parameter.name.text)
            if reason is not None:
                problem = ReservedName("parameter", parameter.name.text, reason)
                self.diagnostics.append(Diagnostic(problem, parameter.name.span))
            first = seen.setdefault(parameter.name.text, parameter.name)
            if first is not parameter.name:
                self.unsure.add(name)
                self.diagnostics.append(declared_twice("parameter", parameter.name, first.span))

    def _said(self, formula: str, parameter: tree.FormulaParameter) -> Type | None:
        if parameter.type is None:
            return None
        symbols = self.scope.symbols
        kind = symbols.type_named(parameter.type.text)
        if kind is None:
            self.unsure.add(formula)
            if not symbols.is_excused(parameter.type.text):
                found = unknown(NoType, parameter.type, symbols.type_names)
                self.diagnostics.append(found)
        return kind

    def _passed_on(
        self, item: tree.NamedFormula, parameter: str, known: Mapping[tuple[str, str], tuple[Type, Span]]
    ) -> Iterator[tuple[Type, Span]]:
        """The types with which a parameter is passed on to activities and other formulas, with the places."""
        for node in names(item.formula):
            for place, argument in enumerate(node.arguments):
                if _path(argument.value) == parameter:
                    kind = self._wanted(node.name, place, known)
                    if kind is not None:
                        yield kind, argument.span

    def _wanted(
        self, name: str, place: int, known: Mapping[tuple[str, str], tuple[Type, Span]]
    ) -> Type | None:
        formula = self.formulas.named.get(name)
        if formula is not None:
            if place >= len(formula.parameters):
                return None
            found = known.get((name, formula.parameters[place].name.text))
            return found[0] if found is not None else None
        form = self.scope.symbols.activities.get(name)
        return form.parameters[place].type if form is not None and place < len(form.parameters) else None

    def _settled(
        self,
        name: str,
        item: tree.NamedFormula,
        parameter: tree.FormulaParameter,
        known: Mapping[tuple[str, str], tuple[Type, Span]],
    ) -> Type | None:
        text = parameter.name.text
        first = known.get((name, text))
        if first is None:
            self.unsure.add(name)
            if name == self.formulas.root:
                return None
            if parameter.type is None and not self._depends_on_unsure(item, text):
                untyped = problems.UntypedParameter(name, text)
                self.diagnostics.append(Diagnostic(untyped, parameter.name.span))
            return None
        for kind, span in self._passed_on(item, text, known):
            if kind != first[0] and parameter.type is None:
                self.unsure.add(name)
                related = (Related(first[1], f"as {first[0]}"),)
                two_types = problems.ParameterOfTwoTypes(text, str(first[0]), str(kind))
                self.diagnostics.append(Diagnostic(two_types, span, related))
                return None
        return first[0]

    def _depends_on_unsure(self, item: tree.NamedFormula, parameter: str) -> bool:
        """Whether it is passed on to something whose own parameters are not known."""
        symbols = self.scope.symbols
        return any(
            node.name in self.unsure or symbols.is_excused(node.name)
            for node in names(item.formula)
            if any(_path(argument.value) == parameter for argument in node.arguments)
        )

    # ---- arguments -------------------------------------------------------------------------------

    def given(
        self, node: Formula, scope: Scope, parameters: Mapping[str, tuple[Parameter, ...]]
    ) -> tuple[Argument, ...]:
        """What a name is given, by parameter; nothing where something is wrong with that."""
        wanted = self._wordsof(node, parameters)
        if wanted is None:
            return ()
        if len(wanted) != len(node.arguments):
            self._wrong_number(node, wanted)
            return ()
        found: list[Argument] = []
        for parameter, argument in zip(wanted, node.arguments, strict=True):
            assert isinstance(argument.value, tree.Expression)
            value, problems = type_value(argument.value, scope, parameter.type)
            self.diagnostics += problems
            if value is not None and self._is_lasting(value):
                found.append(Argument(parameter.name, value))
        return tuple(found) if len(found) == len(wanted) else ()

    def _wordsof(
        self, node: Formula, parameters: Mapping[str, tuple[Parameter, ...]]
    ) -> Sequence[Parameter] | None:
        """What a name wants; None, reported if need be, where that is not known."""
        symbols = self.scope.symbols
        if node.name in self.formulas.named:
            return None if node.name in self.unsure else parameters.get(node.name, ())
        if node.name in self.participants:
            return ()
        form = symbols.activities.get(node.name)
        if symbols.is_excused(node.name):
            return None
        if form is None and node.arguments:
            near = surely(node.name, (*symbols.activities, *parameters))
            words = tuple(_word(a.text, n) for n, a in enumerate(node.arguments, 1))
            problem = problems.GivenWithoutParameters(node.name, near, words, _in_sequence(node))
            self.diagnostics.append(Diagnostic(problem, node.span))
            return None
        return form.parameters if form is not None else ()

    def _wrong_number(self, node: Formula, wanted: Sequence[Parameter]) -> None:
        formula = self.formulas.named.get(node.name)
        form = self.scope.symbols.activities.get(node.name)
        related: tuple[Related, ...] = ()
        if formula is not None:
            related = (Related(formula.name.span, "the formula"),)
        elif form is not None:
            related = (Related(form.span, "what is said of it"),)
        problem = problems.WrongNumberGiven(
            node.name, tuple(map(str, wanted)), len(node.arguments), _in_sequence(node)
        )
        self.diagnostics.append(Diagnostic(problem, node.span, related))

    def _is_lasting(self, value: Value) -> bool:
        """Whether what it reads is still there when the state is entered: a signal may be consumed (E524)."""
        for part in walk(value):
            if isinstance(part, Member) and part.channel.comm is ChannelKind.SIGNAL:
                self.diagnostics.append(Diagnostic(problems.SignalGiven(str(part.channel)), value.span))
                return False
        return True


# ---- participants ---------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Supplied:
    """The values of a participant's inputs, and the variables of the role that get its results."""

    inputs: tuple[tuple[str, Value], ...] = ()
    results: tuple[tuple[str, str], ...] = ()


def supplied_names(party: tree.Participant) -> tuple[tree.Name, ...]:
    """The inputs and results of a participant, as they are written."""
    return (*(item.name for item in party.inputs), *(item.name for item in party.results))


def supply(
    written: tree.Plays,
    inputs: Iterable[DeclaredVariable],
    results: Collection[str],
    variables: Iterable[DeclaredVariable],
    scope: Scope,
) -> tuple[Supplied, tuple[Diagnostic, ...]]:
    """What `plays` says of inputs and results, in the scope of the role: E590, E591, E592, E526."""
    found: list[Diagnostic] = []
    said = {item.abstract.text: item for item in reversed(written.bindings)}
    values: list[tuple[str, Value]] = []
    for wanted in inputs:
        if wanted.name not in said:
            missing = of_names.InputNotSupplied(wanted.name, str(wanted.type), written.participant.text)
            place = written.protocol.span.to((written.alias or written.participant).span)
            found.append(Diagnostic(missing, place, (Related(wanted.span, "the input"),)))
            continue
        value, wrong = type_value(said[wanted.name].expression, scope, wanted.type)
        found += wrong
        if value is not None:
            wrong = tuple(_unsuitable(wanted.name, value))
            found += wrong
            if not wrong:
                values.append((wanted.name, value))
    targets: list[tuple[str, str]] = []
    for result in (item for item in variables if item.name in results and item.name in said):
        binding = said[result.name]
        target = scope.variables.get(binding.own.text) if binding.own is not None else None
        if target is None or (binding.own is not None and binding.own.text in scope.parameters):
            known = tuple(name for name, (_, kind) in scope.variables.items() if kind == result.type)
            found.append(Diagnostic(of_names.ResultNotVariable(result.name, known), binding.expression.span))
        elif target[1] != result.type and (target[1], result.type) != (DOUBLE, INT):
            related = (Related(result.span, "the result"),)
            problem = of_names.ResultOfOtherType(result.name, str(result.type), str(target[1]))
            found.append(Diagnostic(problem, binding.expression.span, related))
        elif (own := scope.bounds.get(target[0])) != result.bounds:
            related = (Related(result.span, "the result"),)
            named = (str(item) if item is not None else "" for item in (result.bounds, own))
            unlike = ResultWithOtherBounds(result.name, target[0], *named)
            found.append(Diagnostic(unlike, binding.expression.span, related))
        else:
            targets.append((result.name, target[0]))
    return Supplied(tuple(values), tuple(targets)), tuple(found)


def _unsuitable(name: str, value: Value) -> Iterable[Diagnostic]:
    """E592 for a signal, which the first look consumes; E526 for random values, which differ at each look."""
    if value.type.kind is Kind.MESSAGE and not _is_kept(value):
        yield Diagnostic(of_names.InputMadeAnew(name), value.span)
        return
    for part in walk(value):
        if isinstance(part, Member) and part.channel.comm is ChannelKind.SIGNAL:
            yield Diagnostic(of_names.InputFromSignal(name, str(part.channel)), part.span)
            return
        if isinstance(part, Random):
            yield Diagnostic(RandomInCondition(), part.span)
            return


def _is_kept(message: Value) -> bool:
    """Whether a message is one that is kept somewhere, so that its members can be read there."""
    match message:
        case Named(expression=inner):
            return _is_kept(inner)
        case Conditional(yes=yes, no=no):
            return _is_kept(yes) and _is_kept(no)
    return isinstance(message, Member | VariableValue | Element | ParameterValue)


def _path(value: object) -> str | None:
    """The single name that an argument is."""
    while isinstance(value, tree.Parenthesised):
        value = value.inner
    return value.text if isinstance(value, tree.Path) and len(value.segments) == 1 else None


def _word(text: str, number: int) -> str:
    return text if text.isidentifier() else f"x{number}"


def _in_sequence(node: Formula) -> str:
    """How it would be written if the parentheses were those of a group."""
    inside = " . ".join(argument.text for argument in node.arguments)
    return cut(f"{node.name} . {inside if len(node.arguments) == 1 else f'({inside})'}")


__all__ = ["Supplied", "give", "inside_formula", "supplied_names", "supply"]
