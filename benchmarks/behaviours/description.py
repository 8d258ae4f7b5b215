"""What a behaviour is here: a statechart as data, a blackboard of flags, and the inputs that it is given.

The data says nothing that SCXML and the language of this project read differently (semantics: an event is
spent per region here, per event there). What enters or leaves parallel regions has an event of its own,
and one that no transition inside these regions waits for: so one event moves every region at most once.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, Literal

Kind = Literal["basic", "or", "and"]

Action = tuple[str, ...] | tuple[str, str, bool]
"""`("count", counter)` adds 1 to a counter, `("set", flag, value)` sets a flag, `("python", text)` is code
over the dictionary `bb`."""

Guard = tuple[tuple[str, bool | str], ...]
"""The flags that must have these values; with the name "", a condition in Python over the dictionary `bb`."""

Change = tuple[tuple[str, bool | str], ...]
"""The flags that the program around the statechart sets before an event; a value may be one in Python."""


@dataclass(frozen=True, slots=True)
class Transition:
    """From the state that has it to `target`; of one state the first that is enabled is taken.

    Without an event it is taken as soon as its guard holds.
    """

    event: str
    target: str
    guard: Guard = ()
    actions: tuple[Action, ...] = ()


@dataclass(frozen=True, slots=True)
class State:
    """A state; the first child of an `or` is its initial one, the children of an `and` are all active."""

    name: str
    kind: Kind = "basic"
    children: tuple[State, ...] = ()
    entry: tuple[Action, ...] = ()
    exit: tuple[Action, ...] = ()
    transitions: tuple[Transition, ...] = ()


@dataclass(frozen=True, slots=True)
class Behaviour:
    """A statechart, its flags (all false at first) and the steps that it is driven with, again and again."""

    name: str
    title: str
    root: State
    flags: tuple[str, ...]
    steps: tuple[tuple[str, Change], ...]
    values: tuple[tuple[str, str], ...] = ()
    """What else is on the blackboard at first, in Python."""
    functions: tuple[tuple[str, str], ...] = ()
    """What conditions call, by the name that it has there: `module:function`."""
    path: tuple[str, ...] = ()
    """The folders in which these modules are found."""

    @property
    def counters(self) -> tuple[str, ...]:
        """The counters in document order."""
        actions = (action for state in walk(self.root) for action in (*state.entry, *state.exit))
        return tuple(dict.fromkeys(str(action[1]) for action in actions if action[0] == "count"))

    @property
    def states(self) -> tuple[State, ...]:
        """All states, in document order."""
        return tuple(walk(self.root))


def walk(state: State) -> Iterator[State]:
    """A state and all below it, in document order."""
    yield state
    for child in state.children:
        yield from walk(child)


def basic(name: str, *transitions: Transition, entry: tuple[Action, ...] = ()) -> State:
    """A state without states in it."""
    return State(name, entry=entry, transitions=transitions)


def one_of(name: str, *children: State, on: tuple[Transition, ...] = (), **further: Any) -> State:
    """A state of whose children one is active."""
    return State(name, "or", children, transitions=on, **further)


def all_of(name: str, *children: State, on: tuple[Transition, ...] = (), **further: Any) -> State:
    """A state whose children, the regions, are all active."""
    return State(name, "and", children, transitions=on, **further)


def entered(name: str) -> str:
    """The counter of the entries of a state."""
    return f"entered_{name}"


def left(name: str) -> str:
    """The counter of the exits of a state."""
    return f"left_{name}"


def counting(state: State) -> State:
    """The same tree in which each basic state counts its entries, before anything else that it does."""
    children = tuple(counting(child) for child in state.children)
    entry = (("count", entered(state.name)), *state.entry) if state.kind == "basic" else state.entry
    return replace(state, children=children, entry=entry)


def instrumented(behaviour: Behaviour) -> Behaviour:
    """The same behaviour in which each state below the root counts its entries and its exits."""

    def count(state: State) -> State:
        others = tuple(action for action in state.entry if action[0] != "count")
        return replace(
            state,
            children=tuple(count(child) for child in state.children),
            entry=(("count", entered(state.name)), *others),
            exit=(("count", left(state.name)), *state.exit),
        )

    root = replace(behaviour.root, children=tuple(count(child) for child in behaviour.root.children))
    return replace(behaviour, root=root)


def as_json(behaviour: Behaviour) -> dict[str, Any]:
    """The behaviour for programs in other languages."""

    def state(item: State) -> dict[str, Any]:
        return {
            "name": item.name,
            "kind": item.kind,
            "children": [state(child) for child in item.children],
            "entry": [list(action) for action in item.entry],
            "exit": [list(action) for action in item.exit],
            "transitions": [
                {
                    "event": way.event,
                    "target": way.target,
                    "guard": [list(part) for part in way.guard],
                    "actions": [list(action) for action in way.actions],
                }
                for way in item.transitions
            ],
        }

    return {
        "name": behaviour.name,
        "root": state(behaviour.root),
        "flags": list(behaviour.flags),
        "counters": list(behaviour.counters),
        "steps": [[event, [list(part) for part in change]] for event, change in behaviour.steps],
        "values": [list(item) for item in behaviour.values],
        "functions": [list(item) for item in behaviour.functions],
        "path": list(behaviour.path),
    }


def from_json(data: dict[str, Any]) -> Behaviour:
    """The behaviour that `as_json` wrote."""

    def state(item: dict[str, Any]) -> State:
        return State(
            item["name"],
            item["kind"],
            tuple(state(child) for child in item["children"]),
            tuple(tuple(action) for action in item["entry"]),
            tuple(tuple(action) for action in item["exit"]),
            tuple(
                Transition(
                    way["event"],
                    way["target"],
                    tuple((flag, value) for flag, value in way["guard"]),
                    tuple(tuple(action) for action in way["actions"]),
                )
                for way in item["transitions"]
            ),
        )

    steps = tuple((event, tuple((flag, value) for flag, value in change)) for event, change in data["steps"])
    values = tuple((name, value) for name, value in data["values"])
    functions = tuple((name, target) for name, target in data["functions"])
    path = tuple(data["path"])
    root = state(data["root"])
    return Behaviour(data["name"], "", root, tuple(data["flags"]), steps, values, functions, path)
