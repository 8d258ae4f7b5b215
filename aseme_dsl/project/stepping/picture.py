"""Picture: what a team is and knows at an instant, as a plain value."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.play.followed import around
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.team.team import Team


@dataclass(frozen=True, slots=True)
class StateLine:
    """A state in the outline of a statechart; `at` is its place in the source."""

    label: str
    depth: int
    text: str
    is_active: bool
    is_running: bool
    """Whether its activity runs: it is active, and not complete."""
    at: str


@dataclass(frozen=True, slots=True)
class Value:
    """Something that an agent knows, with its age in ns if it has one."""

    kind: str
    """One of `variable`, `state`, `signal`, `data`, `timer`, `mail`."""
    name: str
    value: object
    age: int | None = None


@dataclass(frozen=True, slots=True)
class AgentPicture:
    """One agent. `ended` says why it does nothing any more, and is empty while it does."""

    name: str
    role: str
    states: tuple[StateLine, ...]
    values: tuple[Value, ...]
    ended: str = ""


@dataclass(frozen=True, slots=True)
class Picture:
    """A team at a moment (ns)."""

    moment: int
    agents: tuple[AgentPicture, ...]


def picture_of(team: Team) -> Picture:
    """What there is to see of a team; nothing in it may move meanwhile."""
    now = team.driver.clock.now()
    return Picture(now, tuple(_agent(agent, now) for agent in team.agents))


def _agent(agent: Agent, now: int) -> AgentPicture:
    chart = agent.chart
    ended = chart.failure or ("has ended" if agent.over else "")
    leaves = frozenset(chart.configuration()) if chart.started else frozenset()
    running = {
        label
        for label, (leaf, _, number) in chart.RUNNING.items()
        if label in leaves and getattr(chart, leaf) == number
    }
    values = tuple(_values(agent, now)) if leaves else ()
    return AgentPicture(
        agent.name, agent.role, tuple(_outline(agent.plan, leaves, running)), values, str(ended)
    )


def _outline(plan: Plan, leaves: frozenset[str], running: set[str]) -> Iterator[StateLine]:
    """The states that have names, those inside an inactive one left out."""
    active = {label for leaf in leaves for label in around(leaf)}
    depths: dict[str, int] = {}
    for state in plan.states:
        parent = state.parent
        depth = depths.get(parent, -1) if parent is not None else -1
        has_name = state.type not in _NAMELESS and state.name not in ("", state.label)
        depths[state.label] = depth + has_name
        if has_name and (parent is None or parent in active):
            label = state.label
            yield StateLine(label, depth + 1, state.name, label in active, label in running, state.at)


_NAMELESS = ("START", "END", "CONDITION")


def _values(agent: Agent, now: int) -> Iterator[Value]:
    chart = agent.chart
    for name in chart.VARIABLES:
        yield Value("variable", name, to_json(chart.variable(name)))
    found: dict[tuple[str, str], Value] = {}
    for board in chart.boards():
        if board is None:
            continue
        for channel in sorted(board.CHANNELS):
            item = board.newest(channel)
            if item is not None:
                kind = channel.split(".", 2)[1]
                found[kind, channel] = Value(kind, channel, to_json(item.message), now - item.time)
        for timer, end in board.timers.items():
            found["timer", timer] = Value("timer", timer, end - now)
    yield from found.values()
    for letters in chart.mail.values():
        for letter in letters:
            what = f"{letter.performative} {letter.message} from {letter.sender}".replace("  ", " ")
            yield Value("mail", what, to_json(letter.content), None)


__all__ = ["AgentPicture", "Picture", "StateLine", "Value", "picture_of"]
