"""Dialogue: whether what the participants of a protocol say and wait for can come about at all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from itertools import chain

from aseme_dsl.amola.aip import Aip, Participant, Plays, answers_when_busy, plays_inside
from aseme_dsl.amola.expression import Event, Received, Send
from aseme_dsl.amola.srm import Activity, Srm
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition
from aseme_dsl.amola.system import Team
from aseme_dsl.compiler.read.builtins import NOT_UNDERSTOOD
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.talk import NoAgentPlays, TooFewAgents, WaitsForEver
from aseme_dsl.records import dataclass

_SHOWN = 4
"""How many related places a problem shows at most."""


# ---- waits that no message ends --------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Said:
    """A message that a participant can send; to `to` alone, or to whom a variable says (None)."""

    performative: str
    message: str
    sender: str
    to: str | None


@dataclass(slots=True)
class _Known:
    """What is known to be possible so far; it only grows."""

    reached: set[str] = field(default_factory=set)
    said: set[_Said] = field(default_factory=set)


def check_waits(
    aips: Iterable[Aip],
    eacs: Mapping[str, Statechart | None],
    srms: Sequence[Srm],
    activities: Mapping[str, Activity],
    memory: Memory,
) -> InPieces[list[Diagnostic]]:
    """W553 for a state that waits only for messages that no other participant can have sent by then.

    The check treats all else as possible: conditions hold, deadlines pass, and agents are lost. An activity
    that is not simulated may send each message that its participant lists and no transition sends, and a
    participant what its role answers while it is busy. So each reported state is a certain deadlock.
    Protocols of the standard library are checked if a role plays them.
    """
    aips = list(aips)
    plays = [item for srm in srms for item in plays_inside(srm.plays, aips)]
    played = {item.protocol for item in plays}
    busy = answers_when_busy(plays)
    looked_at = [
        (
            aip,
            chart,
            memory.same((aip.name, "silent"), silent_activities(chart, plays, activities)),
            memory.same((aip.name, "busy"), _answers(aip, busy)),
        )
        for aip in aips
        if (chart := eacs.get(aip.name)) is not None
        and (aip.name in played or not is_of_library(aip.span.source))
    ]
    return list(chain.from_iterable((yield from memory.each_in_pieces(_waits, looked_at))))


def silent_activities(
    chart: Statechart, plays: Iterable[Plays], activities: Mapping[str, Activity]
) -> frozenset[str]:
    """The activities of a protocol that are simulated in each role that plays it: they send nothing."""
    bindings: dict[tuple[str, str], list[dict[str, str]]] = {}
    for item in plays:
        bindings.setdefault((item.protocol, item.participant), []).append(dict(item.bindings))
    performed: dict[str, set[str]] = {}
    for node in chart.states:
        if node.activity is not None:
            branch = chart.branch_of(node.label)
            origin = chart.node(branch or chart.root.label).origin
            bound = bindings.get((origin.owner, origin.name), [{}])
            own = {names.get(node.activity, node.activity) for names in bound}
            performed.setdefault(node.activity, set()).update(own)
    return frozenset(
        name
        for name, own in performed.items()
        if all((said := activities.get(item)) is not None and not said.has_code for item in own)
    )


def _answers(
    aip: Aip, busy: Mapping[tuple[str, str], Iterable[tuple[str, str]]]
) -> tuple[tuple[str, str, str], ...]:
    """What participants answer while they are busy: participant, performative and message."""
    return tuple(
        (part.name, *said)
        for part in aip.participants
        for said in sorted(busy.get((aip.name, part.name), ()))
    )


def _waits(
    aip: Aip, chart: Statechart, silent: frozenset[str], busy: tuple[tuple[str, str, str], ...]
) -> tuple[Diagnostic, ...]:
    regions = _regions(chart, aip)
    if len(aip.participants) < 2 or len(regions) < len(aip.participants):
        return ()
    stuck = list(_stuck(chart, regions, _possible(chart, regions, aip, silent, busy)))
    return (_told(stuck),) if stuck else ()


def _regions(chart: Statechart, aip: Aip) -> dict[str, str]:
    """The region of each participant, by its name."""
    around = next((node for node in chart.children(chart.root.label) if node.type is StateType.AND), None)
    names = {item.name for item in aip.participants}
    children = () if around is None else chart.children(around.label)
    return {node.name: node.label for node in children if node.name in names}


def _possible(
    chart: Statechart,
    regions: Mapping[str, str],
    aip: Aip,
    silent: frozenset[str],
    busy: Iterable[tuple[str, str, str]],
) -> _Known:
    """What can be reached and said, from the begin of all participants on."""
    known = _Known(said={_Said(performative, message, name, None) for name, performative, message in busy})
    parts = {item.name: item for item in aip.participants}
    for label in regions.values():
        _enter(chart, label, known)
    while True:
        before = len(known.reached), len(known.said)
        for name, label in regions.items():
            _go_on(chart, label, parts[name], known, silent)
        if (len(known.reached), len(known.said)) == before:
            return known


def _go_on(chart: Statechart, region: str, part: Participant, known: _Known, silent: frozenset[str]) -> None:
    """Take every transition of a participant that is possible."""
    by_lines: set[tuple[str, str]] = set()
    for transition in _inside(chart, region):
        if transition.source in known.reached and _is_nested(chart, transition.source):
            _enter(chart, transition.target, known)  # what others say in a conversation inside of this one
            continue
        for action in transition.expression.actions:
            if isinstance(action, Send):
                by_lines.add((action.performative, action.message))
        if transition.source not in known.reached or not _may_be_taken(chart, transition, part.name, known):
            continue
        if transition.changes_state:
            _enter(chart, transition.target, known)
        for action in transition.expression.actions:
            if isinstance(action, Send):
                to = action.participant or None
                known.said.add(_Said(action.performative, action.message, part.name, to))
    acts = any(
        node.type is StateType.BASIC
        and node.activity not in silent
        and node.label.startswith(f"{region}.")
        and node.label in known.reached
        and not _is_nested(chart, node.label)
        for node in chart.states
    )
    for item in part.sends if acts else ():
        if (item.performative, item.message) not in by_lines:
            known.said.add(_Said(item.performative, item.message, part.name, None))


def _inside(chart: Statechart, region: str) -> Iterator[Transition]:
    return (
        item for item in chart.transitions if item.source == region or item.source.startswith(f"{region}.")
    )


def _is_nested(chart: Statechart, label: str) -> bool:
    """Whether a state belongs to a conversation of another protocol, which a participant has inside."""
    return chart.node(label).origin.owner != chart.name


def _enter(chart: Statechart, label: str, known: _Known) -> None:
    """A state and all that is entered with it."""
    todo = [label]
    while todo:
        node = chart.node(todo.pop())
        known.reached.add(node.label)
        if node.type is StateType.AND:
            todo += [child.label for child in chart.children(node.label)]
        elif node.type is StateType.OR:
            start = chart.start_of(node.label)
            todo += [] if start is None else [start.label]


def _may_be_taken(chart: Statechart, transition: Transition, name: str, known: _Known) -> bool:
    expression = transition.expression
    if expression.events:
        return any(_may_happen(event, name, known) for event in expression.events)
    return (
        expression.when or not transition.changes_state or _may_be_complete(chart, transition.source, known)
    )


def _may_happen(event: Event, name: str, known: _Known) -> bool:
    if not isinstance(event, Received) or event.performative == NOT_UNDERSTOOD:
        return True
    return any(
        (said.performative, said.message, said.sender)
        == (event.performative, event.message, event.participant)
        and said.to in (None, name)
        for said in known.said
    )


def _may_be_complete(chart: Statechart, label: str, known: _Known) -> bool:
    node = chart.node(label)
    if node.type is StateType.OR:
        end = chart.end_of(label)
        return end is not None and end.label in known.reached
    if node.type is StateType.AND:
        ends = [chart.end_of(child.label) for child in chart.children(label)]
        return all(end is not None and end.label in known.reached for end in ends)
    return True


def _stuck(
    chart: Statechart, regions: Mapping[str, str], known: _Known
) -> Iterator[tuple[str, State, Received]]:
    """The states in which a participant stays for ever, each with a message for which it waits."""
    for name, region in regions.items():
        for node in chart.states:
            is_leaf = node.type in (StateType.START, StateType.CONDITION, StateType.BASIC)
            if not is_leaf or node.label not in known.reached or not node.label.startswith(f"{region}."):
                continue
            if _is_nested(chart, node.label):
                continue
            own = chart.outgoing_edges(node.label)
            around = [item.label for item in chart.ancestors(node.label) if item.label.startswith(region)]
            ways = [
                *own,
                *(way for label in around for way in chart.outgoing_edges(label) if _cuts_short(way)),
            ]
            waits = [event for way in own for event in way.expression.events if isinstance(event, Received)]
            if waits and not any(_may_be_taken(chart, way, name, known) for way in ways):
                yield name, node, waits[0]


def _cuts_short(way: Transition) -> bool:
    """Whether an outgoing transition of a composite is enabled while something inside is not complete."""
    return bool(way.expression.events) or way.expression.when


def _told(stuck: Sequence[tuple[str, State, Received]]) -> Diagnostic:
    """One message for the protocol: where each waits is one and the same problem."""
    name, _, event = stuck[0]
    others = [
        Related(item.span, f"`{who}` waits here, and cannot continue either")
        for who, _, item in stuck[1:]
        if who != name
    ]
    problem = WaitsForEver(name, event.participant, f"{event.performative} {event.message}")
    return Diagnostic(problem, event.span, tuple(others[:_SHOWN]))


# ---- how many there are ----------------------------------------------------------------------------


def check_multiplicity(
    aips: Iterable[Aip], srms: Iterable[Srm], teams: Iterable[Team]
) -> Iterator[Diagnostic]:
    """W554 for a participant of which a team has fewer agents than take part in each conversation.

    Of one that no role plays, N706 tells. Who opens the conversation does not invite itself.
    """
    aips = list(aips)
    plays: dict[tuple[str, str], set[str]] = {}
    for srm in srms:
        for item in plays_inside(srm.plays, aips):
            plays.setdefault((item.protocol, item.participant), set()).add(srm.name)
    by_name = {srm.name: srm for srm in srms}
    for team in teams:
        for aip in aips:
            for part in aip.participants:
                roles = plays.get((aip.name, part.name), set())
                players = _players(team, roles)
                others = [
                    agent
                    for other in aip.participants
                    if other is not part
                    for agent in _players(team, plays.get((aip.name, other.name), set()))
                ]
                if not roles or not others:
                    continue
                most = max(len(players - {opener}) for opener in others)
                if most < part.least:
                    yield _too_few(
                        team, aip, part, most, () if players else [by_name[role] for role in roles]
                    )


def _players(team: Team, roles: set[str]) -> set[str]:
    return {agent.name for agent in team.agents if agent.role in roles}


def _too_few(team: Team, aip: Aip, part: Participant, most: int, idle: Sequence[Srm]) -> Diagnostic:
    """`idle` are the roles that play it, if no agent of the team has any of them."""
    related = [Related(team.span, "the team")]
    if not idle:
        few = TooFewAgents(part.name, aip.name, part.least, part.most, team.name, most)
        return Diagnostic(few, part.span, tuple(related))
    roles = sorted(idle, key=lambda srm: srm.name)
    related += (Related(srm.span, "the role that does") for srm in roles)
    problem = NoAgentPlays(part.name, aip.name, part.least, team.name, roles[0].name)
    return Diagnostic(problem, part.span, tuple(related))


__all__ = ["check_multiplicity", "check_waits", "silent_activities"]
