"""Mermaid: a state diagram, as Markdown pages show it."""

from __future__ import annotations

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.interop.export.sketch import Sketch, shown


def mermaid(chart: Statechart, about: str) -> str:
    """The diagram of a chart; `about` says from what it comes."""
    sketch = _Mermaid(chart)
    comment = "".join(c if c.isalnum() or c in " ._-:" else "_" for c in about)
    lines = ["stateDiagram-v2", f"  %% {comment}", *sketch.state(chart.root, "  ")]
    return "\n".join([*lines, ""])


class _Mermaid(Sketch):
    def quoted(self, text: str) -> str:
        return shown(text, " _.,()=+*/!?|", "#{};")

    def note(self, state: str, text: str) -> str:
        return f"note right of {state} : {text}"


__all__ = ["mermaid"]
