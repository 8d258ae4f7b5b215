"""State names: what people call the states of a run, by the labels that its records have."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.trace.records import Record, agents_of

LONGEST = 40
"""A longer name is cut."""

_POINTS = {"START": "start of ", "END": "end of ", "CONDITION": "choice in "}


class StateTold(NamedTuple):
    """A state: its label, its name, which may be the label, and its type."""

    label: str
    name: str
    type: str


def titles(states: Iterable[StateTold]) -> dict[str, str]:
    """What people call each state: by what it is in the state around it where its name is only its label.

    The states around one come before it.
    """
    named: dict[str, str] = {}
    found: dict[str, str] = {}
    for state in states:
        if state.name not in ("", state.label):
            named[state.label] = found[state.label] = state.name
            continue
        around = state.label
        while around and around not in named:
            around = around.rpartition(".")[0]
        name = named.get(around)
        found[state.label] = state.label if name is None else _POINTS.get(state.type, "in ") + name
    return found


def titles_of(plan: Plan) -> dict[str, str]:
    """What people call the states of a plan."""
    return titles(StateTold(state.label, state.name, state.type) for state in plan.states)


def apart(names: Mapping[str, str]) -> dict[str, str]:
    """The names, cut where they are long, with the label behind those that several states have."""
    short = {
        label: name if len(name) <= LONGEST else f"{name[: LONGEST - 1]}…" for label, name in names.items()
    }
    counts = Counter(short.values())
    return {
        label: name if counts[name] == 1 or name == label else f"{name} ({label})"
        for label, name in short.items()
    }


class StateNames:
    """The names of the states of each agent, as the records of a run say."""

    def __init__(self) -> None:
        self._of: dict[str, Mapping[str, str]] = {}

    def take(self, record: Record) -> None:
        """Take what a record says of names: the header, or a change of an agent to another plan."""
        if record["kind"] == "header":
            roles = {role: apart(names) for role, names in record.get("names", {}).items()}
            for agent in agents_of(record):
                self._of[agent["name"]] = roles.get(agent.get("role", ""), {})
        elif record["kind"] in ("swap", "select") and "agent" in record:
            changed = record.get("plan") if record["kind"] == "swap" else record.get("states")
            if isinstance(changed, dict):
                states = (StateTold(item["label"], item["name"], item["type"]) for item in changed["states"])
                self._of[record["agent"]] = apart(titles(states))

    def name(self, agent: str, label: str) -> str:
        """What people call a state of an agent; its label where no name is known."""
        return self._of.get(agent, {}).get(label, label)


__all__ = ["StateNames", "StateTold", "apart", "titles", "titles_of"]
