"""External agents that do not keep to a protocol of the library: nobody waits for ever, and nobody fails."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.stdlib.hostile import Kind, Move, against, left_waiting, sent_by
from tests.stdlib.library import PROTOCOLS, protocol

WAYS: dict[str, Callable[[list[Kind]], list[Kind]]] = {
    "in order": lambda moves: moves,
    "each twice": lambda moves: [move for move in moves for _ in range(2)],
    "backwards": lambda moves: moves[::-1],
    "silent": lambda moves: [],
}
"""What a hostile agent makes of the moves of its part."""


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(
    ("name", "agent"), [(item.name, agent) for item in PROTOCOLS for agent in item.parts], ids=str
)
def test_nobody_waits_for_a_hostile_agent(name: str, agent: str, way: str) -> None:
    item = protocol(name)
    moves = [Move(*move) for move in WAYS[way](sent_by(item, item.parts[agent]))]
    run = against(item, agent, moves)
    assert left_waiting(run) == []
    assert run.of("error") == []
