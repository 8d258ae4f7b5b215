"""Counterexample: a run that was found, written as a scenario, and played on what runs on a robot."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import assert_never, cast

from aseme_dsl.amola.messages import Type
from aseme_dsl.proofs.explore.deciding.unread import Path
from aseme_dsl.proofs.explore.retrace import (
    Acts,
    Arrives,
    Comes,
    Content,
    Crash,
    Event,
    Gives,
    Happening,
    Retraced,
)
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.time.clock import MILLISECOND, SECOND


@dataclass(frozen=True, slots=True)
class Run:
    """What a scenario has beside what happens.

    From the last move on all goes by itself for `further` ns; 0 if the run ends with it. With an `end`,
    nothing more is done until then. `expects` are statements that do not hold in the run; `{end}` in them
    stands for its end, and `{last}` for the moment of its last move.
    None are needed if a property or clause is broken, or an agent fails.
    """

    title: str
    team: Sequence[tuple[str, str]]
    further: int = 0
    expects: Sequence[str] = ()
    end: int = 0


@dataclass(frozen=True, slots=True)
class Types:
    """What values are: the types of the variables of agents, and of the members of messages."""

    variables: Mapping[str, Mapping[str, str]]
    members: Mapping[str, Mapping[str, Type]]

    def of_member(self, message: str, path: Path) -> str:
        """The type of a member of a message, by the way to it."""
        found: Type | None = None
        for name in path:
            found = self.members.get(message, {}).get(name)
            message = "" if found is None else found.name
        return "" if found is None else str(found)


def scenario_of(run: Run, found: Retraced, types: Types) -> str:
    """The text of a scenario."""
    lines = [f"{name} : {role}" for name, role in run.team]
    last = found.moments[-1] if found.moments else 0
    if run.further:
        lines.append(f"stepwise until {moment(last + MILLISECOND)}")
    else:
        lines.append("stepwise")
    happenings = [
        (at - (item.earlier if isinstance(item, Comes) else 0), item)
        for at, items in zip(found.moments, found.happenings, strict=True)
        for item in items
    ]
    lines += [_line(item, moment(at), types) for at, item in sorted(happenings, key=lambda pair: pair[0])]
    end = max(last + run.further, run.end)
    lines += [item.format(end=moment(end), last=moment(last)) for item in run.expects]
    lines.append(f"for {moment(end)}")
    title = run.title.replace("\\", "\\\\").replace('"', "'")
    return f'scenario "{title}" {{\n' + "".join(f"  {line}\n" for line in lines) + "}\n"


def moment(at: int) -> str:
    """A moment (ns) as a file writes it."""
    if at % SECOND == 0:
        return f"{at // SECOND}s"
    if at % MILLISECOND == 0:
        return f"{at // MILLISECOND}ms"
    return f"{at / MILLISECOND:.6f}".rstrip("0") + "ms"


def _line(item: Happening, at: str, types: Types) -> str:
    if isinstance(item, Crash):
        return f"crash {item.agent} at {at}"
    return f"at {at} {_said(item, types)}"


def _said(item: Acts | Comes | Arrives | Event | Gives, types: Types) -> str:
    match item:
        case Acts():
            return " ".join(_acts(item, types))
        case Comes(agent=agent, channel=channel, content=content, sender=sender):
            by = "" if sender is None else f" from {sender}"
            return f"{agent} receives {channel} {{ {_fills(content, types)} }}{by}"
        case Arrives(agent=agent, sender=sender, what=what, is_lost=is_lost):
            return f"{agent} {'misses' if is_lost else 'gets'} {what} from {sender}"
        case Event(agent=agent, event=event):
            return f"{agent} raises {event}"
        case Gives(agent=agent, function=function, value=value):
            return f"{agent} computes {function} = {_value(value, '')}"
        case _:
            assert_never(item)


def _acts(item: Acts, types: Types) -> Iterator[str]:
    variables = types.variables.get(item.agent, {})
    yield f"{item.agent} {item.verb} {item.activity}"
    if item.outcome is not None:
        yield f"with {item.outcome}"
    for performative, message in item.takes:
        yield f"takes {message}" if performative is None else f"takes {performative} {message}"
    for name, value in item.sets.items():
        if value is None:  # it is as absent as it was
            continue
        yield f"sets {name} = {_value(value, variables.get(name, ''))}"
    for channel, content in item.writes:
        yield f"writes {channel} {{ {_fills(content, types)} }}"
    for content in item.prepares:
        yield f"prepares {_kind(content)} {{ {_fills(content, types)} }}"
    for performative, content, part in item.sends:
        yield f"sends {performative} {_kind(content)} {{ {_fills(content, types)} }} to {part}"


def _kind(content: Content) -> str:
    return content.kind or type(content.whole).__name__


def _fills(content: Content, types: Types) -> str:
    pairs = content.members.items() if content.whole is None else _members(content.whole, ())
    return "  ".join(
        f"{'.'.join(path)} = {_value(value, types.of_member(_kind(content), path))}" for path, value in pairs
    )


def _members(message: object, at: Path) -> Iterator[tuple[Path, object]]:
    """What a message holds, by the ways to its members."""
    for item in fields(cast("type", message)):
        value = getattr(message, item.name)
        if is_dataclass(value):
            yield from _members(value, (*at, item.name))
        elif value is not None and value != ():  # what is absent or empty is so by itself
            yield (*at, item.name), value


def _value(value: object, kind: str) -> str:
    match value:
        case bool():
            return "true" if value else "false"
        case Enum():
            return f"{type(value).__name__}.{value.name}"
        case int() if kind == "duration":
            return moment(value)
        case str():
            escaped = value.replace("\\", "\\\\").replace('"', '\\"')
            return f'"{escaped}"'
        case tuple() | list():
            return f"[{', '.join(_value(item, kind.removeprefix('list of ')) for item in value)}]"
        case _:
            return str(value)


__all__ = ["Run", "Types", "moment", "scenario_of"]
