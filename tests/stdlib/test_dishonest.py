"""Agents of the team whose activities try to say what their protocol does not let them say."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from tests.runtime.playing import make
from tests.stdlib.hostile import LIMIT, Kind, endings, finish, left_waiting, sent, sent_by
from tests.stdlib.leaving import AGENTS, of
from tests.stdlib.library import Protocol, kind_of, protocol
from tests.support.generated import Generated
from tests.support.lanes import kept


def attempts(item: Protocol, made: Generated) -> list[tuple[Kind, Any, str]]:
    """All that anybody may say, to each agent and each part."""
    parts = list(dict.fromkeys(item.parts.values()))
    kinds = dict.fromkeys(kind for part in parts for kind in sent_by(item, part))
    return [(kind, made.message(kind[1]), to) for kind in kinds for to in (*parts, *item.parts)]


def try_all(
    context: Context, tries: Iterable[tuple[Kind, Any, str]], refused: list[str], went: list[str]
) -> None:
    """Send each message; note those that raise, and those that do not."""
    for (performative, message), content, to in tries:
        try:
            context.send(performative, content, to)
        except Exception as problem:
            refused.append(str(problem))
        else:
            went.append(f"{performative} {message} to {to}")


def honest_acts(item: Protocol, made: Generated) -> dict[str, type[Any]]:
    return {activity: kind_of(made, activity, what) for activity, what in item.acts.items()}


def dishonest(
    usual: type[Any], item: Protocol, made: Generated, agent: str, refused: list[str], went: list[str]
) -> type[Any]:
    """An activity that, at its begin and at its end, says whatever it can, and else does what it should."""
    tries = attempts(item, made)

    class Activity(usual):  # type: ignore[misc]
        def execute(self, context: Context) -> None:
            if context.agent == agent:
                try_all(context, tries, refused, went)
            super().execute(context)
            if context.agent == agent:
                try_all(context, tries, refused, went)

    return Activity


@pytest.mark.parametrize(("name", "agent"), AGENTS, ids=str)
def test_no_activity_says_what_a_line_of_the_protocol_says(name: str, agent: str) -> None:
    """Each attempt raises in the activity; what is said, and how all ends, is as without it."""
    item = protocol(name)
    made = of(item)
    refused: list[str] = []
    went: list[str] = []
    honest, usual_acts = honest_acts(item, made), honest_acts(item, made)
    liar = {activity: dishonest(kind, item, made, agent, refused, went) for activity, kind in honest.items()}
    agents = [(who, f"{part}_role") for who, part in item.parts.items()]
    run, usual = (finish(*make(made, classes, agents=agents, until=LIMIT)) for classes in (liar, usual_acts))
    assert went == []
    assert len(refused) >= 2 * len(attempts(item, made)) or agent not in endings(usual)
    assert (sent(run), endings(run)) == (sent(usual), endings(usual))
    assert left_waiting(run) == []


@pytest.mark.parametrize(("name", "agent"), kept(AGENTS, lambda who: AGENTS.index(who) % 2), ids=str)
def test_nor_does_one_beside_the_participant(name: str, agent: str) -> None:
    """An activity of the role that goes on in parallel has no part in the conversation."""
    item = protocol(name)
    made = of(item)
    refused: list[str] = []
    went: list[str] = []
    tries = attempts(item, made)

    class Waiting:
        def execute(self, context: Context) -> None:
            for _ in range(8):
                context.wait(1)

    class Clock(Waiting):
        def execute(self, context: Context) -> None:
            for _ in range(8):
                context.wait(1)
                try_all(context, tries, refused, went)

    role = f"abandoning_{item.parts[agent]}"
    agents = [(who, role if who == agent else f"{part}_role") for who, part in item.parts.items()]
    run, usual = (
        finish(*make(made, {**honest_acts(item, made), "Clock": kind}, agents=agents, until=LIMIT))
        for kind in (Clock, Waiting)
    )
    assert went == []
    assert len(refused) == 8 * len(attempts(item, made))
    assert (sent(run), endings(run)) == (sent(usual), endings(usual))
