"""Which variables need copies during a step, since a region does not see what another has just written."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.amola.expression import Raised, TransitionExpression, VariableValue, values_of
from aseme_dsl.amola.statechart import TransitionKind
from aseme_dsl.codegen.program.events import Events
from aseme_dsl.codegen.program.flat import FlatChart
from aseme_dsl.codegen.program.following import Following
from aseme_dsl.codegen.program.moves import assigned
from aseme_dsl.codegen.program.uses import Uses
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class _Use:
    """A variable is read or written in a region."""

    variable: str
    region: int
    writes: bool = False


def copies_of(
    flat: FlatChart, uses: Uses, events: Events, following: Following, *, watched: bool
) -> dict[str, tuple[int, ...]]:
    """The variables that some regions may look at after others wrote them, with those that need a copy.

    Who does not write, and is not inside a region that does, finds on the blackboard what there was when
    the step began. `watched`: activities are given values as they start.
    """
    known = _uses(flat, watched)
    found: set[str] = set()
    for mode in events.modes:
        reads, writes = _in_mode(known, mode)
        loops = following.may_loop(mode)
        for name, writers in writes.items():
            readers = reads.get(name, set())
            others = {(w, u) for w in writers for u in readers | (writers if loops else set()) if u != w}
            if any(loops or _looks_later(flat, u, w) for w, u in others):
                found.add(name)
    written: dict[str, set[int]] = {}
    for transition in flat.chart.transitions:
        for name in assigned(transition.expression):
            written.setdefault(name, set()).add(flat.region_number[transition.source])
            leaves = transition.kind in (TransitionKind.EXIT, TransitionKind.ABANDON)
            if leaves and len(uses.variable_regions[name]) > 1:
                found.add(name)
    return {
        name: tuple(
            region
            for region in uses.variable_regions[name]
            if any(around in written[name] for around in flat.with_around(region))
        )
        for name in sorted(found)
    }


def _in_mode(
    known: Mapping[str | None, tuple[_Use, ...]], mode: str
) -> tuple[dict[str, set[int]], dict[str, set[int]]]:
    """The regions that may read, and those that may write each variable in a step of a mode."""
    reads: dict[str, set[int]] = {}
    writes: dict[str, set[int]] = {}
    for use in (*known.get(None, ()), *(known.get(mode, ()) if mode else ())):
        (writes if use.writes else reads).setdefault(use.variable, set()).add(use.region)
    return reads, writes


def _uses(flat: FlatChart, watched: bool) -> dict[str | None, tuple[_Use, ...]]:
    """The uses of variables that only an event opens, by the event; None for all others."""
    found: dict[str | None, dict[_Use, None]] = {}
    for transition in flat.chart.transitions:
        expression = transition.expression
        raised = [event.name for event in expression.events if isinstance(event, Raised)]
        only_raised = raised and len(raised) == len(expression.events) and not expression.when
        region = flat.region_number[transition.source]
        uses = [_Use(v.name, region) for v in values_of(expression) if isinstance(v, VariableValue)]
        uses += [_Use(name, region, writes=True) for name in assigned(expression)]
        for event in raised if only_raised else (None,):
            found.setdefault(event, {}).update(dict.fromkeys(uses))
    for node in flat.chart.states if watched else ():
        for argument in node.arguments:
            for value in values_of(TransitionExpression(condition=argument.value)):
                if isinstance(value, VariableValue):
                    use = _Use(value.name, flat.region_number[node.label])
                    found.setdefault(None, {}).setdefault(use)
    return {event: tuple(uses) for event, uses in found.items()}


def _looks_later(flat: FlatChart, region: int, writer: int) -> bool:
    """Whether a region is looked at after another in a round in which both may move."""
    one, other = flat.regions[region].label, flat.regions[writer].label
    if one.startswith(f"{other}.") or other.startswith(f"{one}."):
        return False
    return region > writer


__all__ = ["copies_of"]
