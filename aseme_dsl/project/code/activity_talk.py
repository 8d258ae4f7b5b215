"""Talk of activities: whether the agent messages in the Python of activities are those of their participants.

`context.send("inform", Done(…), "manager")`, `context.receive("propose", "Bid")`, `context.last_received(…)`.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from typing import Literal

from aseme_dsl.amola.aip import AgentMessage, Participant, answers_when_busy, plays_inside
from aseme_dsl.amola.expression import Received, Send
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.amola.system import System
from aseme_dsl.compiler.read.builtins import NOT_UNDERSTOOD, PERFORMATIVES
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.diagnostics import Diagnostic, Problem, Related, closest
from aseme_dsl.diagnostics.problems.python.code_words import (
    NeverSaid,
    NoPerformativeInCode,
    NotOfParticipant,
    SentByLine,
)
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_TAKES = ("receive", "last_received")
_METHODS = ("send", *_TAKES)


@dataclass(frozen=True, slots=True)
class Talk:
    """A call that sends or takes an agent message; None stands for what the text does not say."""

    method: str
    performative: str | None
    message: str | None
    span: Span

    @property
    def said(self) -> str:
        return f"{self.performative or '…'} {self.message or '…'}"


def talk_in(
    module: ast.Module,
    span: Callable[[ast.expr], Span],
    text: Callable[[ast.expr | None], str | None],
    contexts: Collection[str],
) -> tuple[Talk, ...]:
    """The calls of a module on what it calls a context, in the order of the text."""
    found = []
    for node in ast.walk(module):
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
            continue
        if node.func.attr not in _METHODS or _last(node.func.value) not in contexts:
            continue
        named = {keyword.arg: keyword.value for keyword in node.keywords}
        given = dict(zip(("performative", "message"), node.args, strict=False)) | named
        performative, message = given.get("performative"), given.get("message")
        kind = _made(message) if node.func.attr == "send" else text(message)
        found.append(Talk(node.func.attr, text(performative), kind, span(node)))
    return tuple(sorted(found, key=lambda item: item.span.start))


def _last(node: ast.expr) -> str | None:
    return node.id if isinstance(node, ast.Name) else getattr(node, "attr", None)


def _made(node: ast.expr | None) -> str | None:
    """The type of a message that is made where it is sent: `Done(task=1)`."""
    return _last(node.func) if isinstance(node, ast.Call) else None


# ---- what one activity says ------------------------------------------------------------------------


Parts = Mapping[str, tuple[Participant, ...]]
"""Of each activity: the participants in whose branches it stands."""


def sent_by_lines(
    system: System, parts: Parts, talks: Mapping[str, tuple[Talk, ...]]
) -> Iterator[Diagnostic]:
    """W555 for what an activity sends and, in each participant in which it stands, only a line may send."""
    charts = {id(part): system.eac(aip.name) for aip in system.aips for part in aip.participants}
    for name, said in talks.items():
        for talk in said if parts.get(name) else ():
            mine = [part for part in parts[name] if _fits(talk, _listed(talk, [part]))]
            if talk.method != "send" or talk.performative is None or not mine:
                continue
            lines = [(part, _by_lines(chart, part)[0]) for part in mine if (chart := charts[id(part)])]
            kinds = [(item.performative, item.message) for item in _listed(talk, mine) if _fits(talk, [item])]
            if len(lines) == len(mine) and all(kind in sent for kind in kinds for _, sent in lines):
                problem = SentByLine(name, " ".join(kinds[0]), mine[0].name)
                yield Diagnostic(problem, talk.span, tuple(Related(p.span, "the participant") for p in mine))


def unfit_talk(parts: Parts, talks: Mapping[str, tuple[Talk, ...]]) -> Iterator[Diagnostic]:
    """W555 for what an activity sends or takes and no participant does in which it stands.

    `talks` are those of the activities of which there is code.
    """
    for name, said in talks.items():
        mine = parts.get(name, ()) if said else ()
        for talk in said if mine else ():
            yield from _unfit(name, talk, mine)


def _unfit(name: str, talk: Talk, parts: Iterable[Participant]) -> Iterator[Diagnostic]:
    parts = tuple(parts)
    listed = _listed(talk, parts)
    if _fits(talk, listed):
        return
    problem: Problem
    if talk.performative is not None and talk.performative not in PERFORMATIVES:
        near = closest(talk.performative, PERFORMATIVES)
        problem = NoPerformativeInCode(talk.performative, near, tuple(PERFORMATIVES))
    else:
        whole = tuple(f"{item.performative} {item.message}" for item in listed)
        problem = NotOfParticipant(
            name,
            "sends" if talk.method == "send" else "receives",
            talk.said,
            tuple(dict.fromkeys(part.name for part in parts)),
            closest(talk.said, whole),
            whole,
        )
    yield Diagnostic(problem, talk.span, tuple(Related(part.span, "the participant") for part in parts))


def _listed(talk: Talk, parts: Iterable[Participant]) -> list[AgentMessage]:
    """What participants send or receive, as the call does."""
    return [item for part in parts for item in (part.sends if talk.method == "send" else part.receives)]


def _fits(talk: Talk, listed: Iterable[AgentMessage]) -> bool:
    """Whether a call may be about one of the messages, as far as its text says."""
    if talk.performative is None and talk.message is None:
        return True
    return any(
        talk.performative in (None, item.performative) and talk.message in (None, item.message)
        for item in listed
    )


def parts_of(system: System, memory: Memory) -> Parts:
    """Of each activity of a system: the participants in whose branches it stands."""
    named = {(aip.name, part.name): part for aip in system.aips for part in aip.participants}
    found: dict[str, dict[tuple[str, str], Participant]] = {}
    for placed in memory.each(_placed_in, [(chart,) for chart in system.iacs]):
        for activity, origin in placed:
            part = named.get(origin)
            if part is not None:
                found.setdefault(activity, {}).setdefault(origin, part)
    return {name: tuple(parts.values()) for name, parts in found.items()}


def _placed_in(chart: Statechart) -> tuple[tuple[str, tuple[str, str]], ...]:
    """Which activities of a role stand in the branch of which protocol's participant."""
    found: list[tuple[str, tuple[str, str]]] = []
    for node in chart.states:
        if node.type is not StateType.BASIC or node.activity is None:
            continue
        branch = chart.branch_of(node.label)
        origin = None if branch is None else chart.node(branch).origin
        if origin is not None:
            found.append((node.activity, (origin.owner, origin.name)))
    return tuple(dict.fromkeys(found))


# ---- unsaid ----------------------------------------------------------------------------------------


def unsaid(
    system: System, parts: Parts, talks: Mapping[str, tuple[Talk, ...]], helpers: Iterable[Talk]
) -> Iterator[Diagnostic]:
    """W556 for what a participant lists and neither a line of it nor one of its activities sends or takes.

    What a role answers while it is busy is sent. Only where there is code of all activities of the
    participant, or they are simulated, and so say nothing: else it may still be written. What a wrong call
    (W555) may have been meant for is not told.
    """
    activities: dict[int, list[str]] = {}
    for name, mine in parts.items():
        for part in mine:
            activities.setdefault(id(part), []).append(name)
    shared = tuple(helpers)
    busy = answers_when_busy(item for srm in system.srms for item in plays_inside(srm.plays, system.aips))
    for aip in system.aips:
        chart = system.eac(aip.name)
        if chart is None or is_of_library(aip.span.source):
            continue
        for part in aip.participants:
            names = activities.get(id(part), [])
            if not names or not all(name in talks for name in names):
                continue
            said = [*shared, *(talk for name in names for talk in talks[name])]
            wrong = [
                talk for name in names for talk in talks[name] if not _fits(talk, _listed(talk, parts[name]))
            ]
            answers = busy.get((aip.name, part.name), frozenset())
            yield from _never(part, chart, said, wrong, answers)


def _never(
    part: Participant,
    chart: Statechart,
    said: list[Talk],
    wrong: list[Talk],
    busy: Collection[tuple[str, str]],
) -> Iterator[Diagnostic]:
    sent, taken = _by_lines(chart, part)
    sent.update(busy)
    verbs: tuple[Literal["sends", "takes"], ...] = ("sends", "takes")
    for verb in verbs:
        items, lines = (part.sends, sent) if verb == "sends" else (part.receives, taken)
        for item in items:
            by_code = any(
                talk.method == ("send" if verb == "sends" else "receive")
                and talk.performative in (None, item.performative)
                and talk.message in (None, item.message)
                for talk in said
            )
            is_meant = any(
                (talk.method == "send") == (verb == "sends")
                and (talk.performative == item.performative or talk.message == item.message)
                for talk in wrong
            )
            whole = (item.performative, item.message)
            if whole in lines or by_code or is_meant or item.performative == NOT_UNDERSTOOD:
                continue
            yield Diagnostic(NeverSaid(part.name, verb, item.performative, item.message), item.span)


def _by_lines(chart: Statechart, part: Participant) -> tuple[set[tuple[str, str]], set[tuple[str, str]]]:
    """What the lines of a participant send and take."""
    around = next((node for node in chart.children(chart.root.label) if node.type is StateType.AND), None)
    children = () if around is None else chart.children(around.label)
    region = next((node.label for node in children if node.name == part.name), chart.root.label)
    sent: set[tuple[str, str]] = set()
    taken: set[tuple[str, str]] = set()
    for transition in chart.transitions:
        if transition.source != region and not transition.source.startswith(f"{region}."):
            continue
        for event in transition.expression.events:
            if isinstance(event, Received):
                taken.add((event.performative, event.message))
        for action in transition.expression.actions:
            if isinstance(action, Send):
                sent.add((action.performative, action.message))
    return sent, taken


__all__ = ["Parts", "Talk", "parts_of", "sent_by_lines", "talk_in", "unfit_talk", "unsaid"]
