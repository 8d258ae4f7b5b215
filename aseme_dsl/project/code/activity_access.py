"""Activity access: what the code of an activity reads or writes that its declaration does not name."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Literal

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.compiler.read.missing import in_block
from aseme_dsl.diagnostics import Diagnostic, Edit, Related
from aseme_dsl.diagnostics.problems.python.code import AccessNotDeclared, HistoryNotDeclared
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import nanoseconds
from aseme_dsl.source import Span, is_library_path

if TYPE_CHECKING:
    from aseme_dsl.amola.srm import Activity

Clause = Literal["reads", "writes"]
Place = Callable[[ast.expr | ast.stmt | ast.alias], Span]
"""Where a node of the Python of activities stands in its file."""
HISTORIES = ("history", "at", "interpolated", "mean")
READS = ("read", "latest_message", "latest_sample", "age", "consume", *HISTORIES)
BLOCKS = {"activity": "activities", "module": "modules"}
"""Where each is declared."""

_SECONDS = {
    "at": (1, "seconds_ago"),
    "interpolated": (2, "seconds_ago"),
    "mean": (2, "seconds"),
    "history": (9, "seconds"),
}
"""Of the calls that look back: which argument says how far."""


@dataclass(frozen=True, slots=True)
class Access:
    """A call on the context that reads or writes: the channel or variable, its place, and how far back (ns).

    `owner` is the class or function of the module in which the call stands, "" outside of all.
    """

    method: str
    name: str
    span: Span
    owner: str
    back: int | None


def looks_back(call: ast.Call, method: str) -> int | None:
    """How far back a call looks, in ns, if it says so with a number."""
    place, name = _SECONDS.get(method, (9, ""))
    given = next((item.value for item in call.keywords if item.arg == name), None)
    if given is None and len(call.args) > place:
        given = call.args[place]
    if not (isinstance(given, ast.Constant) and isinstance(given.value, (int, float))):
        return None
    try:
        return nanoseconds(given.value)
    except ValueError:
        return None


def owners(tree: ast.Module) -> Iterator[tuple[str, ast.stmt]]:
    """The statements of a module, each with the name of the class or function that it defines."""
    for node in tree.body:
        yield (
            node.name if isinstance(node, (ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) else "",
            node,
        )


def used_by(tree: ast.Module, wanted: str) -> frozenset[str]:
    """The classes and functions of a module that the class `wanted` uses, itself among them."""
    defined = {name: node for name, node in owners(tree) if name}
    found: set[str] = set()
    waiting = [wanted]
    while waiting:
        name = waiting.pop()
        if name in defined and name not in found:
            found.add(name)
            waiting += (node.id for node in ast.walk(defined[name]) if isinstance(node, ast.Name))
    return frozenset(found)


def executes_of(tree: ast.Module, wanted: Iterable[str]) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    """The methods `execute` of the classes `wanted`, and of those of the module that these inherit from.

    Not those that a decorator has changed.
    """
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    waiting, seen = list(wanted), set[str]()
    while waiting:
        name = waiting.pop()
        node = classes.get(name)
        if node is None or name in seen:
            continue
        seen.add(name)
        waiting += (base.id for base in node.bases if isinstance(base, ast.Name))
        for item in node.body:
            if not isinstance(item, (ast.FunctionDef, ast.AsyncFunctionDef)):
                continue
            if item.name == "execute" and not item.decorator_list:
                yield item


def undeclared(
    accesses: Iterable[Access],
    activity: Activity,
    what: str,
    own: frozenset[str],
    roles: Sequence[Span],
) -> Iterator[Diagnostic]:
    """E540 for each channel and variable that is used and not declared; `own` are variables of participants.

    `roles` are the places of the roles that perform the activity.
    """
    lacking: dict[tuple[Clause, str], Access] = {}
    far: dict[str, Access] = {}
    histories = _histories(activity)
    for access in accesses:
        name = access.name
        match access.method:
            case "get_variable":
                if name not in own and name not in activity.reads_variables:
                    lacking.setdefault(("reads", name), access)
            case "set_variable":
                if name not in own and name not in activity.writes_variables:
                    lacking.setdefault(("writes", name), access)
            case "publish":
                if name not in map(str, activity.writes):
                    lacking.setdefault(("writes", name), access)
            case method if method in HISTORIES:
                kept = histories.get(name, 0)
                if kept == 0 if access.back is None else access.back > kept:
                    before = far.get(name)
                    if before is None or (access.back or 0) > (before.back or 0):
                        far[name] = access
                elif name not in histories and not _by_topic(activity, name):
                    lacking.setdefault(("reads", name), access)
            case method if method in READS:
                if name not in histories and not _by_topic(activity, name):
                    lacking.setdefault(("reads", name), access)
    related = (Related(activity.span, f"the {what}"),)
    block = BLOCKS[what]
    for (clause, name), access in lacking.items():
        if clause == "reads" and name in far:
            continue
        problem = AccessNotDeclared(activity.name, clause, name, block)
        edits = _edits(activity, what, clause, name, roles)
        yield Diagnostic(problem, access.span, related, edits=edits)
    for name, access in far.items():
        kept = histories.get(name, 0)
        back = None if access.back is None else duration_text(access.back)
        declared = duration_text(kept) if kept else None
        edits = () if back is None else _longer(activity, what, name, f"{name} for {back}", roles)
        far_back = HistoryNotDeclared(activity.name, name, back, declared, block)
        yield Diagnostic(far_back, access.span, related, edits=edits)


def _by_topic(activity: Activity, channel: str) -> bool:
    """Whether a whole topic that the activity reads may have the channel."""
    topic = channel.partition(".")[0]
    whole = [item for item in activity.reads if item.channel is None]
    return any(item.reach != "on" or item.topic == topic for item in whole)


def _histories(activity: Activity) -> Mapping[str, int]:
    """How far back the activity looks at each channel that it reads, in ns."""
    found: dict[str, int] = {}
    for item in activity.reads:
        if item.channel is not None:
            found[str(item.channel)] = max(found.get(str(item.channel), 0), item.history)
    return found


# ---- the edit that declares it -------------------------------------------------------------------

_PATH = r"[A-Za-z_]\w*(?:\s*\.\s*[A-Za-z_]\w*)*"
_READ = rf"(?:(?:above|below|around)\s+)?{_PATH}(?:\s+for\s+[0-9][0-9.]*\s*(?:ns|us|ms|s|min|h)\b)?"
_CLAUSES = {
    "reads": re.compile(rf"\breads\s+{_READ}(?:\s*,\s*{_READ})*", re.ASCII),
    "writes": re.compile(rf"\bwrites\s+{_PATH}(?:\s*,\s*{_PATH})*", re.ASCII),
}
_HIDDEN = re.compile(r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_ROLE = re.compile(r"\b(?:srm|statechart)\s+\w+\s*$", re.ASCII)


def _edits(activity: Activity, what: str, clause: str, name: str, roles: Iterable[Span]) -> tuple[Edit, ...]:
    """The edit that declares a channel or variable; none where no role of the user performs the activity."""
    for place in (activity.span, *roles):
        if is_library_path(place.source.path):
            continue
        text = _bare(place.source.text)
        role = _role_around(text, place)
        if role is None:
            continue
        block = _block_in(text, role, BLOCKS[what])
        if block is None:
            lines = [f"{BLOCKS[what]} {{", f"  {activity.name} {clause} {name}", "}"]
            return _inserted(role, lines)
        if block.start < activity.span.start < block.end and activity.span.source == place.source:
            return (_in_statement(text, activity.span, clause, name),)
        return _inserted(block, [f"{activity.name} {clause} {name}"])
    return ()


def _longer(activity: Activity, what: str, name: str, wanted: str, roles: Iterable[Span]) -> tuple[Edit, ...]:
    """The edit that declares a history, or a longer one."""
    own = next((item for item in activity.reads if str(item.channel) == name), None)
    if own is None:
        return _edits(activity, what, "reads", wanted, roles)
    host = f"{own.host}." if own.host is not None else ""
    return (Edit(own.span, host + wanted),)


def _in_statement(text: str, statement: Span, clause: str, name: str) -> Edit:
    """Behind what the clause has, or as a clause at the end of the statement."""
    written = text[statement.start : statement.end]
    clauses = list(_CLAUSES[clause].finditer(written))
    if clauses:
        at, added = statement.start + clauses[-1].end(), f", {name}"
    else:
        end = written.find("=")
        at = statement.start + len(written[: end if end >= 0 else None].rstrip())
        added = f" {clause} {name}"
    return Edit(Span(statement.source, at, at), added)


def _inserted(block: Span, lines: list[str]) -> tuple[Edit, ...]:
    at, piece = in_block(block.source.text, block, lines)
    if piece.startswith("\n") and at > 0 and block.source.text[at - 1] == "\n":
        piece = piece[1:]  # no empty line before it
    return (Edit(Span(block.source, at, at), piece),)


def _bare(text: str) -> str:
    """The text with blanks instead of comments and strings."""
    return _HIDDEN.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def _role_around(text: str, place: Span) -> Span | None:
    """The block, braces included, of the role whose name or text a place is in."""
    depth = opened = begun = 0
    for found in re.finditer(r"[{}]", text):
        at = found.start()
        if found.group() == "{":
            opened, depth = (at, 1) if depth == 0 else (opened, depth + 1)
            continue
        depth -= 1
        if depth > 0:
            continue
        if depth < 0 or at >= place.start:
            is_role = depth == 0 and begun <= place.start and _ROLE.search(text[begun:opened])
            return Span(place.source, opened, at + 1) if is_role else None
        begun = at + 1
    return None


def _block_in(text: str, role: Span, word: str) -> Span | None:
    """The first block of a role that is called so."""
    found = re.compile(rf"\b{word}\s*\{{").search(text, role.start + 1, role.end)
    if found is None:
        return None
    end = text.find("}", found.end(), role.end)
    return None if end < 0 else Span(role.source, found.end() - 1, end + 1)


__all__ = [
    "BLOCKS",
    "HISTORIES",
    "READS",
    "Access",
    "executes_of",
    "looks_back",
    "owners",
    "undeclared",
    "used_by",
]
