"""PlantUML: a state diagram."""

from __future__ import annotations

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.interop.export.sketch import Sketch, shown


def plantuml(chart: Statechart, about: str) -> str:
    """The diagram of a chart; `about` says from what it comes."""
    sketch = _PlantUml(chart)
    comment = "".join(c if c.isalnum() or c in " ._-:" else "_" for c in about)
    lines = ["@startuml", f"' {comment}", *sketch.state(chart.root, ""), "@enduml"]
    return "\n".join([*lines, ""])


class _PlantUml(Sketch):
    def quoted(self, text: str) -> str:
        return shown(text, " .,()=+!?:;[]|", "<U+{:04X}>")

    def note(self, state: str, text: str) -> str:
        return f"{state} : {text}"


__all__ = ["plantuml"]
