"""Activity code: whether the Python of the activities and modules keeps to what the system says of them.

The code is parsed, never imported. What is looked at are calls on the activity's context whose channel,
variable or event is written there as a text, or is a constant of the same module.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.amola.expression import Raise, Raised
from aseme_dsl.amola.messages import Channel, ChannelKind, Topic
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.amola.system import System, agent_names
from aseme_dsl.compiler.chart.flow import check_pace
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.diagnostics import CODES, Diagnostic, Related, Severity, Suppressed, closest
from aseme_dsl.diagnostics.problems.python.code import (
    NoClass,
    NoExecute,
    NoFileOfModule,
    NotPython,
    NotWrittenYet,
)
from aseme_dsl.diagnostics.problems.python.code_words import (
    EventNotAwaited,
    EventNotRaised,
    NoAgentInCode,
    NoChannel,
    NoHistoryInCode,
    NoVariableOfActivity,
)
from aseme_dsl.project.code.activity_access import (
    HISTORIES,
    READS,
    Access,
    executes_of,
    looks_back,
    owners,
    undeclared,
    used_by,
)
from aseme_dsl.project.code.activity_content import Prepared, never_prepared, prepared_in
from aseme_dsl.project.code.activity_ends import wrong_outcomes
from aseme_dsl.project.code.activity_fields import Readings, unfit_values, unknown_members
from aseme_dsl.project.code.activity_files import (
    Required,
    as_simulated,
    check_files,
    empty_classes,
    missing_folder,
    needed_by,
)
from aseme_dsl.project.code.activity_given import wrong_parameters
from aseme_dsl.project.code.activity_imports import systems_beside, wrong_imports
from aseme_dsl.project.code.activity_messages import unfit_messages
from aseme_dsl.project.code.activity_pace import returns_at_once
from aseme_dsl.project.code.activity_talk import Talk, parts_of, sent_by_lines, talk_in, unfit_talk, unsaid
from aseme_dsl.project.code.activity_words import unknown_messages, unknown_methods
from aseme_dsl.project.files.stamp import Look, Stamp, stamp_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name, module_name
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from aseme_dsl.amola.srm import Activity

_ALLOW = re.compile(r"(?:#|//)\s*asemec\s*:\s*allow\s*\((?P<codes>[^()]*)\)\s*(?P<reason>.*)")
_VARIABLES = ("set_variable", "get_variable")
_METHODS = (*READS, *_VARIABLES, "publish", "raise_event")


def check_code(
    system: System,
    folder: Path,
    *,
    alone: bool = True,
    project: Path | None = None,
    memory: Memory | None = None,
    look: Look = stamp_of,
    required: Required | None = None,
) -> tuple[tuple[Diagnostic, ...], tuple[Suppressed, ...]]:
    """What the Python in `folder` gets wrong of the system: E540, E546, W530, W532, W540, W547, W555,
    W556, W576, N726.

    Missing files are allowed, unless there is `required`. Then these codes are added:

    - E544: a missing folder;
    - E543: a missing file;
    - W541: a file that nothing uses;
    - W542: a file of a simulated activity;
    - N740: a file in which nothing is written yet.

    The second value has the diagnostics that a comment on the line allows: `# asemec: allow(CODE) reason`.

    `alone`: the folder belongs to this system only. If other systems share it, a name that nothing here is
    like may be one of theirs. `project` is the folder from which the code of modules is imported that is not
    found by their names. With a `memory`, a file is not read again as long as `look` gives the same for it.
    """
    memory = memory or Memory()
    if not folder.is_dir():
        missing = () if required is None else missing_folder(system, folder, required, project)
        silent, allowed = check_silence(system, alone=alone, memory=memory)
        return (*missing, *silent), allowed
    world = _World.of(system, alone, memory)
    types = memory.same("types", System(system.name, enums=system.enums, messages=system.messages))
    no_types = memory.same("no types", System(system.name))
    pieces = _pieces(system, folder, project, memory)
    paths = code_paths(pieces, folder)
    codes = _codes(paths, pieces, memory, look)
    found: list[Diagnostic] = []
    if required is not None:
        found += check_files(system, folder, required, project, look)
    written = _written(pieces, codes, required)
    found += written.problems
    described = written.described
    words = [(code, types if code.read.imports_messages else no_types) for code, *_ in described]
    known = {piece.path for piece in pieces}
    if any(code.problems for path, code in codes.items() if path not in known):
        needed = needed_by((code.read.source.path for code, *_ in described), folder, project, look)
        found += _unreadable(codes, needed)
    helpers = [code for path, code in codes.items() if path not in known and code.module is not None]
    read = {id(code): code for code in (*(code for code, *_ in described), *helpers)}
    systems = systems_beside(system, required.neighbours if required is not None else ())
    checked = (
        memory.each(_problems_of, described, *world.inputs),
        memory.each(_problems_of_words, words, *world.inputs),
        memory.each(_problems_of_helper, [(code,) for code in helpers], types, *world.inputs),
        memory.each(_problems_of_fields, [(code,) for code in read.values()], types, *world.inputs),
    )
    if alone or required is not None:
        for code in read.values():
            found += wrong_imports(code.read.tree, system, systems, code.read.span)
    found += (problem for results in checked for problems in results for problem in problems)
    for chart in system.iacs:
        found += check_pace(chart, written.quick)
    if alone and system.aips:
        parts = parts_of(system, memory)
        talks = {**_of_simulated(system), **written.talks}
        found += unfit_talk(parts, talks)
        found += sent_by_lines(system, parts, talks)
        found += never_prepared(system, written.prepared)
        found += unsaid(system, parts, talks, [talk for code in helpers for talk in code.talk])
    if written.is_complete and world.events:
        coded = [code for code in codes.values() if code.module is not None]
        found += _never_raised(coded, world, memory, _raised_by_actions(system))
    memory.end()
    return _kept(found)


@dataclass(frozen=True, slots=True)
class _Written:
    """The code that there is of activities and modules."""

    described: Sequence[tuple[_Code, Activity, str, str]]
    """The code of each with its description, its class, and whether it is an activity or a module."""
    talks: Mapping[str, tuple[Talk, ...]]
    """The agent messages of each activity."""
    prepared: Prepared
    problems: Sequence[Diagnostic]
    is_complete: bool
    """Whether there is code of all, so that what none of it does is not done."""
    quick: Mapping[str, Activity]
    """The activities whose code surely returns at once."""


def _written(pieces: Iterable[_Piece], codes: Mapping[str, _Code], required: Required | None) -> _Written:
    """The code of these activities and modules, and what is wrong where there is none."""
    described: list[tuple[_Code, Activity, str, str]] = []
    talks: dict[str, tuple[Talk, ...]] = {}
    prepared: dict[str, frozenset[str] | None] = {}
    problems: list[Diagnostic] = []
    is_complete = True
    quick: dict[str, Activity] = {}
    for piece in pieces:
        if not piece.said.has_code:  # its code, which is to come, may raise any event
            is_complete = False
            continue
        code = codes.get(piece.path) if piece.path is not None else None
        if code is None or code.module is None:
            is_complete = False
            problems += code.problems if code is not None else ()
            if piece.is_missing and code is None:
                problem = NoFileOfModule(piece.said.name, piece.target.partition(":")[0])
                problems.append(Diagnostic(problem, piece.said.span))
            continue
        if required is not None and piece.wanted in code.empty:
            problems.append(_unwritten(code.read, piece.said, piece.wanted, piece.what))
        is_written = piece.said.takes is not None or piece.wanted not in code.empty
        is_complete = is_complete and is_written
        if is_written and piece.what == "activity":
            talks[piece.said.name] = code.talk
            prepared[piece.said.name] = code.prepared
            executes = list(executes_of(code.read.tree, [piece.wanted]))
            is_paced = piece.said.every is not None or piece.wanted in code.empty
            if executes and not is_paced and all(map(returns_at_once, executes)):
                quick[piece.said.name] = piece.said
        described.append((code, piece.said, piece.wanted, piece.what))
    return _Written(described, talks, prepared, problems, is_complete, quick)


_Kept = tuple[tuple[Diagnostic, ...], tuple[Suppressed, ...]]


def _kept(found: Iterable[Diagnostic]) -> _Kept:
    """What is not allowed, and what is."""
    found = tuple(found)
    kept = tuple(item for item in found if _allowed(item) is None)
    return kept, tuple(allowed for item in found if (allowed := _allowed(item)) is not None)


def check_silence(system: System, *, alone: bool = True, memory: Memory | None = None) -> _Kept:
    """W556 where there is no code: of participants whose activities are all simulated."""
    memory = memory or Memory()
    if not (alone and system.aips):
        return (), ()
    return _kept(unsaid(system, parts_of(system, memory), _of_simulated(system), ()))


def _of_simulated(system: System) -> dict[str, tuple[Talk, ...]]:
    """What simulated activities send and take: nothing."""
    return {item.name: () for item in system.activities if not item.has_code}


def _unreadable(codes: Mapping[str, _Code], needed: Mapping[str, str]) -> Iterator[Diagnostic]:
    """What is not Python of the files beside the activities that they import."""
    for path, code in codes.items():
        user = needed.get(os.path.realpath(path))
        if user is not None:
            for item in code.problems:
                yield replace(item, problem=item.problem.but(imported_by=Path(user).name))


def variables_read(
    system: System,
    folder: Path,
    project: Path | None = None,
    memory: Memory | None = None,
    look: Look = stamp_of,
) -> frozenset[str]:
    """The variables that the Python in `folder` reads with `context.get_variable("name")`."""
    memory = memory or Memory()
    pieces = _pieces(system, folder, project, memory)
    codes = _codes(code_paths(pieces, folder), pieces, memory, look)
    calls = (call for code in codes.values() for call in code.calls)
    return frozenset(call.name for call in calls if call.method == "get_variable")


def variables_written(
    system: System, folder: Path, project: Path | None = None
) -> dict[str, frozenset[str | None]]:
    """The variables that the Python in `folder` writes with `set_variable("name", …)`, by activity.

    None stands for any variable, where the name is not written in the call. What a file beside those of the
    activities writes, each of them may.
    """
    memory = Memory()
    pieces = _pieces(system, folder, project, memory)
    codes = _codes(code_paths(pieces, folder), pieces, memory, stamp_of)
    written = {
        path: frozenset(_written_in(code.module)) for path, code in codes.items() if code.module is not None
    }
    known = {piece.path for piece in pieces}
    beside = frozenset[str | None]().union(*(names for path, names in written.items() if path not in known))
    return {
        piece.said.name: written[piece.path] | beside
        for piece in pieces
        if piece.what == "activity" and piece.path in written
    }


def _written_in(module: _Module) -> Iterator[str | None]:
    """The variables that a module writes; it may call its context by any name."""
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "set_variable":
            named = {keyword.arg: keyword.value for keyword in node.keywords}
            yield _text(module, node.args[0] if node.args else named.get("name"))


def code_files(
    system: System, folder: Path, project: Path | None = None, memory: Memory | None = None
) -> list[str]:
    """The paths of the files, there or not, that `check_code` looks at."""
    return code_paths(_pieces(system, folder, project, memory or Memory()), folder)


def code_paths(pieces: Iterable[_Piece], folder: Path) -> list[str]:
    """The paths of the files of `pieces`, there or not, and of all that is beside them."""
    paths = dict.fromkeys(piece.path for piece in pieces if piece.path is not None)
    try:
        names = os.listdir(folder)  # noqa: PTH208 (many names, of which only the texts are wanted)
    except OSError:
        names = []
    within = os.path.join(folder, "")  # noqa: PTH118
    beside = {within + name for name in names if name.endswith(".py")}
    return [*paths, *sorted(beside.difference(paths))]


def _problems_of(
    code: _Code, said: Activity, wanted: str, what: str, *world: *_WorldInputs
) -> tuple[Diagnostic, ...]:
    """What is wrong with the code of one activity or module, as it is described."""
    return tuple(_of_piece(code.read, code.calls, said, wanted, what, _World(*world)))


def _problems_of_words(code: _Code, types: System, *world: *_WorldInputs) -> tuple[Diagnostic, ...]:
    """The diagnostics of the code that do not depend on the description of its activity."""
    module = code.read
    return (
        *unknown_methods(module.tree, module.span, code.executes),
        *unknown_messages(module.tree, types, module.span),
        *unfit_messages(module.tree, types, _published(code.calls, _World(*world)), module.span),
    )


def _problems_of_helper(code: _Code, types: System, *world: *_WorldInputs) -> tuple[Diagnostic, ...]:
    known, module = _World(*world), code.read
    return (
        *(problem for call in code.calls for problem in _unknown(call, None, known)),
        *unknown_messages(module.tree, types, module.span),
        *unfit_messages(module.tree, types, _published(code.calls, known), module.span),
    )


def _problems_of_fields(code: _Code, types: System, *world: *_WorldInputs) -> tuple[Diagnostic, ...]:
    """What is wrong with the members of messages that the code makes and reads."""
    known, module = _World(*world), code.read
    readings = Readings({name: item.message for name, item in known.channels.items()}, known.alone)

    def text(node: ast.expr | None) -> str | None:
        return _text(module, node)

    return (
        *unfit_values(module.tree, types, module.span),
        *unknown_members(module.tree, types, readings, code.contexts, text, module.span),
    )


def _allowed(item: Diagnostic) -> Suppressed | None:
    """The problem with the comment on its line that allows it, if there is one. No error can be allowed."""
    if item.span is None or CODES[item.code].severity == Severity.ERROR:
        return None
    source, number = item.span.source, item.span.line
    lines = [number]
    while lines[-1] > 1 and source.line(lines[-1] - 1).lstrip().startswith("//"):
        lines.append(lines[-1] - 1)  # of a file of the language: a line of its own above it
    for line in lines:
        written = _ALLOW.search(source.line(line))
        if written is not None and item.code in re.split(r"[\s,]+", written["codes"]):
            start = source.line_start(line) + written.start("codes")
            return Suppressed(
                item, Span(source, start, start + len(written["codes"])), written["reason"].strip()
            )
    return None


@dataclass(frozen=True, slots=True)
class _Piece:
    """An activity or a module: what is said of it, the file of its code (None: somewhere else), its class."""

    said: Activity
    path: str | None
    wanted: str
    what: str = "activity"
    target: str = ""
    is_missing: bool = False
    """Whether its file should be there: the folder around it is one of the project."""


def _of_activity(said: Activity, folder: str) -> _Piece:
    return _Piece(said, os.path.join(folder, f"{module_name(said.name)}.py"), class_name(said.name))  # noqa: PTH118


def _pieces(system: System, folder: Path, project: Path | None, memory: Memory) -> list[_Piece]:
    """What there may be code of: the activities, then the modules, one that several roles have once."""
    pieces = list(memory.each(_of_activity, [(item,) for item in system.activities], str(folder)))
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
            pieces.append(_Piece(said, str(folder / f"{module_name(name)}.py"), class_name(name), "module"))
            continue
        place, _, wanted = target.partition(":")
        path = None if project is None else project.joinpath(*place.split(".")).with_suffix(".py")
        if path is not None and not path.is_file() and (path.with_suffix("") / "__init__.py").is_file():
            path = path.with_suffix("") / "__init__.py"
        missing = path is not None and path.parent != project and path.parent.is_dir() and not path.is_file()
        where = None if path is None else str(path)
        pieces.append(_Piece(said, where, wanted, "module", target, missing))
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
    roles: Mapping[str, tuple[Span, ...]]
    """Of each activity and module: the places of the roles that perform it."""
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
            self.roles,
            self.alone,
        )

    @classmethod
    def of(cls, system: System, alone: bool, memory: Memory) -> _World:
        names = memory.each(_names_in, [(chart,) for chart in system.iacs])
        variables, of_participants, events, roles = memory.recall(_all_names, names)
        return cls(
            memory.recall(_channels, memory.same("topics", system.topics)),
            frozenset(topic.name for topic in system.topics),
            agent_names(system.teams, (chart.name for chart in system.iacs)),
            variables,
            of_participants,
            events,
            roles,
            alone,
        )


_WorldInputs = tuple[
    Mapping[str, Channel],
    frozenset[str],
    frozenset[str],
    Mapping[str, frozenset[str]],
    Mapping[str, frozenset[str]],
    Mapping[str, Span],
    Mapping[str, tuple[Span, ...]],
    bool,
]


_Names = dict[str, frozenset[str]]


def _channels(topics: Iterable[Topic]) -> dict[str, Channel]:
    return {str(rules.channel): rules.channel for topic in topics for rules in topic.channels}


def _all_names(
    charts: Iterable[tuple[_Names, _Names, dict[str, Span], Span]],
) -> tuple[_Names, _Names, dict[str, Span], dict[str, tuple[Span, ...]]]:
    """What `_names_in` has found in each role, for all of them."""
    variables: _Names = {}
    of_participants: _Names = {}
    events: dict[str, Span] = {}
    roles: dict[str, tuple[Span, ...]] = {}
    for own, inside, waited, place in charts:
        for name in own:
            roles[name] = (*roles.get(name, ()), place)
        for all_names, names in ((variables, own), (of_participants, inside)):
            for name, known in names.items():
                before = all_names.get(name)
                all_names[name] = known if before is None else before | known
        for name, span in waited.items():
            events.setdefault(name, span)
    return variables, of_participants, events, roles


def _names_in(chart: Statechart) -> tuple[_Names, _Names, dict[str, Span], Span]:
    """Of a role: the variables of each activity and module, those of the participants in whose branches each
    activity stands, and the events that it waits for."""
    variables: _Names = {}
    of_participants: _Names = {}
    events: dict[str, Span] = {}
    own = frozenset(item.name.partition("@")[0] for item in chart.variables)
    scoped = [(item.name.partition("@")[0], f"{item.scope}.") for item in chart.variables if item.scope]
    for node in chart.states:
        if node.type is StateType.BASIC and node.activity is not None:
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
    return variables, of_participants, events, chart.root.span


# ---- modules and calls ---------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Module:
    source: Source
    tree: ast.Module
    constants: Mapping[str, ast.Constant]

    @property
    def imports_messages(self) -> bool:
        return "messages" in self.source.text

    def span(self, node: ast.expr | ast.stmt | ast.alias) -> Span:
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
    """`context.method("name", value, sender="…")`, with the name's place; `host` is the sender's or None."""

    method: str
    name: str
    span: Span
    host: tuple[str, Span] | None
    value: ast.expr | None = None
    owner: str = ""
    """The class or function of the module in which it stands."""
    back: int | None = None
    """How far back it looks, in ns, if it says so with a number."""


@dataclass(frozen=True, slots=True)
class _Code:
    """A file: the module, if it is Python, or else what is wrong with it; and what is to be found in it.

    `empty` are the classes that are as a build starts them.
    """

    module: _Module | None
    problems: tuple[Diagnostic, ...] = ()
    calls: tuple[_Call, ...] = ()
    talk: tuple[Talk, ...] = ()
    empty: frozenset[str] = frozenset()
    contexts: frozenset[str] = frozenset()
    """What the module calls a context."""
    executes: tuple[str, ...] = ()
    """The classes in it that are those of activities and modules."""
    prepared: frozenset[str] | None = None

    @property
    def read(self) -> _Module:
        """The module of a file that is Python."""
        assert self.module is not None
        return self.module


def _codes(paths: Iterable[str], pieces: Iterable[_Piece], memory: Memory, look: Look) -> dict[str, _Code]:
    """Every file that is there, by its path."""
    wanted: dict[str, tuple[str, ...]] = {}
    for piece in pieces:
        if piece.path is not None:
            wanted[piece.path] = (*wanted.get(piece.path, ()), piece.wanted)
    found = {path: (stamp, wanted.get(path, ())) for path in paths if (stamp := look(path)) is not None}
    stamps = memory.same_values("stamps", found)
    items = [(path, *rest) for path, rest in stamps.items()]
    return dict(zip(stamps, memory.each(_code, items), strict=True))


def _code(name: str, stamp: Stamp, wanted: tuple[str, ...] = ()) -> _Code:
    """What is in a file; what is not Python is E546."""
    try:
        text = outside.read_bytes(name).decode("utf-8-sig").replace("\r\n", "\n")
    except (OSError, UnicodeDecodeError):
        return _Code(None)
    source = Source(name, text)
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
        line = min(max(getattr(problem, "lineno", None) or 1, 1), text.count("\n") + 1)
        start = source.line_start(line)
        span = Span(source, start, start + len(source.line(line)))
        reason = problem.msg if isinstance(problem, SyntaxError) else str(problem)
        return _Code(None, (Diagnostic(NotPython(reason), span),))
    constants = {
        target.id: node.value
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant)
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    module = _Module(source, tree, constants)
    contexts = _contexts(module.tree, wanted)
    calls, talk = _calls(module, contexts), _talk_in(module, contexts)
    prepared = prepared_in(module.tree, contexts)
    return _Code(module, (), calls, talk, empty_classes(module.tree), contexts, wanted, prepared)


_Calls = tuple[_Call, ...]


def _contexts(tree: ast.Module, wanted: Iterable[str]) -> frozenset[str]:
    """What a module calls a context: `context`, what is annotated so, and what `execute` takes first."""
    contexts = {"context"}
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            for argument in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs):
                if argument.annotation is not None and _last(argument.annotation) == "Context":
                    contexts.add(argument.arg)
    for execute in executes_of(tree, wanted):
        taken = [*execute.args.posonlyargs, *execute.args.args]
        if len(taken) > 1:
            contexts.add(taken[1].arg)
    return frozenset(contexts)


def _calls(module: _Module, contexts: frozenset[str]) -> _Calls:
    """The calls on a context, in the order of the text."""
    found: list[_Call] = []
    for owner, node in ((owner, node) for owner, part in owners(module.tree) for node in ast.walk(part)):
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
            continue
        if node.func.attr not in _METHODS or _last(node.func.value) not in contexts:
            continue
        named = {keyword.arg: keyword.value for keyword in node.keywords}
        first = node.args[0] if node.args else named.get("channel", named.get("name"))
        said = _text(module, first)
        if first is None or said is None:
            continue
        host = named.get("to" if node.func.attr == "publish" else "sender")
        sender = _text(module, host)
        from_host = (sender, module.span(host)) if host is not None and sender is not None else None
        value = node.args[1] if len(node.args) > 1 else named.get("message")
        back = looks_back(node, node.func.attr)
        found.append(_Call(node.func.attr, said, module.span(first), from_host, value, owner, back))
    return tuple(sorted(found, key=lambda call: call.span.start))


def _talk_in(module: _Module, contexts: frozenset[str]) -> tuple[Talk, ...]:
    return talk_in(module.tree, module.span, lambda node: _text(module, node), contexts)


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
            NoClass(what, activity.name, wanted, near is not None),
            next((_named(module, node) for node in classes if node.name == near), start),
            (Related(activity.span, f"the {what}"),),
        )
    for node in classes:
        methods = [item for item in node.body if isinstance(item, (ast.FunctionDef, ast.AsyncFunctionDef))]
        named = [item.name for item in methods if not item.name.startswith("_")]
        is_whole = not (node.bases or node.keywords or node.decorator_list)
        if node.name == wanted and is_whole and _says_something(node) and not _defines(node, "execute"):
            problem = NoExecute(what, wanted, named[0] if len(named) == 1 else None)
            yield Diagnostic(problem, _named(module, node), (Related(activity.span, f"the {what}"),))
        execute = next((item for item in methods if item.name == "execute"), None)
        if node.name == wanted and execute is not None:
            yield from wrong_outcomes(execute, activity, module.span, lambda item: _text(module, item))
            yield from wrong_parameters(execute, activity, what, module.span)
    accesses: list[Access] = []
    surely = used_by(module.tree, wanted)
    for call in calls:
        problems = list(_unknown(call, activity, world))
        yield from problems
        if not problems and call.owner in surely and _is_known(call, activity, world):
            accesses.append(Access(call.method, call.name, call.span, call.owner, call.back))
    own = world.of_participants.get(activity.name, frozenset())
    yield from undeclared(accesses, activity, what, own, world.roles.get(activity.name, ()))


def _unwritten(module: _Module, said: Activity, wanted: str, what: str) -> Diagnostic:
    """N740 for a class that is as it was started."""
    node = next(item for item in module.tree.body if isinstance(item, ast.ClassDef) and item.name == wanted)
    problem = NotWrittenYet(what, said.name, as_simulated(said) if what == "activity" else None)
    return Diagnostic(problem, _named(module, node), (Related(said.span, f"the {what}"),))


def _says_something(node: ast.ClassDef) -> bool:
    """Whether there is more in a class than a docstring, `pass` or `...`."""
    return any(
        not isinstance(item, ast.Pass)
        and not (isinstance(item, ast.Expr) and isinstance(item.value, ast.Constant))
        for item in node.body
    )


def _defines(node: ast.ClassDef, name: str) -> bool:
    """Whether the body of a class gives `name` a meaning, by any statement."""
    return any(
        getattr(item, "name", None) == name or (isinstance(item, ast.Name) and item.id == name)
        for item in ast.walk(node)
    )


def _named(module: _Module, node: ast.ClassDef) -> Span:
    start = module.span(node).start
    start = module.source.text.find(node.name, start)
    return Span(module.source, start, start + len(node.name))


def _brings(tree: ast.Module, name: str) -> bool:
    """Whether the module imports the name, assigns it, or imports all names (`*`)."""
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
                yield Diagnostic(EventNotAwaited(call.name, near), call.span, related)
        return
    if call.method in _VARIABLES:
        own = world.variables.get(activity.name, frozenset()) if activity is not None else frozenset()
        if activity is not None and call.name not in own:
            near = closest(call.name, own)
            if near is not None or world.alone:
                yield Diagnostic(NoVariableOfActivity(call.name, near, activity.name), call.span)
        return
    if call.name not in world.channels:
        near = closest(call.name, world.channels)
        if near is not None or world.alone or call.name.partition(".")[0] in world.topics:
            yield Diagnostic(NoChannel(call.name, near, _channels_of(call.name, world)), call.span)
        return
    if call.host is not None and call.host[0] not in world.agents:
        near = closest(call.host[0], world.agents)
        if near is not None or world.alone:
            yield Diagnostic(NoAgentInCode(call.host[0], near), call.host[1])
        return
    if call.method in HISTORIES and world.channels[call.name].comm is not ChannelKind.DATA:
        yield Diagnostic(NoHistoryInCode(call.name, str(world.channels[call.name].comm)), call.span)


def _raised_by_actions(system: System) -> frozenset[str]:
    """The events that transitions raise."""
    return frozenset(
        action.name
        for chart in system.iacs
        for transition in chart.transitions
        for action in transition.expression.actions
        if isinstance(action, Raise)
    )


def _never_raised(
    codes: Sequence[_Code], world: _World, memory: Memory, by_actions: frozenset[str]
) -> Iterator[Diagnostic]:
    """N726 for an event that a transition waits for and no code raises, as far as all of the code is there.

    An event whose name is computed may be any of them; one that is almost raised is W532 there.
    """
    raised: set[str] = set()
    for names in memory.each(_raised_by, [(code,) for code in codes]):
        if names is None:
            return
        raised |= names
    meant = {closest(name, world.events) for name in raised if name not in world.events}
    for name, span in world.events.items():
        if name not in raised and name not in meant and name not in by_actions:
            yield Diagnostic(EventNotRaised(name), span)


def _raised_by(code: _Code) -> frozenset[str] | None:
    """The events that the code raises; None if it computes the name of one."""
    module = code.read
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Call) and _last(node.func) == "raise_event":
            first = node.args[0] if node.args else next((item.value for item in node.keywords), None)
            if _text(module, first) is None:
                return None
    return frozenset(call.name for call in code.calls if call.method == "raise_event")


def _channels_of(name: str, world: _World) -> tuple[str, ...]:
    """The channels of the topic that a channel names."""
    topic = name.partition(".")[0]
    return tuple(channel for channel in world.channels if channel.partition(".")[0] == topic)


def _is_known(call: _Call, activity: Activity, world: _World) -> bool:
    """Whether it is a name of this system, and not one that another system may have."""
    if call.method in _VARIABLES:
        return call.name in world.variables.get(activity.name, frozenset())
    return call.name in world.channels


__all__ = ["check_code", "check_silence", "code_files", "variables_read"]
