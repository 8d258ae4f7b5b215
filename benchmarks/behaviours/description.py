"""What a behaviour is here: a statechart as data, a blackboard of flags, and the inputs that it is given.

The data says nothing that SCXML and the language of this project read differently (semantics: an event is
spent per region here, per event there). What enters or leaves parallel regions has an event of its own,
and one that no transition inside these regions waits for: so one event moves every region at most once.

What this project has and others do not is told them as their users write it. The end of an activity is an
event that is named after it. A state whose activity has ended, and which waits for a condition, is a state of
its own (`Behaviour.ended`). A message is a value of the blackboard, which is nothing (`None`) at first.
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
"""The flags that must have these values; with the name "", a condition in Python over the dictionary `bb`.

`ball.near` is the member `near` of the message `ball`: that does not hold while there is no such message.
"""

Change = tuple[tuple[str, bool | str], ...]
"""The flags that the program around the statechart sets before an event; a value may be one in Python.

With `ball.near`, it has got a message `ball`, whose `near` has this value.
"""


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
    messages: tuple[tuple[str, str], ...] = ()
    """The messages that conditions read: the name of each and of its only member, a truth."""
    ends: tuple[tuple[str, str], ...] = ()
    """Events that are ends of activities, with the state of each; if there are any, all events are such."""
    ended: tuple[tuple[str, str], ...] = ()
    """States that stand for others whose activity has ended: their names, and the others'."""

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


def counting(state: State, but: tuple[str, ...] = ()) -> State:
    """The same tree in which each basic state, but for some, counts its entries before all else it does."""
    children = tuple(counting(child, but) for child in state.children)
    is_counted = state.kind == "basic" and state.name not in but
    entry = (("count", entered(state.name)), *state.entry) if is_counted else state.entry
    return replace(state, children=children, entry=entry)


def instrumented(behaviour: Behaviour) -> Behaviour:
    """The same behaviour in which each state below the root counts its entries and its exits.

    One that has ended, and waits, is entered before, and left afterwards.
    """
    ended = dict(behaviour.ended)

    def count(state: State) -> State:
        others = tuple(action for action in state.entry if action[0] != "count")
        is_entered, is_left = state.name not in ended, state.name not in ended.values()
        return replace(
            state,
            children=tuple(count(child) for child in state.children),
            entry=(("count", entered(state.name)), *others) if is_entered else others,
            exit=(("count", left(ended.get(state.name, state.name))), *state.exit) if is_left else state.exit,
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
        "messages": [list(item) for item in behaviour.messages],
        "ends": [list(item) for item in behaviour.ends],
        "ended": [list(item) for item in behaviour.ended],
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

    def pairs(key: str) -> tuple[tuple[str, str], ...]:
        return tuple((one, other) for one, other in data[key])

    return Behaviour(
        data["name"],
        "",
        state(data["root"]),
        tuple(data["flags"]),
        tuple((event, tuple((flag, value) for flag, value in change)) for event, change in data["steps"]),
        values=pairs("values"),
        functions=pairs("functions"),
        path=tuple(data["path"]),
        messages=pairs("messages"),
        ends=pairs("ends"),
        ended=pairs("ended"),
    )
