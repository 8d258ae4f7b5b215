"""The coverage of a system as a page: one HTML file with its drawings, light and dark, without scripts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from html import escape
from pathlib import Path
from xml.etree import ElementTree

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.diagrams.compact import drawings
from aseme_dsl.diagrams.look.drawing import Options
from aseme_dsl.diagrams.rendering.inset import region
from aseme_dsl.play.coverage.measure import Coverage, Item, Kind, Status
from aseme_dsl.project.testing.coverage_report import counted, origin, percent_text

SVG = "http://www.w3.org/2000/svg"
_STYLE = Path(__file__).with_name("coverage.css")

_LEGEND = (
    ("covered", "reached"),
    ("partly", "reached, but conditions are not covered"),
    ("missed", "not reached"),
    ("never", "can never be reached"),
)


def page(system: System, coverage: Coverage) -> str:
    """The page of a coverage: shares, what is missing, and the statechart of each role in colours."""
    title = f"Coverage of {coverage.system}"
    notes = "".join(f"<p>{escape(note)}</p>" for note in coverage.notes)
    style = _STYLE.read_text("utf-8")
    parts = [
        "<!DOCTYPE html>",
        f'<html lang="en"><head><meta charset="utf-8"><title>{escape(title)} - asemec coverage</title>',
        f'<meta name="viewport" content="width=device-width"><style>{style}</style></head><body>',
        f"<h1>{escape(title)}</h1><p>{escape(origin(coverage))}</p>{notes}",
        *_shares(coverage),
        *(part for chart in system.iacs for part in _role(system, chart, coverage)),
        *_missing(coverage),
        "</body></html>",
    ]
    return "\n".join([*parts, ""])


def _shares(coverage: Coverage) -> Iterator[str]:
    heads = "".join(f'<th class="number">{text}</th>' for text in ("covered", "of", "", "", ""))
    yield f"<table><tr><th></th>{heads}</tr>"
    for kind in Kind:
        share = coverage.share(kind)
        if not share.total and not share.never:
            continue
        percent = percent_text(share)
        bar = f'<span class="bar"><i style="width:{share.percent or 0:.1f}%"></i></span>'
        beside = ", ".join(
            f"{number} {words}"
            for number, words in ((share.never, "can never be reached"), (share.unmeasured, "not measured"))
            if number
        )
        yield (
            f'<tr><td>{kind}</td><td class="number">{share.covered}</td><td class="number">{share.total}</td>'
            f'<td class="number">{percent}</td><td>{bar if share.percent is not None else ""}</td>'
            f"<td>{beside}</td></tr>"
        )
    yield "</table>"


# ---- drawings ---------------------------------------------------------------------------------------


def _role(system: System, chart: Statechart, coverage: Coverage) -> Iterator[str]:
    mine = [item for item in coverage.items if item.of == chart.name]
    shares = ", ".join(
        f"{sum(item.status is Status.COVERED for item in found)} of {len(found)} {kind}"
        for kind in (Kind.STATES, Kind.TRANSITIONS)
        if (found := [item for item in mine if item.kind is kind and item.status is not Status.NEVER])
    )
    yield f"<h2>{escape(chart.name)}</h2><p>{shares}</p>"
    drawn = drawings(chart, Options(), system.activities, nested=partial(region, chart))
    if isinstance(drawn, str):
        yield f"<p>There is no drawing: {escape(drawn)}.</p>"
        return
    names = "".join(f'<span><i class="{name}"></i>{words}</span>' for name, words in _LEGEND)
    yield f'<p class="legend">{names}</p>'
    for drawing in drawn:
        assert drawing.picture is not None
        yield f'<div class="drawing">{_coloured(drawing.picture, chart.name, mine)}</div>'


def _coloured(picture: str, name: str, items: Iterable[Item]) -> str:
    """The drawing with a class at each element for how it was covered, and a tip with how often.

    Its ids get the name as a prefix, since a page has several drawings.
    """
    states: dict[str, Item] = {}
    transitions: dict[int, Item] = {}
    parts: dict[int, list[Item]] = {}
    for item in items:
        if item.kind is Kind.STATES:
            states[item.label] = item
        elif item.kind is Kind.TRANSITIONS and item.number is not None:
            transitions[item.number] = item
        elif item.kind is Kind.CONDITIONS and item.number is not None:
            parts.setdefault(item.number, []).append(item)
    ElementTree.register_namespace("", SVG)
    root = ElementTree.fromstring(picture)
    for element in root.iter(f"{{{SVG}}}g"):
        if (own := element.get("id")) is not None:
            element.set("id", f"{name}-{own}")
        kind = element.get("class")
        if kind == "state":
            found = [states[label] for label in (element.get("data-n") or "").split() if label in states]
        elif kind == "line":
            numbers = [int(number) for number in (element.get("data-t") or "").split()]
            found = [transitions[number] for number in numbers if number in transitions]
        else:
            continue
        if not found:
            continue
        element.set("class", f"{kind} {_class(found, parts)}")
        _add_tip(element, found, parts)
    return ElementTree.tostring(root, encoding="unicode")


def _class(found: Sequence[Item], parts: Mapping[int, Sequence[Item]]) -> str:
    """How elements that are drawn as one are covered: the worst of them counts, but for what cannot be."""
    statuses = {item.status for item in found}
    conditions = [part for item in found if item.number is not None for part in parts.get(item.number, ())]
    if Status.MISSED in statuses:
        return "partly" if Status.COVERED in statuses else "missed"
    if Status.COVERED not in statuses:
        return "never"
    is_lacking = found[0].kind is Kind.TRANSITIONS and any(
        part.status is Status.MISSED for part in conditions
    )
    return "partly" if is_lacking else "covered"


def _add_tip(
    element: ElementTree.Element, found: Sequence[Item], parts: Mapping[int, Sequence[Item]]
) -> None:
    title = element.find(f"{{{SVG}}}title")
    if title is None:
        title = ElementTree.Element(f"{{{SVG}}}title")
        element.insert(0, title)
    lines = [title.text or ""]
    for item in found:
        word = "entered" if item.kind is Kind.STATES else "taken"
        times = f"{word} {item.times} times" if item.times != 1 else f"{word} once"
        lines.append(f"{item.name}: {item.reason or times}")
        lines += [f"  {part.name}: {part.reason or part.status}" for part in parts.get(item.number or -1, ())]
    title.text = "\n".join(line for line in lines if line)


# ---- tables -----------------------------------------------------------------------------------------


def _missing(coverage: Coverage) -> Iterator[str]:
    """A table for each kind: what was reached how often, what was not and why."""
    for kind in Kind:
        items = list(coverage.of(kind))
        if not items:
            continue
        missed = [item for item in items if item.status is Status.MISSED]
        others = [item for item in items if item.status is not Status.MISSED]
        yield f"<h2>{kind.capitalize()}</h2>"
        if missed:
            yield from _table(missed)
        if others:
            number = counted(len(others), kind)
            about = f"and {number} more" if missed else number
            yield f"<details><summary>{about}</summary>"
            yield from _table(others)
            yield "</details>"


def _table(items: Iterable[Item]) -> Iterator[str]:
    yield "<table>"
    for item in items:
        status = item.status
        name = "unmeasured" if status is Status.UNMEASURED else str(status)
        sign = {Status.COVERED: "✓", Status.MISSED: "✗", Status.NEVER: "–", Status.UNMEASURED: "?"}[status]
        times = f"{item.times} ×" if item.times and item.kind is not Kind.CONDITIONS else ""
        place = "" if item.span is None else escape(str(item.span))
        yield (
            f'<tr><td class="sign {name}">{sign} {status}</td><td>{escape(item.of)}</td>'
            f"<td><code>{escape(item.name)}</code></td><td>{escape(item.reason)}</td>"
            f'<td class="number">{times}</td><td><code>{place}</code></td></tr>'
        )
    yield "</table>"


__all__ = ["page"]
