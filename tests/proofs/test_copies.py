"""Copies of a part in a protocol do not depend on each other: one of them, explored with the others standing
still, does all that any of them does in a team.

A few random conversations are compared with a search of the team in every run of the tests; many with
`COPIES=100`.
"""

from __future__ import annotations

import os
import re
from dataclasses import replace
from operator import itemgetter
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.playing.operate import generate_version, loaded_for
from aseme_dsl.project.proving.scopes import scope_of
from aseme_dsl.proofs.explore.deciding.lists import Lists
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.questions import stuck_alone
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import Source
from tests.proofs.test_reductions import _stuck, random_texts
from tests.proofs.test_symmetry import MARKET

COPIES = int(os.environ.get("COPIES", "3"))
FIRST = int(os.environ.get("COPIES_FIRST", "1"))
MOST = 4000 if "COPIES" in os.environ else 200
"""So many states of a team; what those show that were found, has to be found of an agent alone, too."""
COPY = re.compile(r"(?<![0-9.])(0\.2)\.[12](?![0-9])")
"""The label of a copy, of two."""


def doubled(text: str) -> tuple[Loaded, tuple[tuple[str, str], ...]]:
    """The team of the only protocol in a file, in which each agent has two copies of its part."""
    source = Source("talk.aseme", text)
    system = compile_root(source).system
    assert system is not None
    scope = scope_of(source, system.aips[0], 1)
    assert isinstance(scope.root, Source)
    roles = re.sub(r"liveness \{ (\w+) = (\w+) \}", r"liveness { \1 = (\2~)[2] }", scope.root.text)
    own = compile_root(Source("talk.aseme", roles))
    assert own.system is not None, own.diagnostics
    with TemporaryDirectory(prefix="copies-") as folder:
        package, _ = generate_version(own.system, Path(folder), choose(own.configuration))
        return loaded_for(package, Path()), scope.team


def lines_of(plan: Plan, numbers: set[int]) -> set[str]:
    """Transitions, without the copy in which they are."""
    found = (replace(plan.transitions[number], at="", text="") for number in numbers)
    return {COPY.sub(r"\1", repr(item)) for item in found}


def states_of(labels: set[str]) -> set[str]:
    return {COPY.sub(r"\1", label) for label in labels}


def compare(text: str) -> str:
    """What was compared; empty if nothing was."""
    loaded, team = doubled(text)
    eyes = Eyes()
    explored = Explored(loaded, team, Assumed(), [eyes])
    whole = search(explored, eyes, None, Limits(MOST, 20.0))
    is_cut = whole.cut is not None or whole.is_queue_cut
    stuck = set[str]() if is_cut else {agent for agent, _ in _stuck(explored, whole)}
    told = []
    for name, role in team:
        plan = loaded.charts[role].PLAN
        eyes = Eyes()
        beside = frozenset(other for other, _ in team if other != name)
        alone = Explored(loaded, team, Assumed(), [eyes], others=beside, group=0)
        assert len(alone.apart) == 1
        alone.judged.clear()
        graph = search(alone, eyes, None, Limits(4000, 20.0))
        assert alone.others is not None
        if graph.cut is not None or alone.others.is_bounded:
            continue
        assert states_of(whole.visited[role]) <= states_of(graph.visited[role]), text
        taken, found = whole.taken.get(role, set()), graph.taken.get(role, set())
        assert lines_of(plan, taken) <= lines_of(plan, found), text
        may_wait = stuck_alone(alone, graph)
        assert may_wait or name not in stuck, (name, text)
        told.append(f"{name} {len(graph.parents)}{' waits' if may_wait else ''}")
    end = "cut" if is_cut else sorted(stuck)
    return f"{len(whole.parents)}: {', '.join(told)}; {end}" if told else ""


def test_one_of_two_copies_does_all_that_both_do() -> None:
    compared = 0
    for number, text in enumerate(random_texts(FIRST, COPIES)):
        found = compare(text)
        compared += bool(found)
        if "COPIES" in os.environ:
            print(FIRST + number, found, flush=True)
    assert compared


SALE = (
    MARKET.replace("message Offer", "message Item { int n }\nmessage Offer")
    .replace("cfp Offer { price = 1.0 }", "cfp Item { n = 1 }")
    .replace("cfp Offer", "cfp Item")
)
"""Only offers have prices."""
NOTE = "    on    Note    : propose Offer o from buyer / heard = ranked(heard, sender(o), o.price)\n"


def _sold(loaded: Loaded, team: tuple[tuple[str, str], ...]) -> tuple[bool, Graph]:
    """Whether a seller may rank a buyer anywhere, and what it does among others."""
    (_, role), *others = team
    eyes = Eyes()
    alone = Explored(loaded, team, Assumed(), [eyes], others=frozenset(map(itemgetter(0), others)), group=0)
    alone.judged.clear()
    return bool(alone.values.free[role]), search(alone, eyes, None, Limits(300, 20.0))


def test_each_copy_ranks_agents_in_a_list_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    market = doubled(SALE)
    is_free, anywhere = _sold(*market)
    monkeypatch.setattr(Lists, "free", lambda *_: frozenset[str]())
    _, by_prices = _sold(*market)
    assert is_free and len(anywhere.parents) < len(by_prices.parents)
    assert anywhere.visited == by_prices.visited and anywhere.taken == by_prices.taken


def test_two_lists_in_which_one_message_is_ranked_have_one_order() -> None:
    text = SALE.replace("Call . Hear .", "Call . (Hear || Note) .").replace(
        "    enter Serve ", f"{NOTE}    enter Serve "
    )
    assert not _sold(*doubled(text))[0]
