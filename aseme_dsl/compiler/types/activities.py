"""Activities: what the roles say of them, resolved, and merged into one statement an activity."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Literal

from aseme_dsl.amola.messages import Channel, ChannelKind, Parameter
from aseme_dsl.amola.srm import Activity, Guarantee, Subscription
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.paths import channel_of
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.library import providers
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types.guarantees import read_guarantees
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems import activities as problems
from aseme_dsl.diagnostics.problems.absences import NoKindOfActivity
from aseme_dsl.diagnostics.problems.expressions.absences import NoTopicToRead, NoVariable
from aseme_dsl.grammar.text import tree

KINDS = ("thread", "async", "process", "step")


def type_activity(
    written: tree.Activity, scope: Scope, played: Collection[str] = ()
) -> tuple[Activity, tuple[Diagnostic, ...]]:
    """One role's statement about an activity; `kind` is "" where it does not say. `scope` is the role's.

    `played` are the variables of the participants that the role plays, which are there for its activities.
    """
    checker = Checker(scope)
    kind = ""
    if written.kind is not None:
        if written.kind.text in KINDS:
            kind = written.kind.text
        else:
            checker.diagnostics.append(unknown(NoKindOfActivity, written.kind, KINDS))
    variables_read: list[str] = []
    reads = [_read(checker, item, variables_read, played) for item in written.reads]
    writes: list[Channel] = []
    variables: list[str] = []
    for path in written.writes:
        _write(checker, path, writes, variables, played)
    activity = Activity(
        written.name.text,
        tuple(name.text for name in written.uses),
        None if written.every is None else written.every.nanoseconds,
        None if written.takes is None else written.takes.nanoseconds,
        kind,
        tuple(item for item in reads if item is not None),
        tuple(dict.fromkeys(writes)),
        tuple(dict.fromkeys(variables)),
        written.span,
        None if written.within is None else written.within.nanoseconds,
        tuple(dict.fromkeys(name.text for name in written.ends)),
        _parameters(written, scope.symbols),
        tuple(dict.fromkeys(variables_read)),
        written.simulated is not None,
        written.waits is not None,
        tuple(read_guarantees(checker, written, writes)),
    )
    if written.waits is not None:
        for word in _beside_waits(written):
            checker.report(problems.WaitsBeside(written.name.text, word), written.waits)
    if written.within is not None and written.within.nanoseconds <= 0:
        checker.report(problems.NoDeadline(), written.within.span)
    return activity, tuple(checker.diagnostics)


def _beside_waits(written: tree.Activity) -> Iterator[str]:
    """The other clauses of an activity."""
    clauses = {
        "(…)": written.parameters,
        "every": written.every,
        "takes": written.takes,
        "simulated": written.simulated,
        "within": written.within,
        "as": written.kind,
        "uses": written.uses,
        "reads": written.reads,
        "writes": written.writes,
        "ends": written.ends,
        "guarantees": written.guarantees,
    }
    return (word for word, clause in clauses.items() if clause)


def _parameters(written: tree.Activity, symbols: Symbols) -> tuple[Parameter, ...]:
    """Those whose type is known; of the others it has been said what is wrong."""
    found: dict[str, Parameter] = {}
    for item in written.parameters:
        kind = symbols.type_named(item.type.text)
        if kind is not None:
            found.setdefault(item.name.text, Parameter(item.name.text, kind, item.name.span))
    return tuple(found.values())


def _read(
    checker: Checker, written: tree.ActivityRead, variables: list[str], played: Collection[str]
) -> Subscription | None:
    """`reads vision.state.Ball for 2s`, a whole topic, or (then None) the variable `budget` of the role."""
    path, history = written.path, written.history
    if len(path.segments) == 1:
        topic = path.segments[0]
        symbols = checker.scope.symbols
        if written.reach == "on" and (topic.text in checker.scope.variables or topic.text in played):
            variables.append(topic.text)
            if symbols.topic(topic.text) is None:
                if history is not None:
                    checker.report(problems.HistoryOfVariable(), history.span)
                return None
        if symbols.topic(topic.text) is None:
            if not symbols.is_excused(topic.text):
                pool = [*(item.name for item in symbols.topics), *checker.scope.variables, *played]
                libraries = providers(topic.text, "topic")
                carried = next(map(str, symbols.channels_of(topic.text)), None)
                checker.diagnostics.append(
                    unknown(NoTopicToRead, topic, pool, _meant(checker, topic), carried, libraries=libraries)
                )
            return None
        if history is not None:
            checker.report(problems.HistoryOfTopic(topic.text, history.span.text), history.span)
        return Subscription(None, topic.text, written.reach, 0, None, written.span)
    found = channel_of(checker, path)
    if found is None:
        return None
    host, channel, used = found
    if len(path.segments) > used:
        whole = ".".join(item.text for item in path.segments[:used])
        checker.report(problems.PartOfMessageUsed("reads", whole), path.segments[used].span)
    if written.reach != "on":
        checker.report(problems.ReachOfMessage(written.reach, channel.topic), path.span)
        return None
    kept = 0
    if history is not None and channel.comm is not ChannelKind.DATA:
        problem = problems.HistoryOfOther(str(channel), str(channel.comm))
        checker.report(problem, path.segments[used - 2].span)
    elif history is not None:
        kept = history.nanoseconds
    return Subscription(channel, channel.topic, written.reach, kept, host, written.span)


def _meant(checker: Checker, name: tree.Name) -> Literal["message", "let"] | None:
    """What is called like a topic that there is not."""
    if checker.scope.symbols.message(name.text) is not None:
        return "message"
    return "let" if name.text in checker.scope.lets else None


def _write(
    checker: Checker,
    path: tree.Path,
    channels: list[Channel],
    variables: list[str],
    played: Collection[str],
) -> None:
    """`writes vision.state.Ball` or the variable `budget` of the role."""
    scope = checker.scope
    first = path.segments[0]
    if len(path.segments) == 1:
        if first.text in scope.variables or first.text in played:
            variables.append(first.text)
        elif first.text in scope.lets:
            related = (Related(scope.lets[first.text].span, "declared here"),)
            checker.report(problems.LetWritten(first.text), path.span, related)
        elif not scope.symbols.is_excused(first.text):
            pool = {*scope.variables, *played}
            is_topic = scope.symbols.topic(first.text) is not None
            carried = next(map(str, scope.symbols.channels_of(first.text)), None)
            checker.diagnostics.append(unknown(NoVariable, first, pool, is_topic, carried))
        return
    channel = channel_of(checker, path)
    if channel is None:
        return
    host, written, used = channel
    if host is not None:
        checker.report(problems.PublishesForOther(), path.segments[0].span)
        return
    if len(path.segments) > used:
        checker.report(problems.PartOfMessageUsed("publishes", str(written)), path.segments[used].span)
    channels.append(written)


# ---- merging -----------------------------------------------------------------------------------

_CLAUSES = {
    "uses": "uses",
    "every": "every",
    "takes": "takes",
    "kind": "as",
    "reads": "reads",
    "writes": "writes",
    "reads_variables": "reads",
    "writes_variables": "writes",
    "within": "within",
    "ends": "ends",
    "parameters": "parameters",
    "guarantees": "guarantees",
}


_NOTHING = (None, "", ())
"""What a clause has that is not there."""


def by_name(statements: Iterable[Activity]) -> dict[str, tuple[Activity, ...]]:
    """What is said of each activity, in order."""
    of_name: dict[str, list[Activity]] = {}
    for item in statements:
        of_name.setdefault(item.name, []).append(item)
    return {name: tuple(items) for name, items in of_name.items()}


def merge_activity(statements: Sequence[Activity]) -> tuple[Activity, tuple[Diagnostic, ...]]:
    """All that is said of one activity: same or disjoint clauses join, different ones are E203.

    `kind` is "thread" where no role says otherwise. Variables belong to the roles, so each role's are added.
    Where one role says `simulated`, it is so for all; then something has to say how long it takes (W201).
    Where one role says `waits`, no role says anything else (E227).
    """
    diagnostics: list[Diagnostic] = []
    first, *others = statements
    clauses: dict[str, object] = {}
    said = {clause: first for clause in _CLAUSES if getattr(first, clause) not in _NOTHING}
    for item in others:
        for clause, word in _CLAUSES.items():
            value = getattr(item, clause)
            if value in _NOTHING:
                continue
            other = said.setdefault(clause, item)
            if clause in ("reads_variables", "writes_variables"):
                known = clauses.get(clause, getattr(first, clause))
                clauses[clause] = tuple(dict.fromkeys((*_items(known), *_items(value))))
            elif other is item:
                clauses[clause] = value
            elif _different(getattr(other, clause), value):
                related = (Related(other.span, "the other statement"),)
                diagnostics.append(Diagnostic(problems.TwoStatements(item.name, word), item.span, related))
    if not clauses.get("kind", first.kind):
        clauses["kind"] = "thread"
    waiting = next((item for item in statements if item.waits), None)
    if waiting is not None:
        clauses["waits"] = True
        for item in statements:
            beside = None if item.waits else _said_word(item)
            if beside is not None:
                related = (Related(waiting.span, "here it waits"),)
                diagnostics.append(Diagnostic(problems.WaitsBeside(item.name, beside), item.span, related))
    simulated = next((item for item in statements if item.simulated), None)
    if simulated is not None:
        clauses["simulated"] = True
    merged = replace(first, **clauses) if clauses else first  # type: ignore[arg-type]
    if simulated is not None and merged.takes is None:
        diagnostics.append(Diagnostic(problems.SimulatedWithoutTime(merged.name), simulated.span))
    return merged, tuple(diagnostics)


def _said_word(item: Activity) -> str | None:
    """A clause that is said of an activity, if there is one."""
    if item.simulated:
        return "simulated"
    return next((word for clause, word in _CLAUSES.items() if getattr(item, clause) not in _NOTHING), None)


def _different(first: object, second: object) -> bool:
    """Lists are compared without their order (but for parameters), and reads without their places."""
    if isinstance(first, tuple) and any(isinstance(item, Parameter) for item in first):
        return [str(item) for item in first] != [str(item) for item in _items(second)]
    if isinstance(first, tuple) and isinstance(second, tuple):
        return {_plain(item) for item in first} != {_plain(item) for item in second}
    return first != second


def _items(value: object) -> tuple[object, ...]:
    return value if isinstance(value, tuple) else ()


def _plain(item: object) -> object:
    if isinstance(item, Guarantee):
        return " ".join(item.span.text.split())
    if isinstance(item, Subscription):
        return (item.channel, item.topic, item.reach, item.history, item.host)
    return item
