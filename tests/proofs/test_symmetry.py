"""Others that nothing tells apart change places: an agent among them does the same, in fewer states.

A few mistakes by chance are compared in the long lane; many with `ALIKE_TALKS=200`.
"""

from __future__ import annotations

import os
import random
from collections.abc import Callable, Mapping

import pytest

from aseme_dsl.project.building.project import compile_root
from aseme_dsl.proofs.explore import explored
from aseme_dsl.proofs.explore.reducing import symmetry
from aseme_dsl.proofs.explore.search import Graph
from aseme_dsl.source import Source
from tests.proofs.test_others import GROUP, alone
from tests.support.model_mutants import model_mutants

TALKS = int(os.environ.get("ALIKE_TALKS", "5"))
FIRST = int(os.environ.get("ALIKE_FIRST", "1"))
LIBRARY = "aseme_dsl.runtime.library.agents"
MARKET = f"""\
system Market
message Offer {{ double price }}
function ranked(string all, string who, double number) : string = "{LIBRARY}:ranked"
function with_agent(string all, string who) : string = "{LIBRARY}:with_agent"
function without(string all, string who) : string = "{LIBRARY}:without"
function lists(string all, string who) : bool = "{LIBRARY}:lists"
function first_of(string all) : agent = "{LIBRARY}:first_of"
function called(string name) : agent = "{LIBRARY}:agent_called"
aip sale {{
  participant seller {{
    var keen  : string = ""
    var heard : string = ""
    var best  : agent
    process = Call . Hear . Serve . [Thank] . Close
  }}
  participant buyer [1..*] {{
    process = Listen . Bid . Leave
  }}
  control seller {{
    enter Hear    : / send cfp Offer {{ price = 1.0 }} to buyer
    on    Hear    : propose Offer o from buyer
                  / keen = ranked(keen, sender(o), o.price); heard = with_agent(heard, sender(o))
    enter Serve   : when [all_answered(buyer)]
    on    Serve   : agree Offer o from buyer [sender(o) == first_of(keen) && lists(heard, sender(o))]
                  / best = sender(o); keen = without(keen, sender(o))
    enter [Thank] : agree Offer from buyer
    enter Thank   : [has(best) && keen == ""]
    skip  Thank   : else
  }}
  control buyer {{
    enter Listen : cfp Offer from seller
    enter Leave  : / send propose Offer to seller; send agree Offer to seller
  }}
}}
"""
"""A seller keeps lists of those who bid: in the order of prices, and in that in which they came."""
TOLD = {
    "a line names one": ("[has(best) && keen", '[best == called("buyer2") && keen'),
    "a line asks which name comes first": (
        "[has(best) && keen",
        '[with_agent("", best) > with_agent("", first_of(heard)) && keen',
    ),
}
"""What tells buyers from one another, as it is written instead of something else."""


def _done(graph: Graph, may_wait: bool) -> tuple[object, ...]:
    """What the seller does, and where."""
    ways = {
        (graph.places[state], edge.taken, graph.places[edge.target])
        for state, edges in graph.edges.items()
        for edge in edges
    }
    kinds = {item.kind for item in graph.sightings}
    return graph.visited, graph.taken, {*graph.places}, ways, kinds, may_wait


def compare(monkeypatch: pytest.MonkeyPatch, text: str, robots: int) -> Mapping[str, tuple[int, int]]:
    """How many states and moves of each agent there are less; what it does is the same."""
    fewer = alone(text, robots)
    with monkeypatch.context() as patch:
        patch.setattr(explored, "groups_of", lambda *_: ())
        all_ = alone(text, robots)
    found = {}
    for role, (graph, may_wait) in fewer.items():
        if role in all_:
            full = all_[role][0]
            assert _done(graph, may_wait) == _done(*all_[role]), (role, text)
            found[role] = len(full.parents) - len(graph.parents), full.moves - graph.moves
    return found


@pytest.mark.parametrize("robots", [2, pytest.param(3, marks=pytest.mark.long)])
def test_an_agent_does_the_same_in_fewer_states(monkeypatch: pytest.MonkeyPatch, robots: int) -> None:
    states, moves = compare(monkeypatch, MARKET, robots)["proved_sale_seller"]
    assert states > 0 and moves > 0


def test_an_agent_that_keeps_no_names_does_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    states, moves = compare(monkeypatch, GROUP, 2)["proved_talk_asking"]
    assert states == 0 and moves > 0


@pytest.mark.parametrize("name", TOLD)
def test_those_who_are_told_apart_do_not_change_places(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    text = MARKET.replace(*TOLD[name])
    assert text != MARKET
    assert compare(monkeypatch, text, 2)["proved_sale_seller"] == (0, 0)


def _nothing(*_: object) -> object:
    return [], set[str]()


@pytest.mark.parametrize(
    ("name", "attribute", "instead"),
    [
        ("a line names one", "_said", _nothing),
        ("a line asks which name comes first", "_asks_for_order", lambda plan: False),
    ],
)
def test_it_is_noticed_if_those_who_are_told_apart_change_places(
    monkeypatch: pytest.MonkeyPatch, name: str, attribute: str, instead: Callable[..., object]
) -> None:
    monkeypatch.setattr(symmetry, attribute, instead)
    with pytest.raises(AssertionError):
        compare(monkeypatch, MARKET.replace(*TOLD[name]), 2)


@pytest.mark.long
def test_random_mistakes_make_no_difference(monkeypatch: pytest.MonkeyPatch) -> None:
    mutants = [item.text for item in model_mutants(MARKET)]
    compared = 0
    for seed in range(FIRST, FIRST + TALKS):
        chance = random.Random(seed)
        text = next(item for item in chance.sample(mutants, len(mutants)) if _is_right(item))
        found = compare(monkeypatch, text, 2)
        compared += bool(found)
        if "ALIKE_TALKS" in os.environ:
            print(seed, found, flush=True)
    assert compared


def _is_right(text: str) -> bool:
    return compile_root(Source("talk.aseme", text)).system is not None
