"""What goes out as SCXML and comes home does the same: export and import of random statecharts."""

from __future__ import annotations

import os
from collections.abc import Callable

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from aseme_dsl.interop.export.lowering import lowered
from aseme_dsl.interop.export.names import Names
from aseme_dsl.interop.export.scxml import scxml
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Happened
from tests.interop.machines.playing import Player, imported
from tests.support.generated import generate

EXAMPLES = int(os.environ.get("ASEME_ROUND_TRIPS", "6"))
EVENTS = ("e", "f", "g")

Draw = Callable[[st.SearchStrategy[int]], int]


class _Text:
    """A random statechart: two levels, events with conditions, `on`, `exit`, `raise` and a variable."""

    def __init__(self, draw: Draw) -> None:
        self.draw = draw
        self.states: list[str] = ["  state 0 OR c", "  state 0.1 START"]
        self.lines: list[str] = []
        self.places: list[str] = []

    def number(self, most: int) -> int:
        return self.draw(st.integers(0, most))

    def written(self) -> str:
        count = 2 + self.number(2)
        for child in range(2, 2 + count):
            self.state(f"0.{child}", self.number(2) == 0)
        self.states.append(f"  state 0.{count + 2} END")
        self.lines.append("  0.1 -> 0.2 :")
        for _ in range(4 + self.number(6)):
            source = self.places[self.number(len(self.places) - 1)]
            targets = [*self.places, f"0.{count + 2}"] if self.number(5) == 0 else self.places
            target = targets[self.number(len(targets) - 1)]
            self.lines.append(f"  {source} -> {target} : {self.when()}{self.does()}")
        for place in self.places:
            if self.number(4) == 0:
                self.lines.append(f"  exit {place} : / n = n + 1")
            if self.number(4) == 0:
                self.lines.append(f"  on {place} : {self.when()} / n = n + 2")
        used = sorted({line.split()[3] for line in self.states if " BASIC " in line})
        waits = " ".join(f"{name} waits" for name in used)
        head = ["system S", "statechart c {", "  var n : int = 0", *self.states, *self.lines]
        return "\n".join([*head, f"  activities {{ {waits} }}", "}", "team T { me : c }", ""])

    def state(self, label: str, is_composite: bool) -> None:
        self.places.append(label)
        name = "S" + label.replace(".", "_")
        if not is_composite:
            self.states.append(f"  state {label} BASIC {name}")
            return
        self.states += [f"  state {label} OR {name}", f"  state {label}.1 START"]
        self.lines.append(f"  {label}.1 -> {label}.2 :{self.does()}")
        for child in (2, 3):
            self.state(f"{label}.{child}", False)

    def when(self) -> str:
        event = EVENTS[self.number(2)]
        return f"{event} [n < {self.number(6)}]" if self.number(2) == 0 else event

    def does(self) -> str:
        chosen = self.number(6)
        return " / raise g" if chosen == 0 else " / n = n * 2 + 1" if chosen == 1 else ""


def settled(chart: Chart, event: str | None) -> bool:
    """A step and those that follow at once; whether they come to rest."""
    inputs = [Happened(event)] if event is not None else []
    for _ in range(60):
        outcome = chart.step(0, inputs)
        if outcome.failure is not None:
            return False
        if not outcome.again:
            return True
        inputs = []
    return False


@settings(max_examples=EXAMPLES, deadline=None, suppress_health_check=list(HealthCheck))
@given(data=st.data())
def test_what_comes_home_does_the_same(data: st.DataObject) -> None:
    text = _Text(data.draw).written()
    made = generate(text)
    (chart,) = made.system.iacs
    machine, refusals = lowered(made.system, chart)
    assert refusals == ()
    names = Names(chart)
    ids = {state.label: names.id_of(state) for state in chart.states}
    home = imported("c.scxml", scxml(machine))
    ours = made.chart("c", "me")
    theirs = Player(home)
    if not settled(ours, None):
        return
    for event in data.draw(st.lists(st.sampled_from(EVENTS), min_size=4, max_size=12)):
        assert [{ids[label]} for label in ours.configuration()] == theirs.active(), text + home.text
        if not settled(ours, event) or ours.finished:
            return
        theirs.send(f"event.{event}")
    assert [{ids[label]} for label in ours.configuration()] == theirs.active(), text + home.text
