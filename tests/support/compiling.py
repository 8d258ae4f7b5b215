"""Compiling a text for a test: its diagnostics as they are printed, its system, one of its charts."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import Analysis, Options, analyse
from aseme_dsl.diagnostics import Severity, render_text
from aseme_dsl.source import Source


def analysis(text: str, *, largest: int | None = None, sources: Mapping[str, str] | None = None) -> Analysis:
    """What the compiler knows of a text that stands in `test.aseme`."""
    options = Options(largest) if largest is not None else None
    return analyse(Source("test.aseme", text), sources, options)


def printed(text: str, *, largest: int | None = None) -> str:
    """The diagnostics of a text as a user sees them."""
    return render_text(analysis(text, largest=largest).diagnostics)


def codes(text: str, *, largest: int | None = None, notes: bool = False) -> list[str]:
    """The codes of the diagnostics in order; notes only on request."""
    found = analysis(text, largest=largest).diagnostics
    return [item.code for item in found if notes or item.severity is not Severity.NOTE]


def system(text: str, *, largest: int | None = None) -> System:
    """The system of a text without errors."""
    found = analysis(text, largest=largest)
    assert found.system is not None, render_text(found.diagnostics)
    return found.system


def role_chart(liveness: str, rest: str = "", *, largest: int | None = None) -> Statechart:
    """The chart of a role: its formulas, and whatever else its `srm` says. The first formula names it."""
    name = liveness.split("=")[0].strip()
    text = f"system Test\nsrm {name} {{\nliveness {{\n{liveness}\n}}\n{rest}\n}}\n"
    return system(text, largest=largest).iacs[0]
