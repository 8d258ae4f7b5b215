"""Aliases: `import "alice.aseme" as alice` puts what the file declares behind a name of its own.

In the models, `attacker` of `alice.aseme` is called `alice_attacker`. The trees that are read further
have that name wherever the role is meant: in `alice.aseme` itself, and where another file writes
`alice.attacker`. The place of a name is that of its last word. What a file with an alias imports without
one keeps its own names, so two files that import the same messages share them. Its system, team,
requirements, scenarios and properties are its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, fields, is_dataclass, replace
from enum import Enum
from typing import TypeVar, cast

from aseme_dsl.amola.liveness import Argument, Formula, names, rewritten
from aseme_dsl.amola.messages import BUILT_IN
from aseme_dsl.compiler.read.names import Spelling
from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems import names as problems
from aseme_dsl.grammar.formulas.expression import spelled
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_T = TypeVar("_T")

COMM_TYPES = ("signal", "state", "data")
STATE_QUESTIONS = ("in", "done", "count", "outcome")
"""The functions whose argument is a state or an activity."""
OWN = (tree.System, tree.Team, tree.Sag, tree.Suc, tree.Scenario, tree.Property)
"""What does not count of a file that has an alias."""


class Sort(Enum):
    """The sorts of names that a file declares. Names of different sorts may be equal."""

    TYPE = "type"
    TOPIC = "topic"
    FUNCTION = "function"
    LET = "let"
    ROLE = "role"
    PROTOCOL = "protocol"
    ACTIVITY = "activity"


Exports = Mapping[Sort, Mapping[str, str]]
"""What the names of a file are called in the models, by sort."""


@dataclass(frozen=True, slots=True)
class Imported:
    """An import of a file by another: the keys of both, and how it is written."""

    importer: str
    target: str
    item: tree.Import


def qualified(
    files: Sequence[tuple[str, tree.File]],
    imports: Sequence[Imported],
    all_read: bool,
) -> tuple[tuple[tree.File, ...], tuple[Diagnostic, ...], frozenset[str]]:
    """The files (with their keys, the root last) with the names that they have in the models.

    Also gives what is wrong with aliases, and the names whose uses need no further report.
    """
    if not any(item.item.alias is not None for item in imports):
        return tuple(file for _, file in files), (), frozenset()
    prefixes = _prefixes(files[-1][0] if files else "", imports)
    by_key = dict(files)
    exports = {key: _exports(file, prefixes.get(key, "")) for key, file in files}
    everything = _Everything(
        {name for key, own in exports.items() if not prefixes.get(key) for name in _flat(own)}
        | set(BUILT_IN),
        _roles(files, exports, imports),
        {
            new: exports[key][Sort.ACTIVITY]
            for key in exports
            for sort in (Sort.ROLE, Sort.PROTOCOL)
            for new in exports[key][sort].values()
        },
        _carried(files, exports, imports),
        all_read,
    )
    found: list[Diagnostic] = []
    lost: set[str] = set()
    made: list[tree.File] = []
    for key, file in files:
        aliases: dict[str, Exports] = {}
        taken: dict[str, tree.Name] = {}
        for item in imports:
            alias = item.item.alias
            if item.importer != key or alias is None:
                continue
            found += _wrong(alias, taken, file)
            taken.setdefault(alias.text, alias)
            if item.target in by_key:
                aliases.setdefault(alias.text, exports[item.target])
            else:
                lost.add(alias.text)
        prefix = prefixes.get(key, "")
        if not aliases and not prefix:
            made.append(file)
            continue
        work = _File(exports[key] if prefix else {}, exports[key], aliases, everything, found, lost)
        declarations = tuple(
            work.rewritten(item, _Scope())
            for item in file.declarations
            if not (prefix and isinstance(item, OWN))
        )
        made.append(replace(file, declarations=declarations))
    return tuple(made), tuple(found), frozenset(lost)


def _wrong(alias: tree.Name, taken: Mapping[str, tree.Name], file: tree.File) -> Iterator[Diagnostic]:
    if alias.text in taken:
        first = Related(taken[alias.text].span, "first used here")
        yield Diagnostic(problems.AliasTwice(alias.text), alias.span, (first,))
        return
    for item in file.declarations:
        if isinstance(item, _NAMED) and item.name.text == alias.text:
            declared = Related(item.name.span, "declared here")
            yield Diagnostic(problems.AliasIsName(alias.text), alias.span, (declared,))
            return


_NAMED = (
    tree.Enum,
    tree.Message,
    tree.Topic,
    tree.Function,
    tree.Let,
    tree.Aip,
    tree.Srm,
    tree.Statechart,
)


def _prefixes(root: str, imports: Sequence[Imported]) -> dict[str, str]:
    """What stands before the names of each file in the models; nothing where an import has no alias."""
    plain = {root} | {item.target for item in imports if item.item.alias is None}
    found: dict[str, str] = {}
    waiting = [root]
    seen = {root}
    while waiting:
        key = waiting.pop(0)
        for item in imports:
            if item.importer != key or item.target in seen:
                continue
            seen.add(item.target)
            waiting.append(item.target)
            if item.target not in plain and item.item.alias is not None:
                prefix = f"{found.get(key, '')}{item.item.alias.text}_"
                while prefix in found.values():  # of an alias that is given twice, which is reported
                    prefix += "_"
                found[item.target] = prefix
    return found


def _behind(key: str, exports: Mapping[str, Exports], imports: Sequence[Imported]) -> dict[str, Exports]:
    """What a file has behind its aliases."""
    return {
        item.item.alias.text: exports[item.target]
        for item in imports
        if item.importer == key and item.item.alias is not None and item.target in exports
    }


def _roles(
    files: Sequence[tuple[str, tree.File]], exports: Mapping[str, Exports], imports: Sequence[Imported]
) -> dict[str, _WrittenRole]:
    found = {}
    for key, file in files:
        behind, own = _behind(key, exports, imports), exports[key][Sort.ROLE]
        for item in file.declarations:
            if isinstance(item, tree.Srm):
                includes = []
                for name in item.includes:
                    alias, dot, bare = name.text.rpartition(".")
                    there = behind.get(alias, {}).get(Sort.ROLE, {}) if dot else own
                    includes.append(there.get(bare, bare))
                found[own[item.name.text]] = _WrittenRole(item, tuple(includes))
    return found


def spellings(files: Sequence[tuple[str, tree.File]], imports: Sequence[Imported]) -> dict[str, Spelling]:
    """How each file, by the path that people know it by, writes the names that differ in the models."""
    if not any(item.item.alias is not None for item in imports):
        return {}
    prefixes = _prefixes(files[-1][0] if files else "", imports)
    exports = {key: _exports(file, prefixes.get(key, "")) for key, file in files}
    anywhere = {
        new: f"{prefixes[key].rstrip('_')}.{name}"
        for key in exports
        if prefixes.get(key)
        for own in exports[key].values()
        for name, new in own.items()
    }
    found: dict[str, Spelling] = {}
    for key, file in files:
        written: dict[str, str] = {}
        for alias, other in _behind(key, exports, imports).items():
            written |= {new: f"{alias}.{name}" for own in other.values() for name, new in own.items()}
        if prefixes.get(key):
            written |= {new: name for own in exports[key].values() for name, new in own.items()}
        elsewhere = frozenset(anywhere.keys() - written.keys())
        found[file.source.path] = Spelling(anywhere | written, elsewhere)
    return found


def _carried(
    files: Sequence[tuple[str, tree.File]], exports: Mapping[str, Exports], imports: Sequence[Imported]
) -> dict[str, dict[str, str]]:
    """What the messages of each topic are called; of two that are called the same only one with its alias."""
    found: dict[str, dict[str, str]] = {}
    for key, file in files:
        behind = _behind(key, exports, imports)
        for item in file.declarations:
            if not isinstance(item, tree.Topic):
                continue
            carried = found.setdefault(exports[key][Sort.TOPIC][item.name.text], {})
            for name in (name for entry in item.entries for name in entry.messages):
                alias, dot, bare = name.text.rpartition(".")
                own = behind[alias] if dot and alias in behind else exports[key]
                carried.setdefault(bare, own[Sort.TYPE].get(bare, bare))
    return found


def _flat(exports: Exports) -> Iterator[str]:
    for sort, own in exports.items():
        if sort is not Sort.ACTIVITY:
            yield from own


def _exports(file: tree.File, prefix: str) -> Exports:
    found: dict[Sort, dict[str, str]] = {sort: {} for sort in Sort}

    def put(sort: Sort, name: str) -> None:
        found[sort][name] = prefix + name

    for item in file.declarations:
        match item:
            case tree.Enum() | tree.Message():
                put(Sort.TYPE, item.name.text)
            case tree.Topic():
                put(Sort.TOPIC, item.name.text)
            case tree.Function():
                put(Sort.FUNCTION, item.name.text)
            case tree.Let():
                put(Sort.LET, item.name.text)
            case tree.Aip():
                put(Sort.PROTOCOL, item.name.text)
                for part in item.participants:
                    for name in _activities(part.formulas, part.plays, ()):
                        put(Sort.ACTIVITY, name)
            case tree.Srm():
                put(Sort.ROLE, item.name.text)
                for name in _activities(item.formulas, item.plays, item.includes):
                    put(Sort.ACTIVITY, name)
                for activity in item.activities:
                    put(Sort.ACTIVITY, activity.name.text)
                for module in item.modules:
                    put(Sort.ACTIVITY, module.name.text)
            case tree.Statechart():
                put(Sort.ROLE, item.name.text)
                for node in item.nodes:
                    if node.type.text == "BASIC":
                        doing = node.activity or node.name
                        if isinstance(doing, tree.Name):
                            put(Sort.ACTIVITY, doing.text)
            case _:
                pass
    formulas = {
        formula.name.text
        for item in file.declarations
        if isinstance(item, tree.Srm)
        for formula in item.formulas
    }
    for name in formulas:
        found[Sort.ACTIVITY].pop(name, None)
    return found


def _activities(
    formulas: Sequence[tree.NamedFormula], plays: Sequence[tree.Plays], includes: Sequence[tree.Name]
) -> Iterator[str]:
    """The names in formulas that are neither formulas nor participants."""
    other = {item.name.text for item in formulas}
    other |= {part.text for item in formulas for part in (parameter.name for parameter in item.parameters)}
    other |= {(item.alias or item.participant).text for item in plays}
    other |= {item.text.rpartition(".")[2] for item in includes}
    for item in formulas:
        for node in names(item.formula):
            if node.name not in other:
                yield node.name


@dataclass(frozen=True, slots=True)
class _WrittenRole:
    """A role as it is written, and those that it takes over by their names in the models."""

    written: tree.Srm
    includes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Everything:
    """What the whole program declares: names without an alias, and roles by their names in the models.

    `activities` are those of the file of each role and protocol that has an alias.
    """

    plain: set[str]
    roles: Mapping[str, _WrittenRole]
    activities: Mapping[str, Mapping[str, str]]
    carried: Mapping[str, Mapping[str, str]]
    """The messages of each topic, as they are called where the topic is written, without an alias."""
    all_read: bool


@dataclass(frozen=True, slots=True)
class _Scope:
    """What is known inside of a block: names that mean something there, and the activities of others."""

    local: frozenset[str] = frozenset()
    formulas: frozenset[str] = frozenset()
    activities: Mapping[str, str] = field(default_factory=dict)
    messages: Mapping[str, str] = field(default_factory=dict)
    """Those of the protocols that are played by an alias."""
    inside: bool = False
    """Whether it is a block, and not the file."""

    def within(self, local: Iterable[str], formulas: Iterable[str] = ()) -> _Scope:
        return replace(
            self, local=self.local | set(local), formulas=self.formulas | set(formulas), inside=True
        )


_SORTS: Mapping[tuple[type, str], Sort] = {
    (tree.Enum, "name"): Sort.TYPE,
    (tree.Message, "name"): Sort.TYPE,
    (tree.Field, "type"): Sort.TYPE,
    (tree.Topic, "name"): Sort.TOPIC,
    (tree.Topic, "under"): Sort.TOPIC,
    (tree.TopicEntry, "messages"): Sort.TYPE,
    (tree.Function, "name"): Sort.FUNCTION,
    (tree.Function, "result"): Sort.TYPE,
    (tree.Parameter, "type"): Sort.TYPE,
    (tree.Var, "type"): Sort.TYPE,
    (tree.Given, "type"): Sort.TYPE,
    (tree.ActivityParameter, "type"): Sort.TYPE,
    (tree.FormulaParameter, "type"): Sort.TYPE,
    (tree.AgentMessage, "message"): Sort.TYPE,
    (tree.Received, "message"): Sort.TYPE,
    (tree.Send, "message"): Sort.TYPE,
    (tree.NewMessage, "message"): Sort.TYPE,
    (tree.Aip, "name"): Sort.PROTOCOL,
    (tree.Plays, "protocol"): Sort.PROTOCOL,
    (tree.Srm, "name"): Sort.ROLE,
    (tree.Statechart, "name"): Sort.ROLE,
    (tree.Srm, "includes"): Sort.ROLE,
    (tree.TeamAgents, "role"): Sort.ROLE,
    (tree.Activity, "name"): Sort.ACTIVITY,
    (tree.AgentMessage, "by"): Sort.ACTIVITY,
    (tree.Capability, "activities"): Sort.ACTIVITY,
    (tree.Place, "name"): Sort.ACTIVITY,
    (tree.ChartNode, "name"): Sort.ACTIVITY,
    (tree.ChartNode, "activity"): Sort.ACTIVITY,
    (tree.TopicEntry, "sources"): Sort.ACTIVITY,
    (tree.Binding, "abstract"): Sort.ACTIVITY,
    (tree.Binding, "own"): Sort.ACTIVITY,
}
"""Where a name of a file stands in the tree."""


@dataclass(frozen=True, slots=True)
class _File:
    """The work on one file. `own` is what changes there, `declared` what it declares."""

    own: Exports
    declared: Exports
    aliases: Mapping[str, Exports]
    everything: _Everything
    found: list[Diagnostic]
    lost: set[str]

    def rewritten(self, node: _T, scope: _Scope) -> _T:
        """A part of the tree, with the names of the models."""
        return cast(_T, self._any(node, scope))

    def _any(self, node: object, scope: _Scope) -> object:
        match node:
            case tuple():
                made = tuple(self._any(item, scope) for item in node)
                return node if all(a is b for a, b in zip(made, node, strict=True)) else made
            case tree.Path():
                return self._path(node, scope)
            case tree.Call():
                return self._call(node, scope)
            case Formula():
                return self._formula(node, scope)
            case tree.Let():
                name = node.name if scope.inside else self._own_name(Sort.LET, node.name)
                return replace(node, name=name, expression=self.rewritten(node.expression, scope))
            case tree.ActivityRead():
                path = self._topic(node.path) if len(node.path.segments) < 3 else self._path(node.path, scope)
                return replace(node, path=path)
            case tree.Import():
                return node
        if not is_dataclass(node) or isinstance(node, (type, Span, tree.Name, tree.Text, tree.Number)):
            return node
        return self._fields(node, self._inside(node, scope))

    def _fields(self, node: object, scope: _Scope) -> object:
        changed: dict[str, object] = {}
        for item in fields(node):  # type: ignore[arg-type]
            value = getattr(node, item.name)
            sort = _SORTS.get((type(node), item.name))
            if sort is None:
                new = self._any(value, scope)
            elif isinstance(value, tuple):
                new = tuple(self._name(sort, name, scope) for name in value)
            else:
                sent = isinstance(node, tree.Send)
                new = self._name(sort, value, scope, sent) if isinstance(value, tree.Name) else value
            if new is not value:
                changed[item.name] = new
        return replace(node, **changed) if changed else node  # type: ignore[type-var]

    def _inside(self, node: object, scope: _Scope) -> _Scope:
        """What is known inside of a block."""
        match node:
            case tree.Aip():
                return scope.within(item.name.text for item in node.lets)
            case tree.Participant():
                local = [item.name.text for item in (*node.variables, *node.results)]
                local += [item.name.text for item in node.inputs]
                local += [item.name.text for item in node.lets]
                formulas = [item.name.text for item in node.formulas]
                formulas += [(item.alias or item.participant).text for item in node.plays]
                made = scope.within(local, formulas)
                return self._with_others(made, node.plays, ())
            case tree.Srm():
                roles = self._included(node)
                local = [item.name.text for role in roles for item in role.variables]
                local += [item.name.text for role in roles for item in role.lets]
                formulas = [item.name.text for role in roles for item in role.formulas]
                formulas += [(item.alias or item.participant).text for role in roles for item in role.plays]
                made = scope.within(local, formulas)
                return self._with_others(made, node.plays, node.includes)
            case tree.Statechart():
                local = [item.name.text for item in node.variables]
                return scope.within([*local, *(item.name.text for item in node.lets)])
            case tree.NamedFormula():
                given = [item.name.text for item in node.parameters]
                return scope.within(given, given)
            case tree.Activity():
                return scope.within(item.name.text for item in node.parameters)
            case tree.TransitionExpression():
                bound = [
                    item.name.text
                    for item in node.events
                    if isinstance(item, (tree.Received, tree.Lost)) and item.name is not None
                ]
                return scope.within(bound) if bound else scope
        return scope

    def _included(self, role: tree.Srm) -> list[tree.Srm]:
        """The role and those that it takes over, as far as they are there."""
        roles = self.everything.roles
        own = roles.get(self.declared[Sort.ROLE].get(role.name.text, ""))
        found, waiting = [role], list(own.includes if own is not None else ())
        while waiting:
            other = roles.get(waiting.pop())
            if other is not None and all(other.written is not item for item in found):
                found.append(other.written)
                waiting += other.includes
        return found

    def _with_others(
        self, scope: _Scope, plays: Sequence[tree.Plays], includes: Sequence[tree.Name]
    ) -> _Scope:
        """The scope with what is in the files whose protocols and roles are used by an alias."""
        activities: dict[str, str] = {}
        messages: dict[str, str] = {}
        used = [(Sort.PROTOCOL, item.protocol.text) for item in plays]
        used += [(Sort.ROLE, item.text) for item in includes]
        for sort, text in used:
            alias, dot, name = text.partition(".")
            if dot and name in self.aliases.get(alias, {}).get(sort, {}):
                activities.update(self.aliases[alias][Sort.ACTIVITY])
                if sort is Sort.PROTOCOL:
                    messages = {**self.aliases[alias][Sort.TYPE], **messages}
        return replace(scope, activities=activities, messages=messages)

    # ---- names -------------------------------------------------------------------------------

    def _own_name(self, sort: Sort, name: tree.Name) -> tree.Name:
        new = self.own.get(sort, {}).get(name.text)
        return name if new is None else tree.Name(new, name.span)

    def _name(self, sort: Sort, name: object, scope: _Scope, is_message: bool = False) -> object:
        if not isinstance(name, tree.Name):
            return name
        if "." in name.text:
            return self._dotted(sort, name)
        if sort is Sort.ACTIVITY:
            if name.text in scope.formulas or name.text in scope.local:
                return name
            if name.text in scope.activities:
                return tree.Name(scope.activities[name.text], name.span)
        elif name.text not in self.declared[sort] and name.text not in self.everything.plain:
            if sort is Sort.TYPE and name.text in scope.messages and is_message:
                return tree.Name(scope.messages[name.text], name.span)
            self._only_under_alias((sort,), name)
        return self._own_name(sort, name)

    def _state(self, name: tree.Name, scope: _Scope) -> tree.Name:
        found = self._name(Sort.ACTIVITY, name, scope)
        assert isinstance(found, tree.Name)
        return found

    def _dotted(self, sort: Sort, name: tree.Name) -> tree.Name:
        """`alice.Ball`, in one name; its place is that of `Ball` alone."""
        alias, _, rest = name.text.partition(".")
        first = Span(name.span.source, name.span.start, name.span.start + len(alias))
        last = Span(name.span.source, name.span.end - len(rest), name.span.end)
        new = self._behind(alias, (sort,), tree.Name(alias, first), tree.Name(rest, last))
        return tree.Name(new, last)

    def _behind(self, alias: str, sorts: Sequence[Sort], first: tree.Name, last: tree.Name) -> str:
        """What a name behind an alias is called in the models."""
        if alias not in self.aliases:
            if alias not in self.lost:
                known = tuple(self.aliases)
                near = closest(alias, known)
                self.found.append(Diagnostic(problems.NoAlias(alias, near, known), first.span, fix=near))
            self.lost.add(last.text)
            return last.text
        for sort in sorts:
            if last.text in self.aliases[alias][sort]:
                return self.aliases[alias][sort][last.text]
        known = tuple(name for sort in sorts for name in self.aliases[alias][sort])
        near = closest(last.text, known)
        problem = problems.NotBehindAlias(alias, sorts[0].value, last.text, near, known)
        if self.everything.all_read:
            self.found.append(Diagnostic(problem, last.span, fix=near))
        self.lost.add(last.text)
        return last.text

    def _only_under_alias(self, sorts: Sequence[Sort], name: tree.Name) -> bool:
        places = tuple(
            f"{alias}.{name.text}"
            for alias, exports in self.aliases.items()
            if any(name.text in exports[sort] for sort in sorts)
        )
        if not places or name.text in self.lost:
            return False
        fix = places[0] if len(places) == 1 else None
        self.found.append(Diagnostic(problems.OnlyBehindAlias(name.text, places), name.span, fix=fix))
        self.lost.add(name.text)
        return True

    # ---- dotted names ------------------------------------------------------------------------

    def _path(self, path: tree.Path, scope: _Scope) -> tree.Path:
        segments = path.segments
        first = segments[0].text
        if first in scope.local:
            return path
        comm = next((at for at, item in enumerate(segments) if at and item.text in COMM_TYPES), None)
        if comm is not None:
            return self._channel(path, comm)
        sorts = (Sort.TYPE, Sort.LET, Sort.TOPIC)
        if first in self.aliases and len(segments) > 1:
            new = self._behind(first, sorts, segments[0], segments[1])
            return replace(path, segments=(tree.Name(new, segments[1].span), *segments[2:]))
        for sort in sorts:
            if first in self.own.get(sort, {}):
                return replace(path, segments=(self._own_name(sort, segments[0]), *segments[1:]))
        if first not in self.everything.plain and not any(first in self.declared[sort] for sort in sorts):
            self._only_under_alias(sorts, segments[0])
        return path

    def _topic(self, path: tree.Path) -> tree.Path:
        """A topic alone."""
        segments = path.segments
        if len(segments) == 2:
            new = self._behind(segments[0].text, (Sort.TOPIC,), *segments)
            return replace(path, segments=(tree.Name(new, segments[1].span),))
        return replace(path, segments=(self._own_name(Sort.TOPIC, segments[0]),))

    def _channel(self, path: tree.Path, comm: int) -> tree.Path:
        """`sender.alias.topic.state.alias.Message.member`, where sender and aliases may be missing."""
        before, after = path.segments[:comm], path.segments[comm:]
        topic = before[-1]
        if len(before) > 1 and before[-2].text in self.aliases:
            alias = before[-2]
            new = self._behind(alias.text, (Sort.TOPIC,), alias, topic)
            before = (*before[:-2], tree.Name(new, topic.span))
        else:
            if topic.text not in self.declared[Sort.TOPIC] and topic.text not in self.everything.plain:
                self._only_under_alias((Sort.TOPIC,), topic)
            before = (*before[:-1], self._own_name(Sort.TOPIC, topic))
        if len(after) > 2 and after[1].text in self.aliases:
            message = self._behind(after[1].text, (Sort.TYPE,), after[1], after[2])
            after = (after[0], tree.Name(message, after[2].span), *after[3:])
        elif len(after) > 1:
            carried = self.everything.carried.get(before[-1].text, {})
            if after[1].text in carried:
                after = (after[0], tree.Name(carried[after[1].text], after[1].span), *after[2:])
        return replace(path, segments=(*before, *after))

    def _call(self, call: tree.Call, scope: _Scope) -> tree.Call:
        segments = call.function.segments
        function = call.function
        if len(segments) == 2 and segments[0].text in self.aliases:
            new = self._behind(segments[0].text, (Sort.FUNCTION,), *segments)
            function = replace(function, segments=(tree.Name(new, segments[1].span),))
        elif len(segments) == 1:
            function = replace(function, segments=(self._own_name(Sort.FUNCTION, segments[0]),))
        arguments = call.arguments
        if function.text in STATE_QUESTIONS and len(arguments) == 1 and isinstance(arguments[0], tree.Path):
            first, *others = arguments[0].segments
            arguments = (replace(arguments[0], segments=(self._state(first, scope), *others)),)
        else:
            arguments = self.rewritten(arguments, scope)
        return replace(call, function=function, arguments=arguments)

    def _formula(self, formula: Formula, scope: _Scope) -> Formula:
        """A formula with the names of its activities."""

        def renamed(node: Formula) -> Formula:
            name = node.name
            if name and name not in scope.formulas and name not in scope.local:
                name = scope.activities.get(name) or self.own.get(Sort.ACTIVITY, {}).get(name, name)
            if name == node.name and not node.arguments:
                return node
            arguments = tuple(self._argument(item, scope) for item in node.arguments)
            return replace(node, name=name, arguments=arguments)

        return rewritten(formula, renamed)

    def _argument(self, argument: Argument, scope: _Scope) -> Argument:
        value = self._any(argument.value, scope)
        if value is argument.value:
            return argument
        return replace(argument, value=value, text=spelled(cast("tree.Expression", value)))


__all__ = ["Imported", "qualified", "spellings"]
