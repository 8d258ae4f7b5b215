"""Standing: where an agent is at the end of a story, and what it waits for there."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.play.evaluate import Known
from aseme_dsl.play.sight.guards import Guards
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.play.sight.words import Said, cut, few, leaf_names
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.team.ending import Awaited, Waiting, trigger_of
from aseme_dsl.runtime.time.clock import readable, shown
from aseme_dsl.source import without_column

_MOST = 6
"""So many things that a state waits for are named."""


def standing(
    agent: str,
    moment: int,
    plan: Plan,
    waits: Iterable[Waiting],
    leaves: Sequence[str],
    about: Collection[str],
    guards: Guards,
    known: Known,
    came: Mapping[str, Said],
) -> Iterator[Happened]:
    """Where an agent is: in detail what is not beside all of the states that are spoken of (`about`).

    `came` is the last agent message of each kind that was sent to it.
    """
    groups: dict[tuple[object, ...], list[Waiting]] = {}
    beside: list[str] = []
    for item in waits:
        if about and all(plan.are_concurrent(item.state, label) for label in about):
            beside.append(item.name if item.where != "before" else f"start of {item.name}")
        else:
            groups.setdefault((item.where, item.name, item.at, item.awaits), []).append(item)
    for items in groups.values():
        first = Happened(moment, agent, "", stands=True, label=items[0].state)
        yield _waiting(first, plan, items, guards, known, came)
    if beside:
        names = few(list(dict.fromkeys(beside)))
        yield Happened(moment, agent, f"is also in {names}", stands=True)
    if not groups and not beside:
        ends = [plan.by_label[label] for label in leaves if plan.by_label[label].type == "END"]
        inside = leaf_names(plan, leaves) if leaves else []
        text = f"is in {few(inside)}" if inside else "is in no state"
        if ends and len(ends) == len(leaves):
            text = f"has come to the {plan.called(ends[0])}, and does nothing more"
        yield Happened(moment, agent, text, stands=True)


def _waiting(
    item: Happened,
    plan: Plan,
    waits: Sequence[Waiting],
    guards: Guards,
    known: Known,
    came: Mapping[str, Said],
) -> Happened:
    """Equal waits, which several regions may have, as one."""
    first = waits[0]
    is_running = first.where == "in" and any(found.kind == "activity" for found in first.awaits)
    awaits = [
        found
        for found in first.awaits
        if not (is_running and (found.kind == "activity" or found.what == "else"))
    ]
    since = few(list(dict.fromkeys(readable(one.since) for one in sorted(waits, key=lambda one: one.since))))
    place = f" ({without_column(first.at)})" if first.at else ""
    name = f"{cut(first.name, 60)}{place}"
    is_activity = plan.by_label[first.state].type == "BASIC"
    match first.where:
        case "in" if is_running:
            may_fail = any(found.what.endswith("error") for found in awaits)
            text = f"is in {name} since {since}: its activity has not returned"
            text += _deadline(plan, first.state, min(one.since for one in waits), guards) if may_fail else ""
        case "before":
            text = f"has not begun {name} since {since}"
        case "after" if is_activity:
            text = f"is in {name}, whose activity returned at {since}"
        case "after":
            text = f"has completed {name} at {since}"
        case _:
            text = f"is in {name} since {since}"
    if len(waits) > 1:
        text += f", in {len(waits)} instances"
    if is_running:
        text += ", and until then it may be left by" if awaits else ""
    elif not awaits:
        text += "; no transition leads on"
    else:
        text += ": it waits for"
    found = [_awaited(plan, one, guards, known, came) for one in awaits[:_MOST]]
    if len(found) == 1:
        details = list(found[0][1])
        text += f" {found[0][0]}"
    else:
        details = [line for what, read in found for line in (f"- {what}", *(f"    {one}" for one in read))]
        text += " the first of these:" if found else ""
    if len(awaits) > _MOST:
        details.append(f"- {len(awaits) - _MOST} others")
    return replace(item, text=text, details=tuple(details))


def _deadline(plan: Plan, label: str, since: int, guards: Guards) -> str:
    """The deadline of the activity of a state, which fails it; the state was entered at `since`."""
    activity = plan.by_label[label].activity
    within = next((info.within for info in plan.activities if info.name == activity), None)
    if within is None:
        return ", and has no deadline"
    declared = guards.declared.get(activity or "")
    at = f", {declared}" if declared else ""
    return f" (it may take {shown(within)}{at}, and fails at {readable(since + within)})"


def _awaited(
    plan: Plan, item: Awaited, guards: Guards, known: Known, came: Mapping[str, Said]
) -> tuple[str, tuple[str, ...]]:
    """What is awaited, and what its condition reads."""
    is_interrupt = item.what.startswith("[> ")
    what = cut(item.what.removeprefix("[> "))
    is_reactive = what.startswith("reactive ")
    if is_reactive:
        what = "another branch of the reactive choice"
    what += f" ({without_column(item.at)})" if item.at else ""
    what += ", an interrupt" if is_interrupt else ""
    waiting = (
        place
        for place, one in enumerate(plan.transitions)
        if one.at == item.at and trigger_of(one.text) == item.what
    )
    number = next(waiting, None)
    if number is None or not item.at or plan.transitions[number].otherwise or is_reactive:
        return what, ()
    refused = guards.refused(plan, number, known, came)
    return what, (*refused, *guards.explained(plan, number, known), *guards.missing(plan, number, known))


__all__ = ["standing"]
