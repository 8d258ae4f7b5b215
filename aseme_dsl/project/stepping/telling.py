"""Telling: what happened in an instant, and what an agent is and knows, as lines for people."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.play.sight.words import ending, way
from aseme_dsl.project.stepping.picture import AgentPicture, StateLine, Value
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.runtime.trace.records import Record

LONG = 100
"""A value is shown with so many characters at most."""


def told(records: Iterable[Record], plans: Mapping[str, Plan]) -> Iterator[tuple[str, str]]:
    """The agents and what has happened to them, in order. What is a detail of something else is left out."""
    for record in records:
        agent = record.get("agent", "")
        match record["kind"]:
            case "step":
                for taken in record["taken"]:
                    yield agent, way(plans[agent], taken)
            case "activity" if record["what"] in ("end", "crash"):
                yield agent, ending(record)
            case "activity" if record["what"] in ("start", "cancel"):
                yield (
                    agent,
                    f"{record['activity']} {'starts' if record['what'] == 'start' else 'is cancelled'}",
                )
            case "scenario":
                yield agent, "crashes" if record["what"] == "crash" else "starts again"
            case "message":
                yield agent, f"publishes {record['channel']} {_short(record['message'])}"
            case "agent_message":
                to = ", ".join(record["to"])
                what = " ".join((record["performative"], str(record["message"]))).strip()
                yield agent, f"sends {what} {_short(record['content'])} to {to}"
            case "unexpected" | "fault" | "error":
                yield agent, f"{record['kind']}: {record['reason']}"
            case _:
                pass


def inner_states(agent: AgentPicture) -> list[StateLine]:
    """The innermost active states."""
    active = [item for item in agent.states if item.is_active]
    return [item for item in active if not any(other.label.startswith(f"{item.label}.") for other in active)]


def states_of(agent: AgentPicture) -> str:
    """What these are called."""
    return ", ".join(item.text for item in inner_states(agent)) or "-"


def state_line(item: StateLine) -> str:
    """A state in its outline: `▶` if its activity runs, `●` if it is active only, `○` if it is not."""
    mark = "▶" if item.is_running else "●" if item.is_active else "○"
    return f"{mark} {'  ' * item.depth}{item.text}"


def value_line(value: Value) -> str:
    """A value with its name and its age."""
    match value.kind:
        case "timer":
            left = value.value
            assert isinstance(left, int)
            return f"timer {value.name}: {f'{shown(left)} left' if left > 0 else 'has run out'}"
        case "mail":
            return f"waits: {value.name} {_short(value.value)}"
        case "variable":
            return f"{value.name} = {_short(value.value)}"
        case _:
            age = f"  ({shown(value.age)} old)" if value.age is not None else ""
            return f"{value.name} {_short(value.value)}{age}"


def _short(value: object) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONG else f"{text[: LONG - 1]}…"


__all__ = ["inner_states", "state_line", "states_of", "told", "value_line"]
