"""Names in an export: ids of states and names of data, safe in every format, and without two alike."""

from __future__ import annotations

import re
from dataclasses import field

from aseme_dsl.amola.statechart import State, Statechart
from aseme_dsl.records import dataclass

_UNSAFE = re.compile(r"[^A-Za-z0-9]+")


def safe(text: str, longest: int = 30) -> str:
    """The letters and digits of a text, with `_` between them."""
    return _UNSAFE.sub("_", text).strip("_")[:longest].strip("_")


@dataclass
class Names:
    """The names of one chart. Each begins with a word of ours, so that none is a word of a target."""

    chart: Statechart
    _known: dict[str, str] = field(default_factory=dict)
    _taken: set[str] = field(default_factory=set)

    def id_of(self, state: State) -> str:
        """`KickBall_0_2_3`: what a state is called, and its label."""
        place = state.label.replace(".", "_")
        called = "" if state.name in ("", state.label) else safe(state.name)
        called = called or state.type.value.lower()
        base = f"s_{place}" if called[:1].isdigit() else f"{called}_{place}"
        return self._unique(base, f"state:{state.label}")

    def flag(self, kind: str, state: State) -> str:
        """The datum that says something of a state: `done`, `outcome`."""
        return f"{kind}_{self.id_of(state)}"

    def after(self, state: State, duration: int) -> str:
        """Whether so many ns have passed since a state was entered."""
        return f"after_{duration}_{self.id_of(state)}"

    def event(self, region: str, name: str) -> str:
        """Whether an event is there in a region."""
        return self._unique(f"event_{safe(name)}_{region.replace('.', '_')}", f"event:{name}:{region}")

    def timer(self, region: str, name: str) -> str:
        """Whether a timer of a region has run out."""
        return self._unique(f"timer_{safe(name)}_{region.replace('.', '_')}", f"timer:{name}:{region}")

    def variable(self, name: str) -> str:
        return self._unique(f"var_{safe(name)}", f"variable:{name}")

    def input(self, key: str) -> str:
        return self._unique(f"in_{safe(key)}", f"input:{key}")

    def _unique(self, base: str, key: str) -> str:
        """The same name for the same key, and another for another one."""
        known = self._known.get(key)
        if known is not None:
            return known
        name, number = base, 1
        while name in self._taken:
            number += 1
            name = f"{base}_{number}"
        self._taken.add(name)
        self._known[key] = name
        return name
