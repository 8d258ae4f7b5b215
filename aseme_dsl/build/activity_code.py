"""Activity code: whether the Python of the activities and modules keeps to what the system says of them.

The code is parsed, never imported. What is looked at are calls on the activity's context whose channel,
variable or event is written there as a text, or is a constant of the same module.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.amola.expression import Raised
from aseme_dsl.amola.messages import Channel, Comm
from aseme_dsl.amola.statechart import NodeType, Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.build.activity_ends import wrong_outcomes
from aseme_dsl.build.activity_given import wrong_parameters
from aseme_dsl.build.activity_messages import unfit_messages
from aseme_dsl.build.activity_talk import Talk, talk_in, unfit_talk, unsaid
from aseme_dsl.build.activity_words import unknown_messages, unknown_methods
from aseme_dsl.build.write import stamp_of
from aseme_dsl.compiler.memory import Memory
from aseme_dsl.diagnostics import Diagnostic, Related, Suppressed, closest
from aseme_dsl.runtime.naming import class_name, module_name
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from aseme_dsl.amola.srm import Activity

_ALLOW = re.compile(r"(?:#|//)\s*asemec\s*:\s*allow\s*\((?P<codes>[^()]*)\)\s*(?P<reason>.*)")
_HISTORIES = ("history", "at", "interpolated", "mean")
_READS = ("read", "state", "latest", "age", "take", *_HISTORIES)
_VARIABLES = ("set", "variable")
_BLOCKS = {"activity": "activities", "module": "modules"}
"""Where the description of each stands."""
_METHODS = (*_READS, *_VARIABLES, "publish", "raise_event")


def check_code(
    system: System,
    folder: Path,
    *,
    alone: bool = True,
    project: Path | None = None,
    memory: Memory | None = None,
) -> tuple[tuple[Diagnostic, ...], tuple[Suppressed, ...]]:
    """What the Python in `folder` gets wrong of the system: W530 to W533, W540, W555, W556, N726.

    What is not there is not asked for. Second comes what a comment on the line allows:
    `# asemec: allow(CODE) reason`.
    `alone`: the folder belongs to this system only. If other systems share it, a name that nothing here is
    like may be one of theirs. `project` is the folder from which the code of modules is imported that is not
    found by their names. With a `memory`, what has not changed since is not looked at again.
    """
    if not folder.is_dir():
        return (), ()
    memory = memory or Memory()
    world = _World.of(system, alone, memory)
    types = memory.same("types", System(system.name, enums=system.enums, messages=system.messages))
    found: list[Diagnostic] = []
    known: set[str] = set()
    modules: list[_Module] = []
    talks: dict[str, tuple[Talk, ...]] = {}
    by_others: list[Talk] = []
    complete = True
    for piece in _pieces(system, folder, project):
        if piece.path is None:
            complete = False
            continue
        known.add(str(piece.path))
        module, problems = _module(piece.path, memory)
        found += problems
        if module is not None:
            modules.append(module)
            is_written = piece.said.takes is not None or not memory.recall(_is_empty, module, piece.wanted)
            complete = complete and is_written
            if piece.what == "activity" and is_written:
                talks[piece.said.name] = memory.recall(_talk_in, module)
            said = memory.same((piece.what, piece.said.name), piece.said)
            seen = types if module.imports_messages else memory.same("no types", System(system.name))
            calls = memory.recall(_calls, module)
            found += memory.recall(_problems_of, module, calls, said, piece.wanted, piece.what, *world.inputs)
            found += memory.recall(_problems_of_words, module, calls, seen, *world.inputs)
            continue
        complete = False
        if piece.is_missing:
            message = f"the code of the module `{piece.said.name}` cannot be found"
            message += f": there is no `{piece.target.partition(':')[0]}`"
            found.append(Diagnostic("W533", message, piece.said.span))
    for name in sorted(item.name for item in os.scandir(folder) if item.name.endswith(".py")):
        path = folder / name
        if str(path) not in known:
            helper, _ = _module(path, memory)
            if helper is not None:
                modules.append(helper)
                by_others += memory.recall(_talk_in, helper)
                calls = memory.recall(_calls, helper)
                found += memory.recall(_problems_of_helper, helper, calls, types, *world.inputs)
    if alone and system.aips:
        found += unfit_talk(system, talks)
        found += unsaid(system, talks, by_others)
    if complete and world.events:
        found += _never_raised(modules, world, memory)
    memory.end()
    kept = [item for item in found if _allowed(item) is None]
    return tuple(kept), tuple(allowed for item in found if (allowed := _allowed(item)) is not None)


def variables_read(
    system: System, folder: Path, project: Path | None = None, memory: Memory | None = None
) -> frozenset[str]:
    """The variables that the Python in `folder` reads with `context.variable("name")`."""
    memory = memory or Memory()
    modules = (_module(path, memory)[0] for path in code_files(system, folder, project))
    return frozenset(
        name for module in modules if module is not None for name in memory.recall(_variables_in, module)
    )


def code_files(system: System, folder: Path, project: Path | None = None) -> list[Path]:
    """The files, there or not, that `check_code` looks at."""
    places = {piece.path for piece in _pieces(system, folder, project) if piece.path is not None}
    return sorted({*places, *folder.glob("*.py")})


def _variables_in(module: _Module) -> frozenset[str]:
    return frozenset(call.name for call in _calls(module) if call.method == "variable")


def _problems_of(
    module: _Module, calls: _Calls, said: Activity, wanted: str, what: str, *world: *_WorldInputs
) -> tuple[Diagnostic, ...]:
    """What is wrong with the code of one activity or module, as it is described."""
    return tuple(_of_piece(module, calls, said, wanted, what, _World(*world)))


def _problems_of_words(
    module: _Module, calls: _Calls, types: System, *world: *_WorldInputs
) -> tuple[Diagnostic, ...]:
    """What is wrong with the code whatever is said of its activity."""
    return (
        *unknown_methods(module.tree, module.span),
        *unknown_messages(module.tree, types, module.span),
        *unfit_messages(module.tree, types, _published(calls, _World(*world)), module.span),
    )


def _problems_of_helper(
    module: _Module, calls: _Calls, types: System, *world: *_WorldInputs
) -> tuple[Diagnostic, ...]:
    known = _World(*world)
    return (
        *(problem for call in calls for problem in _unknown(call, None, known)),
        *unfit_messages(module.tree, types, _published(calls, known), module.span),
    )


def _allowed(item: Diagnostic) -> Suppressed | None:
    """The problem with the comment on its line that allows it, if there is one."""
    if item.span is None:
        return None
    source, number = item.span.source, item.span.line
    written = _ALLOW.search(source.line(number))
    if written is None or item.code not in re.split(r"[\s,]+", written["codes"]):
        return None
    start = source.line_start(number) + written.start("codes")
    return Suppressed(item, Span(source, start, start + len(written["codes"])), written["reason"].strip())


@dataclass(frozen=True, slots=True)
class _Piece:
    """An activity or a module: what is said of it, the file of its code (None: somewhere else), its class."""

    said: Activity
    path: Path | None
    wanted: str
    what: str = "activity"
    target: str = ""
    is_missing: bool = False
    """Whether its file should be there: the folder around it is one of the project."""


@lru_cache(20_000)
def _place_of(folder: Path, name: str) -> tuple[Path, str]:
    """The file and the class of an activity."""
    return folder / f"{module_name(name)}.py", class_name(name)


def _pieces(system: System, folder: Path, project: Path | None) -> list[_Piece]:
    """What there may be code of: the activities, then the modules, one that several roles have once."""
    pieces = [_Piece(item, *_place_of(folder, item.name)) for item in system.activities]
    modules: dict[tuple[str, str], Activity] = {}
    for chart in system.iacs:
        for module in chart.modules:
            key, said = (module.name, module.target), module.statement
            other = modules.get(key)
            if other is not None:
                said = replace(
                    said,
                    reads=(*other.reads, *said.reads),
                    writes=(*other.writes, *said.writes),
                    writes_variables=(*other.writes_variables, *said.writes_variables),
                )
            modules[key] = said
    for (name, target), said in modules.items():
        if not target:
            path: Path | None = folder / f"{module_name(name)}.py"
            pieces.append(_Piece(said, path, class_name(name), "module"))
            continue
        place, _, wanted = target.partition(":")
        path = None if project is None else project.joinpath(*place.split(".")).with_suffix(".py")
        if path is not None and not path.is_file() and (path.with_suffix("") / "__init__.py").is_file():
            path = path.with_suffix("") / "__init__.py"
        missing = path is not None and path.parent != project and path.parent.is_dir() and not path.is_file()
        pieces.append(_Piece(said, path, wanted, "module", target, missing))
    return pieces


@dataclass(frozen=True, slots=True)
class _World:
    """What code may name."""

    channels: Mapping[str, Channel]
    topics: frozenset[str]
    agents: frozenset[str]
    variables: Mapping[str, frozenset[str]]
    """Of each activity and module: those of the roles and participants that perform it."""
    of_participants: Mapping[str, frozenset[str]]
    """Of each activity: those of the participants in whose branches it stands, which it may set."""
    events: Mapping[str, Span]
    alone: bool

    @property
    def inputs(self) -> _WorldInputs:
        return (
            self.channels,
            self.topics,
            self.agents,
            self.variables,
            self.of_participants,
            self.events,
            self.alone,
        )

    @classmethod
    def of(cls, system: System, alone: bool, memory: Memory) -> _World:
        channels = [rules.channel for topic in system.topics for rules in topic.channels]
        variables: dict[str, frozenset[str]] = {}
        of_participants: dict[str, frozenset[str]] = {}
        events: dict[str, Span] = {}
        for chart in system.iacs:
            own, inside, waited = memory.recall(_names_in, memory.same(("chart", chart.name), chart))
            for name, known in own.items():
                variables[name] = variables.get(name, frozenset()) | known
            for name, known in inside.items():
                of_participants[name] = of_participants.get(name, frozenset()) | known
            for name, span in waited.items():
                events.setdefault(name, span)
        return cls(
            {str(channel): channel for channel in channels},
            frozenset(topic.name for topic in system.topics),
            frozenset(agent.name for team in system.teams for agent in team.agents),
            variables,
            of_participants,
            events,
            alone,
        )


_WorldInputs = tuple[
    Mapping[str, Channel],
    frozenset[str],
    frozenset[str],
    Mapping[str, frozenset[str]],
    Mapping[str, frozenset[str]],
    Mapping[str, Span],
    bool,
]


_Names = dict[str, frozenset[str]]


def _names_in(chart: Statechart) -> tuple[_Names, _Names, dict[str, Span]]:
    """Of a role: the variables of each activity and module, those of the participants in whose branches each
    activity stands, and the events that it waits for."""
    variables: _Names = {}
    of_participants: _Names = {}
    events: dict[str, Span] = {}
    own = frozenset(item.name.partition("@")[0] for item in chart.variables)
    scoped = [(item.name.partition("@")[0], f"{item.scope}.") for item in chart.variables if item.scope]
    for node in chart.nodes:
        if node.type is NodeType.BASIC and node.activity is not None:
            variables[node.activity] = own
            inside = frozenset(name for name, scope in scoped if node.label.startswith(scope))
            of_participants[node.activity] = of_participants.get(node.activity, frozenset()) | inside
    mine = frozenset(item.name for item in chart.variables if "@" not in item.name)
    for module in chart.modules:  # a participant's variables are not its own
        variables[module.name] = variables.get(module.name, frozenset()) | mine
    for transition in chart.transitions:
        for event in transition.expression.events:
            if isinstance(event, Raised):
                events.setdefault(event.name, event.span)
    return variables, of_participants, events


# ---- modules and calls ---------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Module:
    source: Source
    tree: ast.Module
    constants: Mapping[str, ast.Constant]

    @property
    def imports_messages(self) -> bool:
        return ".messages" in self.source.text

    def span(self, node: ast.expr | ast.stmt) -> Span:
        """The place of a node: Python counts columns in bytes of UTF-8."""
        start = self._offset(node.lineno, node.col_offset)
        end = self._offset(node.end_lineno or node.lineno, node.end_col_offset or node.col_offset)
        return Span(self.source, start, max(start, end))

    def _offset(self, line: int, column: int) -> int:
        text = self.source.line(line)
        before = len(text.encode()[:column].decode(errors="replace"))
        return self.source.line_start(line) + before


@dataclass(frozen=True, slots=True)
class _Call:
    """`context.method("name", value, host="…")`, with the name's place; `host` is the sender's or None."""

    method: str
    name: str
    span: Span
    host: tuple[str, Span] | None
    value: ast.expr | None = None


_Read = tuple["_Module | None", tuple[Diagnostic, ...]]


def _module(path: Path, memory: Memory) -> _Read:
    """A module, or None; what is no Python is W533."""
    stamp = stamp_of(path)
    return memory.recall(_parsed, str(path), repr(stamp)) if stamp is not None else (None, ())


def _parsed(name: str, stamp: str) -> _Read:
    path = Path(name)
    try:
        text = path.read_bytes().decode("utf-8-sig").replace("\r\n", "\n")
    except (OSError, UnicodeDecodeError):
        return None, ()
    source = Source(str(path), text)
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
        line = min(max(getattr(problem, "lineno", None) or 1, 1), text.count("\n") + 1)
        start = source.line_start(line)
        span = Span(source, start, start + len(source.line(line)))
        reason = problem.msg if isinstance(problem, SyntaxError) else str(problem)
        return None, (Diagnostic("W533", f"this is no Python: {reason}", span),)
    constants = {
        target.id: node.value
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant)
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    return _Module(source, tree, constants), ()


_Calls = tuple[_Call, ...]


def _calls(module: _Module) -> _Calls:
    """The calls on a context, in the order of the text."""
    contexts = {"context"}
    for node in ast.walk(module.tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            for argument in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs):
                if argument.annotation is not None and _last(argument.annotation) == "Context":
                    contexts.add(argument.arg)
    found: list[_Call] = []
    for node in ast.walk(module.tree):
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
            continue
        if node.func.attr not in _METHODS or _last(node.func.value) not in contexts:
            continue
        named = {keyword.arg: keyword.value for keyword in node.keywords}
        first = node.args[0] if node.args else named.get("channel", named.get("name"))
        said = _text(module, first)
        if first is None or said is None:
            continue
        host = named.get("host")
        sender = _text(module, host)
        from_host = (sender, module.span(host)) if host is not None and sender is not None else None
        value = node.args[1] if len(node.args) > 1 else named.get("message")
        found.append(_Call(node.func.attr, said, module.span(first), from_host, value))
    return tuple(sorted(found, key=lambda call: call.span.start))


def _is_empty(module: _Module, wanted: str) -> bool:
    """Whether the class is as a build starts it: its `execute` is a docstring. `pass` is somebody's word."""
    methods = [
        item
        for node in module.tree.body
        if isinstance(node, ast.ClassDef) and node.name == wanted
        for item in node.body
        if isinstance(item, (ast.FunctionDef, ast.AsyncFunctionDef)) and item.name == "execute"
    ]
    return any(
        all(isinstance(item, ast.Expr) and isinstance(item.value, ast.Constant) for item in method.body)
        for method in methods
    )


def _talk_in(module: _Module) -> tuple[Talk, ...]:
    return talk_in(module.tree, module.span, lambda node: _text(module, node))


def _published(calls: _Calls, world: _World) -> Iterator[tuple[str, ast.expr]]:
    """What the code publishes on channels that there are."""
    for call in calls:
        if call.method == "publish" and call.name in world.channels and call.value is not None:
            yield call.name, call.value


def _last(node: ast.expr) -> str | None:
    """The last name of `a.b.Context`, or of the text that an annotation may be."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        return node.attr
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value.rpartition(".")[2]
    return None


def _text(module: _Module, node: ast.expr | None) -> str | None:
    if isinstance(node, ast.Name):
        node = module.constants.get(node.id)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


# ---- what they say -------------------------------------------------------------------------------


def _of_piece(
    module: _Module, calls: _Calls, activity: Activity, wanted: str, what: str, world: _World
) -> Iterator[Diagnostic]:
    classes = [node for node in module.tree.body if isinstance(node, ast.ClassDef)]
    if not any(node.name == wanted for node in classes) and not _brings(module.tree, wanted):
        start = Span(module.source, 0, 0)
        near = closest(wanted, [node.name for node in classes])
        yield Diagnostic(
            "W533",
            f"the code of the {what} `{activity.name}` has no class `{wanted}`",
            next((_named(module, node) for node in classes if node.name == near), start),
            (Related(activity.span, f"the {what}"),),
            hint=f"did you mean `{wanted}`?" if near else f"write `class {wanted}:`",
        )
    for node in classes:
        methods = [item for item in node.body if isinstance(item, (ast.FunctionDef, ast.AsyncFunctionDef))]
        named = [item.name for item in methods if not item.name.startswith("_")]
        if node.name == wanted and named and not node.bases and not _defines(node, "execute"):
            article = "an" if what == "activity" else "a"
            hint = f"is it `{named[0]}`?" if len(named) == 1 else f"`execute` is what {article} {what} does"
            message = f"the class `{wanted}` has no method `execute`, so the {what} does nothing"
            yield Diagnostic(
                "W533", message, _named(module, node), (Related(activity.span, f"the {what}"),), hint=hint
            )
        execute = next((item for item in methods if item.name == "execute"), None)
        if node.name == wanted and execute is not None:
            yield from wrong_outcomes(execute, activity, module.span, lambda item: _text(module, item))
            yield from wrong_parameters(execute, activity, module.span)
    undeclared: dict[tuple[str, str], _Call] = {}
    for call in calls:
        problems = list(_unknown(call, activity, world))
        yield from problems
        if not problems:
            lacks = _missing(call, activity, world) if _is_known(call, activity, world) else None
            if lacks is not None:
                undeclared.setdefault(lacks, call)
    for (clause, name), call in undeclared.items():
        message = f"`{activity.name}` {clause} `{name}`, which it does not say"
        if name.endswith(" for …"):
            message = f"`{activity.name}` reads a history, and does not say how long it is to be kept"
        yield Diagnostic(
            "W531",
            message,
            call.span,
            (Related(activity.span, "what is said of it" if _is_described(activity) else f"the {what}"),),
            hint=f"add `{clause} {name}` to it among the `{_BLOCKS[what]}` of the role",
        )


def _is_described(activity: Activity) -> bool:
    return bool(activity.reads or activity.writes or activity.writes_variables or activity.uses)


def _defines(node: ast.ClassDef, name: str) -> bool:
    """Whether the body of a class gives `name` a meaning, by whatever statement."""
    return any(
        getattr(item, "name", None) == name or (isinstance(item, ast.Name) and item.id == name)
        for item in ast.walk(node)
    )


def _named(module: _Module, node: ast.ClassDef) -> Span:
    start = module.span(node).start
    start = module.source.text.find(node.name, start)
    return Span(module.source, start, start + len(node.name))


def _brings(tree: ast.Module, name: str) -> bool:
    """Whether the module imports the name, assigns it, or imports whatever there is."""
    for node in tree.body:
        match node:
            case ast.ImportFrom(names=names) | ast.Import(names=names):
                if any((item.asname or item.name) in (name, "*") for item in names):
                    return True
            case ast.Assign(targets=targets):
                if any(isinstance(item, ast.Name) and item.id == name for item in targets):
                    return True
            case ast.If() | ast.Try() | ast.With():
                return True
    return False


def _unknown(call: _Call, activity: Activity | None, world: _World) -> Iterator[Diagnostic]:
    """W530 for what is not there, W532 for an event that nothing waits for."""
    if call.method == "raise_event":
        if call.name not in world.events:
            near = closest(call.name, world.events)
            if near is not None or world.alone:
                related = (Related(world.events[near], f"`{near}` is waited for here"),) if near else ()
                hint = f"did you mean `{near}`?" if near else "let a transition wait for it, or leave it out"
                message = f"no transition waits for the event `{call.name}`"
                yield Diagnostic("W532", message, call.span, related, hint=hint)
        return
    if call.method in _VARIABLES:
        own = world.variables.get(activity.name, frozenset()) if activity is not None else frozenset()
        if activity is not None and call.name not in own:
            near = closest(call.name, own)
            if near is not None or world.alone:
                hint = f"did you mean `{near}`?" if near else f"declare it: `var {call.name} : …`"
                message = f"no role that performs `{activity.name}` has a variable `{call.name}`"
                yield Diagnostic("W530", message, call.span, hint=hint)
        return
    if call.name not in world.channels:
        near = closest(call.name, world.channels)
        if near is not None or world.alone or call.name.partition(".")[0] in world.topics:
            yield Diagnostic(
                "W530",
                f"there is no channel `{call.name}`",
                call.span,
                hint=f"did you mean `{near}`?" if near else _channel_hint(call.name, world),
            )
        return
    if call.host is not None and world.agents and call.host[0] not in world.agents:
        near = closest(call.host[0], world.agents)
        if near is not None or world.alone:
            message = f"there is no agent `{call.host[0]}`"
            yield Diagnostic("W530", message, call.host[1], hint=f"did you mean `{near}`?" if near else None)
        return
    if call.method in _HISTORIES and world.channels[call.name].comm is not Comm.DATA:
        comm = world.channels[call.name].comm
        message = f"only data has a history; `{call.name}` is a {comm}"
        yield Diagnostic("W530", message, call.span)


def _never_raised(modules: Sequence[_Module], world: _World, memory: Memory) -> Iterator[Diagnostic]:
    """N726 for an event that a transition waits for and no code raises, as far as all of the code is there.

    An event whose name is computed may be any of them; one that is almost raised is W532 there.
    """
    raised: set[str] = set()
    for module in modules:
        names = memory.recall(_raised_by, module)
        if names is None:
            return
        raised |= names
    meant = {closest(name, world.events) for name in raised if name not in world.events}
    for name, span in world.events.items():
        if name not in raised and name not in meant:
            hint = f'raise it in an activity: `context.raise_event("{name}")`'
            yield Diagnostic("N726", f"no activity raises the event `{name}`", span, hint=hint)


def _raised_by(module: _Module) -> frozenset[str] | None:
    """The events that the code raises; None if it computes the name of one."""
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Call) and _last(node.func) == "raise_event":
            first = node.args[0] if node.args else next((item.value for item in node.keywords), None)
            if _text(module, first) is None:
                return None
    return frozenset(call.name for call in _calls(module) if call.method == "raise_event")


def _channel_hint(name: str, world: _World) -> str:
    topic = name.partition(".")[0]
    own = [text for text in world.channels if text.partition(".")[0] == topic]
    if own:
        return f"`{topic}` has " + ", ".join(f"`{text}`" for text in own)
    return "a channel is `topic.class.Message`, of a topic that the system declares"


def _is_known(call: _Call, activity: Activity, world: _World) -> bool:
    """Whether it is a name of this system, and not one that another system may have."""
    if call.method in _VARIABLES:
        return call.name in world.variables.get(activity.name, frozenset())
    return call.name in world.channels


def _missing(call: _Call, activity: Activity, world: _World) -> tuple[str, str] | None:
    """The clause and the name that the description of the activity lacks."""
    if call.method in _READS:
        own = [item for item in activity.reads if str(item.channel) == call.name]
        if call.method in _HISTORIES and own and not any(item.history for item in own):
            return "reads", f"{call.name} for …"
        reads = own or any(item.channel is None for item in activity.reads)
        return None if reads else ("reads", call.name)
    if call.method == "publish":
        return None if call.name in map(str, activity.writes) else ("writes", call.name)
    if call.method == "set":
        mine = (*activity.writes_variables, *world.of_participants.get(activity.name, ()))
        return None if call.name in mine else ("writes", call.name)
    return None


__all__ = ["check_code", "code_files", "variables_read"]
