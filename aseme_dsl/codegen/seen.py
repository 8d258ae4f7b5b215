"""Seen: a system as far as the code of one role depends on it, so that no other change renews this code."""

from __future__ import annotations

from dataclasses import replace

from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Srm
from aseme_dsl.amola.suc import Suc
from aseme_dsl.amola.system import System
from aseme_dsl.source import Source, Span

_NOWHERE = Span(Source("", ""), 0, 0)


def seen_by_roles(system: System) -> tuple[System, ...]:
    """For each role the system without the other roles, and without what the code of a role never asks for.

    Of activities and protocols those are left that its statechart has, of teams, topics and types all.
    """
    activities = {item.name: item for item in system.activities}
    order = {name: number for number, name in enumerate(activities)}
    aips = {item.name: item for item in system.aips}
    found: list[System] = []
    for chart in system.iacs:
        used = {node.activity for node in chart.states if node.activity is not None} & order.keys()
        played = {node.origin.owner for node in chart.states}
        found.append(
            replace(
                system,
                activities=tuple(activities[name] for name in sorted(used, key=order.__getitem__)),
                sag=Sag(),
                suc=Suc(),
                aips=tuple(aip for name, aip in aips.items() if name in played),
                srms=tuple(_answers(srm) for srm in system.srms if srm.name == chart.name),
                eacs=tuple(chart for chart in system.eacs if chart.name in played),
                iacs=(chart,),
                protos=(),
                sources=(),
                span=None,
            )
        )
    return tuple(found)


def _answers(srm: Srm) -> Srm:
    """Of a role what it answers to invitations while it is busy."""
    plays = tuple(replace(item, bindings=(), inputs=(), results=()) for item in srm.plays if item.busy)
    span = plays[0].span if plays else _NOWHERE
    return Srm(srm.name, plays, (), (), (), (), (), span)


__all__ = ["seen_by_roles"]
