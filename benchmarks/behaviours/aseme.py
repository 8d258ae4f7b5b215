"""The `.aseme` text of a behaviour."""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.behaviours.description import Action, Behaviour, Guard, State


def text_of(behaviour: Behaviour) -> str:
    """The behaviour as a statechart state by state.

    What a state does on entry is done here by every transition that leads to it. Flags and counters are
    variables of the role. What waits for the end of an activity waits for no event here, and one whose
    activity has ended is no state of its own.

    Raises:
        ValueError: a state does something on exit, which this form of a statechart cannot say.
    """
    label = labels(behaviour)
    states = behaviour.states
    if any(state.exit for state in states):
        raise ValueError(f"{behaviour.name} does something on exit")
    by_name = {state.name: state for state in states}
    ends, ended = dict(behaviour.ends), dict(behaviour.ended)
    lines = [f"system {camel(behaviour.name)}", ""]
    for message, member in behaviour.messages:
        lines += [f"message {camel(message)} {{ bool {member} }}"]
    if behaviour.messages:
        topic = " ".join(f"state {camel(message)}" for message, _ in behaviour.messages)
        lines += [f"topic {TOPIC} {{ {topic} }}", ""]
    lines.append(f"statechart {behaviour.name} {{")
    lines += [f"  var {flag} : bool = false" for flag in behaviour.flags]
    lines += [f"  var {counter} : int = 0" for counter in behaviour.counters]
    lines.append("")
    for state in states:
        if state.name in ended:
            continue
        lines.append(f"  state {label[state.name]} {state.kind.upper()} {state.name}")
        if state.kind == "or":
            lines.append(f"  state {label[state.name]}.1 START")
    lines.append("")
    for state in states:
        if state.kind == "or":
            initial = state.children[0]
            lines.append(_way(f"{label[state.name]}.1", label[initial.name], "", (), _entry(initial)))
        for way in state.transitions:
            if ended.get(way.target) == state.name:
                continue
            target = by_name[way.target]
            event = "" if way.event in ends else way.event
            lines.append(_way(label[state.name], label[target.name], event, way.guard, _entry(target)))
    lines += ["}", ""]
    return "\n".join(lines)


def _entry(state: State) -> tuple[Action, ...]:
    """What a transition to `state` does; the regions of a parallel state do nothing on entry themselves."""
    if any(region.entry for region in state.children if state.kind == "and"):
        raise ValueError(f"a region of {state.name} does something on entry")
    return state.entry


def _way(source: str, target: str, event: str, guard: Guard, actions: tuple[Action, ...]) -> str:
    condition = " && ".join(part if wanted else f"!{part}" for part, wanted in map(_asked, guard))
    parts = [event, f"[{condition}]" if condition else "", _actions(actions)]
    return " ".join([f"  {source} -> {target} :", *(part for part in parts if part)])


def _asked(part: tuple[str, bool | str]) -> tuple[str, bool | str]:
    """A part of a guard, with the message where it is."""
    message, dot, member = part[0].partition(".")
    return (f"{channel(message)}.{member}" if dot else message), part[1]


TOPIC = "seen"


def channel(message: str) -> str:
    """The channel of a message."""
    return f"{TOPIC}.state.{camel(message)}"


def _actions(actions: tuple[Action, ...]) -> str:
    """Actions as the language writes them."""
    written = []
    for action in actions:
        match action:
            case ("count", counter):
                written.append(f"{counter} = {counter} + 1")
            case ("set", flag, value):
                written.append(f"{flag} = {'true' if value else 'false'}")
    return f"/ {'; '.join(written)}" if written else ""


def labels(behaviour: Behaviour) -> dict[str, str]:
    """The label of each state, by its name: child 1 of an `or` is its START.

    One whose activity has ended has the label that it had before.
    """
    found = {}
    ended = dict(behaviour.ended)

    def number(state: State, label: str) -> None:
        found[state.name] = label
        children = [child for child in state.children if child.name not in ended]
        for place, child in enumerate(children, start=2 if state.kind == "or" else 1):
            number(child, f"{label}.{place}")

    number(behaviour.root, "0")
    return found | {name: found[other] for name, other in behaviour.ended}


def names(behaviour: Behaviour) -> dict[str, str]:
    """The name of each state, by its label."""
    ended = dict(behaviour.ended)
    return {label: name for name, label in labels(behaviour).items() if name not in ended}


def camel(name: str) -> str:
    """A name of a system: `two_states` gives `TwoStates`."""
    return "".join(word.capitalize() for word in name.split("_"))


def leaves(behaviour: Behaviour) -> Iterator[str]:
    """The basic states, in document order."""
    return (state.name for state in behaviour.states if state.kind == "basic")
