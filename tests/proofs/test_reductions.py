"""Fewer states, the same answers: what is forgotten, and moves that are made first, make no difference.

A few random protocols are explored with and without each reduction in every run of the tests; many with
`REDUCED_TALKS=200`.
"""

from __future__ import annotations

import os
import random
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache, lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.playing.operate import generate_version, loaded_for
from aseme_dsl.project.proving.scopes import Scope, scope_of
from aseme_dsl.proofs.explore import questions
from aseme_dsl.proofs.explore.explored import Assumed, Explored, Move
from aseme_dsl.proofs.explore.questions import untouched
from aseme_dsl.proofs.explore.reducing.alike import Alike
from aseme_dsl.proofs.explore.reducing.never import Never
from aseme_dsl.proofs.explore.reducing.spent import Spent
from aseme_dsl.proofs.explore.relevant import Relevant
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import Source
from tests.proofs.random_talks import talk_of
from tests.support.model_mutants import model_mutants

TALKS = int(os.environ.get("REDUCED_TALKS", "1"))
FIRST = int(os.environ.get("REDUCED_FIRST", "1"))
MOST = 1600
"""A conversation with more states than so many, with nothing forgotten, is not compared."""
ENDED = """\
system Talks
message Word { int n }
enum Ending { NONE DONE LATE }
aip talk {
  participant asking {
    var withdrawn : bool = false
    var heard     : bool = false
    var ending    : Ending = Ending.NONE
    process = Ask . Wait . Learn
  }
  participant asked {
    var able   : bool = false
    var ending : Ending = Ending.NONE
    process = (serve [> Drop) . Close
    serve   = Look . [Work . Tell]
  }
  control asking {
    enter Wait  : / send request Word { n = 1 } to asked
    on    Wait  : agree Word from asked / heard = true
    on    Wait  : when [withdrawn && ending == Ending.NONE]
                  / ending = Ending.LATE; start_timer(patience, 10s); send cancel Word { n = 1 } to asked
    on    Wait  : after(10s) [!heard && ending == Ending.NONE]
                  / ending = Ending.LATE; start_timer(patience, 10s); send cancel Word { n = 1 } to asked
    enter Learn : inform Word from asked [ending == Ending.NONE] / ending = Ending.DONE
    enter Learn : inform Word from asked
    enter Learn : refuse Word from asked
    enter Learn : lost asked LAST
    enter Learn : when [ending == Ending.LATE && expired(patience)]
  }
  control asked {
    enter Drop  : cancel Word from asking / ending = Ending.LATE
    enter Close : [ending == Ending.LATE] / send inform Word { n = 1 } to asking
    enter Close : else
  }
  control serve {
    enter Look          : request Word from asking
    enter (Work . Tell) : [able] / send agree Word { n = 1 } to asking
    skip  (Work . Tell) : else / send refuse Word { n = 1 } to asking
    leave Tell          : / ending = Ending.DONE; send inform Word { n = 1 } to asking
  }
}
"""
"""An agent that has given up waits for a last word only; with a LAST that never holds, maybe for ever."""


REMEMBERED = """\
system Talks
message Word { int n }
aip talk {
  participant asking {
    var phase : int  = 0
    var told  : bool = false
    process = Ask . Wait . Learn
  }
  participant asked {
    process = Look
  }
  control asking {
    enter Ask   : / told = true
    enter Wait  : / phase = 1; send inform Word { n = 1 } to asked
    enter Learn : [phase == 1 && told]
  }
  control asked {
    enter Look : inform Word from asking
  }
}
"""
"""What is read only where another variable holds what it does not hold yet."""


COUNTED = """\
system Talks
message Word { int n }
enum Ending { NONE HEARD AGREED REFUSED }
aip talk {
  participant asking {
    var heard  : int    = 0
    var ending : Ending = Ending.NONE
    process = Ask . Wait . [Work]
  }
  participant asked {
    var able : bool = false
    process = Look . (Tell | Refuse)
  }
  control asking {
    enter Wait : / send request Word { n = 1 } to asked
    on    Wait : inform Word from asked / heard = heard + 1; ending = Ending.HEARD
    on    Wait : agree Word from asked / heard = heard + 1; ending = Ending.AGREED
    on    Wait : refuse Word from asked / heard = heard + 1; ending = Ending.REFUSED
    enter Work : [heard > 0 && ending != Ending.NONE]
    skip  Work : else
  }
  control asked {
    enter Look   : request Word from asking
    enter Tell   : [able] / send inform Word { n = 1 } to asking; send agree Word { n = 1 } to asking
    enter Refuse : else / send refuse Word { n = 1 } to asking
  }
}
"""
"""What was heard is counted, and asked for once."""


NEWS = """\
system Talks
message Word { int n }
enum Ending { NONE HEARD DONE }
aip talk {
  participant asking {
    var rounds : int    = 0
    var ending : Ending = Ending.HEARD
    process = Ask . Wait . Learn
  }
  participant asked {
    process = Look
  }
  control asking {
    enter Wait  : / send request Word { n = 1 } to asked
    on    Wait  : when [ending != Ending.NONE] / ending = Ending.DONE; rounds = rounds + 1
    enter Learn : after(5s) [rounds > 1]
  }
  control asked {
    enter Look : request Word from asking
  }
}
"""
"""What a line gives to a variable is no news to it."""


@dataclass(frozen=True, slots=True)
class Said:
    """What a search says of the questions, and how many states it has looked at."""

    states: int
    stuck: frozenset[tuple[str, str]]
    """The agents that wait for ever, and where."""
    seen: frozenset[str]
    visited: Mapping[str, frozenset[str]]
    taken: Mapping[str, frozenset[int]]
    ends: frozenset[tuple[tuple[int, ...], ...]]
    """Where the agents are when nothing can happen any more."""

    @property
    def answers(self) -> tuple[object, ...]:
        return self.stuck, self.seen, self.visited, self.taken, self.ends


@pytest.fixture(autouse=True)
def anew() -> None:
    """What was loaded is unloaded between tests."""
    _loaded.cache_clear()


@lru_cache(maxsize=1)
def _loaded(text: str, robots: int = 1) -> tuple[Loaded, Scope]:
    source = Source("talk.aseme", text)
    system = compile_root(source).system
    assert system is not None
    scope = scope_of(source, system.aips[0], robots)
    own = compile_root(scope.root)
    assert own.system is not None, own.diagnostics
    with TemporaryDirectory(prefix="talk-") as folder:
        package, _ = generate_version(own.system, Path(folder), choose(own.configuration))
        return loaded_for(package, Path()), scope


def said_of(text: str, crashes: bool = False, robots: int = 1) -> Said | None:
    """What a search says of the only protocol in a file; None if it has too many states."""
    loaded, scope = _loaded(text, robots)
    eyes = Eyes()
    one = frozenset((scope.team[-1][0],))
    explored = Explored(loaded, scope.team, Assumed(crashes=((1, one),) if crashes else ()), [eyes])
    graph = search(explored, eyes, None, Limits(MOST, 1e9))
    if graph.cut is not None or graph.is_queue_cut:
        return None
    seen = {item.kind for item in graph.sightings}
    for item in untouched(explored, graph):
        seen |= {"orphan"} if item.is_due else {"race"} if item.is_past else set()
    return Said(
        len(graph.parents),
        frozenset(_stuck(explored, graph)),
        frozenset(seen),
        {role: frozenset(labels) for role, labels in graph.visited.items()},
        {role: frozenset(numbers) for role, numbers in graph.taken.items()},
        frozenset(graph.places[state] for state, edges in graph.edges.items() if not edges),
    )


def _stuck(explored: Explored, graph: Graph) -> Iterator[tuple[str, str]]:
    back = questions._back(graph)
    for place, agent in enumerate(explored.agents):
        for region in range(len(agent.chart.REGIONS)):
            for state in questions._for_ever(graph, back, place, region, agent):
                waiting = questions._waits(explored, graph, state, place, region)
                if waiting is not None:
                    yield agent.name, waiting.name


_said = cache(said_of)


def _nothing(*_: object) -> None:
    return None


REDUCTIONS: Mapping[str, Sequence[tuple[type, str, object]]] = {
    "never": [(Never, "is_never", lambda *_: False)],
    "spent": [(Spent, "forget", _nothing), (Spent, "drop", _nothing), (Spent, "sent", lambda _, acl: acl)],
    "alike": [(Alike, "forget", _nothing)],
    "first": [(Explored, "first", _nothing)],
    "judged": [(Explored, "judges", True)],
}
ENDS = {
    "it is remembered": REMEMBERED,
    "it ends": ENDED.replace("LAST", "/ ending = Ending.DONE"),
    "it waits for ever": ENDED.replace("LAST", "[heard && withdrawn]")
    .replace(" && expired(patience)", " && heard")
    .replace("    enter Learn : inform Word from asked\n", ""),
}


def random_texts(first: int, number: int) -> Iterator[str]:
    """Conversations, half of them small ones by chance, half of them one with a mistake by chance."""
    mutants = [item.text for text in ENDS.values() for item in model_mutants(text)]
    for seed in range(first, first + number):
        chance = random.Random(seed)
        if seed % 2:
            yield talk_of(chance)
        else:
            yield next(
                text
                for text in chance.sample(mutants, len(mutants))
                if compile_root(Source("talk.aseme", text)).system
            )


def _without(patch: pytest.MonkeyPatch, names: Iterable[str]) -> None:
    for name in names:
        for owner, attribute, instead in REDUCTIONS[name]:
            patch.setattr(owner, attribute, instead)


@pytest.mark.parametrize("name", REDUCTIONS)
def test_each_reduction_has_fewer_states_and_the_same_answers(
    monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    text = COUNTED if name == "alike" else ENDS["it waits for ever"]
    reduced = _said(text)
    _without(monkeypatch, [name])
    full = said_of(text)
    assert full is not None and reduced is not None
    assert full.answers == reduced.answers
    assert full.states > reduced.states


def test_what_a_line_has_given_to_a_variable_is_like_no_other_value(monkeypatch: pytest.MonkeyPatch) -> None:
    reduced = _said(NEWS)
    _without(monkeypatch, ["alike"])
    full = said_of(NEWS)
    assert full is not None and reduced is not None
    assert ("asking", "Wait") in full.stuck
    assert full.answers == reduced.answers


def test_the_answers_are_the_same_without_all_reductions(monkeypatch: pytest.MonkeyPatch) -> None:
    compared = 0
    for number, text in enumerate(random_texts(FIRST, TALKS)):
        crashes = number % 4 > 1
        with monkeypatch.context() as patch:
            _without(patch, REDUCTIONS)
            full = said_of(text, crashes)
        if full is None:
            continue
        reduced = said_of(text, crashes)
        assert reduced is not None
        assert full.answers == reduced.answers, (FIRST + number, text)
        compared += 1
        if "REDUCED_TALKS" in os.environ:
            print(
                FIRST + number,
                crashes,
                full.states,
                reduced.states,
                sorted(full.seen),
                len(full.stuck),
                flush=True,
            )
    assert compared >= TALKS / 2


def _any_arrival(explored: Explored, moves: Sequence[Move]) -> Move | None:
    return next((move for move in moves if move.kind[0] == "arrive"), None)


@pytest.mark.parametrize(
    ("owner", "attribute", "instead"),
    [
        pytest.param(Never, "is_never", lambda *_: True, id="every condition counts as false for ever"),
        pytest.param(Never, "_written", lambda *_: frozenset(), id="what lines write is not seen"),
        pytest.param(Explored, "first", _any_arrival, id="every message comes first"),
        pytest.param(Explored, "judges", False, id="nothing is asked of messages that nothing takes"),
        pytest.param(
            Spent,
            "drop",
            lambda _, ways, *rest: [item.clear() for item in ways.ways.values()],
            id="all is dropped",
        ),
        pytest.param(
            Relevant,
            "_asked_from",
            lambda *_: iter(()),
            id="timers that something asks for are forgotten",
        ),
    ],
)
def test_a_reduction_that_forgets_too_much_is_noticed(
    monkeypatch: pytest.MonkeyPatch, owner: type, attribute: str, instead: Callable[..., object]
) -> None:
    before = [_said(text) for text in ENDS.values()]
    monkeypatch.setattr(owner, attribute, instead)
    assert any(_differs(said_of(text), said) for text, said in zip(ENDS.values(), before, strict=True))


def _differs(one: Said | None, other: Said | None) -> bool:
    return (one and one.answers) != (other and other.answers)
