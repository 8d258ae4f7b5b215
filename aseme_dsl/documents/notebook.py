"""Notebook: what Jupyter shows of models, drawings and the results of runs."""

from __future__ import annotations

import base64
from collections.abc import Iterable
from html import escape

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.suc import Suc
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import Analysis
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagrams import Drawing, draw, draw_model, drawings, render
from aseme_dsl.diagrams.look.words import words
from aseme_dsl.diagrams.rendering.drawn import WHOLE
from aseme_dsl.display import Displays
from aseme_dsl.documents import html
from aseme_dsl.project.playing.run_end import end_lines
from aseme_dsl.runtime.team.team import AgentResult, RunResult


def _as_svg(value: object) -> str | None:
    drawing = _drawing_of(value)
    if drawing is None or _in_pieces(drawing):
        return None
    return render(drawing, "svg").decode("utf-8")


def _as_html(value: object) -> str | None:
    if isinstance(value, System):
        return "".join(_figure(item, words(value, item)) for item in drawings(value))
    if isinstance(value, RunResult):
        return _result(value)
    if isinstance(value, Analysis):
        return _analysis(value)
    drawing = _drawing_of(value)
    return _figure(drawing, drawing.name) if drawing is not None and _in_pieces(drawing) else None


def _as_text(value: object) -> str:
    if isinstance(value, RunResult):
        return "\n".join((_head(value), *_rest(value)))
    if isinstance(value, Analysis):
        return "\n".join((_found(value), *map(_line, value.diagnostics)))
    return " ".join((type(value).__name__, *([value.name] if isinstance(value, _NAMED) else [])))


_NAMED = (System, Aip, Srm, Statechart, Drawing)
DISPLAYS = Displays(_as_svg, _as_html, _as_text)


def _drawing_of(value: object) -> Drawing | None:
    """The one drawing of a value, if it has just one; of an empty model there is none."""
    if isinstance(value, Drawing):
        return value
    if (isinstance(value, Sag) and not value.actors) or (isinstance(value, Suc) and not value.roles):
        return None
    return draw_model(value) if isinstance(value, (Sag, Suc, Aip, Srm, Statechart)) else None


def _in_pieces(drawing: Drawing) -> bool:
    """Whether it is too large for one picture."""
    return drawing.states > WHOLE and drawing.pieces is not None


def _figure(drawing: Drawing, alt: str) -> str:
    """The drawing, in several pictures if it must be divided, with its name under it."""
    drawn = draw(drawing, "svg")
    return html.figure(
        "".join(_image(svg, alt) for _, svg in drawn.files), "; ".join((drawing.name, *drawn.notes))
    )


def _image(svg: bytes, alt: str) -> str:
    """An element of its own document: the pictures of a page do not share identifiers or styles."""
    return html.image("data:image/svg+xml;base64," + base64.b64encode(svg).decode("ascii"), alt)


def _result(result: RunResult) -> str:
    """How each agent ended, and what the run left open."""
    rows = [_row("th", ("agent", "role", "at the end"))]
    rows += [_row("td", (item.name, item.role, _end_of(item))) for item in result.agents]
    rest = "\n".join(_rest(result))
    return f"<p>{escape(_head(result))}</p><table>{''.join(rows)}</table>{html.problem(rest) if rest else ''}"


def _analysis(analysis: Analysis) -> str:
    """What was found, a line each."""
    rows = [_row("th", ("place", "severity", "code", "message", "hint"))]
    rows += [_row("td", _told(item)) for item in analysis.diagnostics]
    table = f"<table>{''.join(rows)}</table>" if analysis.diagnostics else ""
    return f"<p>{escape(_found(analysis))}</p>{table}"


def _found(analysis: Analysis) -> str:
    name = analysis.system.name if analysis.system is not None else "no system"
    number = len(analysis.diagnostics)
    return f"{name}: {number or 'no'} problem{'' if number == 1 else 's'}"


def _line(item: Diagnostic) -> str:
    place, severity, code, message, _ = _told(item)
    return f"{place}: {severity}[{code}]: {message}"


def _told(item: Diagnostic) -> tuple[str, ...]:
    place = (
        item.path or ""
        if item.span is None
        else f"{item.span.source.path}:{item.span.line}:{item.span.column}"
    )
    return place, item.severity, item.code, item.message, item.hint or ""


def _head(result: RunResult) -> str:
    return f"{result.reason} after {result.end_ns / 1e9:g} s"


def _rest(result: RunResult) -> list[str]:
    """What the run left open."""
    return [*end_lines(result), *([result.trace_error] if result.trace_error is not None else ())]


def _row(tag: str, texts: Iterable[str]) -> str:
    return "<tr>" + "".join(f"<{tag}>{escape(text)}</{tag}>" for text in texts) + "</tr>"


def _end_of(agent: AgentResult) -> str:
    if agent.failure is not None:
        return f"failed: {agent.failure}" + (f" ({agent.at})" if agent.at else "")
    if agent.finished:
        return "completed"
    return "; ".join(f"{item.where} {item.name}" for item in agent.waits) or "active"
