"""Activities: what the roles say of them, resolved, and merged into one statement an activity."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from aseme_dsl.amola.messages import Channel, Comm, Parameter
from aseme_dsl.amola.srm import Activity, Subscription
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.paths import channel_of
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.library import providers
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.grammar.text import tree

KINDS = ("thread", "async", "process", "step")
REACHES = ("on", "above", "below", "around")


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
            checker.diagnostics.append(unknown("E200", "there is no kind of activity", written.kind, KINDS))
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
    )
    if written.within is not None and written.within.nanoseconds <= 0:
        hint = "a deadline comes after the state is entered: `within 5s`"
        checker.report("E522", "the deadline is no time at all", written.within.span, hint)
    return activity, tuple(checker.diagnostics)


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
                    checker.report("E503", "a variable has no history", history.span, "leave it out")
                return None
        if symbols.topic(topic.text) is None:
            if not symbols.is_excused(topic.text):
                pool = [*(item.name for item in symbols.topics), *checker.scope.variables, *played]
                hint = providers(topic.text, "topic")
                if symbols.message(topic.text) is not None:
                    channels = symbols.channels_of(topic.text)
                    hint = f"it is a message: `{channels[0]}`" if channels else "it is a message"
                elif topic.text in checker.scope.lets:
                    hint = "it is a let: say what it reads instead"
                checker.diagnostics.append(unknown("E502", "there is no topic", topic, pool, certain=hint))
            return None
        if history is not None:
            hint = f"name the message: `{topic}.data.Message for {history.span.text}`"
            checker.report("E503", "a whole topic has no history", history.span, hint)
        return Subscription(None, topic.text, written.reach, 0, None, written.span)
    found = channel_of(checker, path)
    if found is None:
        return None
    host, channel, used = found
    if len(path.segments) > used:
        hint = f"write `{'.'.join(item.text for item in path.segments[:used])}`"
        checker.report("E502", "an activity reads whole messages", path.segments[used].span, hint)
    if written.reach != "on":
        hint = f"write `{written.reach} {channel.topic}`"
        checker.report("E502", f"`{written.reach}` is followed by a topic", path.span, hint)
        return None
    kept = 0
    if history is not None and channel.comm is not Comm.DATA:
        problem = f"only data has a history; `{channel}` is a {channel.comm}"
        checker.report("E503", problem, path.segments[used - 2].span)
    elif history is not None:
        kept = history.nanoseconds
    return Subscription(channel, channel.topic, written.reach, kept, host, written.span)


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
            checker.report(
                "E507", f"`{first}` is a let: nothing can be written to it", path.span, None, related
            )
        elif not scope.symbols.is_excused(first.text):
            pool = {*scope.variables, *played}
            hint = "an activity writes a variable of its role or `topic.state.Message`"
            found = [str(channel) for channel in scope.symbols.channels_of(first.text)]
            if scope.symbols.topic(first.text) is not None:
                hint = f"it is a topic: name the message, `{first}.state.Message`"
            elif found:
                hint = f"it is a message: `{found[0]}`"
            checker.diagnostics.append(unknown("E200", "there is no variable", first, pool, hint))
        return
    channel = channel_of(checker, path)
    if channel is None:
        return
    host, written, used = channel
    if host is not None:
        checker.report("E502", "an activity publishes as its own agent", path.segments[0].span)
        return
    if len(path.segments) > used:
        hint = f"write `{written}`"
        checker.report("E502", "an activity publishes whole messages", path.segments[used].span, hint)
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
                diagnostics.append(
                    Diagnostic(
                        "E203",
                        f"`{item.name}` has two different `{word}`: an activity belongs to the whole system",
                        item.span,
                        (Related(other.span, "the other statement"),),
                        hint="leave one of them out, or give one of the activities another name",
                    )
                )
    if not clauses.get("kind", first.kind):
        clauses["kind"] = "thread"
    simulated = next((item for item in statements if item.simulated), None)
    if simulated is not None:
        clauses["simulated"] = True
    merged = replace(first, **clauses) if clauses else first  # type: ignore[arg-type]
    if simulated is not None and merged.takes is None:
        diagnostics.append(
            Diagnostic(
                "W201",
                f"`{merged.name}` is simulated, and nothing says how long: it lasts 100 ms",
                simulated.span,
                hint=f"say what it takes: `{merged.name} takes 1s simulated`",
            )
        )
    return merged, tuple(diagnostics)


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
    if isinstance(item, Subscription):
        return (item.channel, item.topic, item.reach, item.history, item.host)
    return item
