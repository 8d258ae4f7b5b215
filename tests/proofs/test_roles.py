"""Fewer states and moves of roles with activities and messages: the same answers with and without each.

A few random charts are explored in every run of the tests; many with `ROLES_CHARTS=200`.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from aseme_dsl.project.building.project import compile_root
from aseme_dsl.proofs.explore import coming, relevant
from aseme_dsl.proofs.explore.coming import Coming
from aseme_dsl.proofs.explore.deciding import values
from aseme_dsl.proofs.explore.deciding.later import Later
from aseme_dsl.proofs.explore.deciding.values import Values
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.reducing import steady
from aseme_dsl.proofs.explore.reducing.steady import Steady
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from aseme_dsl.runtime.activity.execution import Execution
from aseme_dsl.source import Source
from tests.oracle.charts import text as chart_of
from tests.proofs.test_absence import EXAMPLES, loaded_of
from tests.proofs.test_explored_charts import Timeless
from tests.proofs.test_reductions import _stuck

CHARTS = range(int(os.environ.get("ROLES_CHARTS", "0"))) or (6, 8, 22)
STEADY = """\
system Steady
message Ball { bool near int x }
topic eye { state Ball }
srm robot {
  liveness { robot = Look~ || Think~ || play~ play = Wait . (Kick | Rest) }
  activities { Look writes eye.state.Ball }
  control play {
    enter Kick : [eye.state.Ball.near]
    enter Rest : when [!eye.state.Ball.near && eye.state.Ball.x > 3]
  }
}
"""
SEEN = """\
system Seen
message Ball { bool near int x }
topic eye { state Ball }
srm robot {
  liveness { robot = Look~ || play~ play = Wait . (Kick | Rest) }
  activities { Look writes eye.state.Ball }
  control robot {
    repeat Look : [eye.state.Ball.near] / raise seen
    repeat Look : else
  }
  control play {
    enter Kick : seen
    enter Rest : [eye.state.Ball.x > 3]
  }
}
"""
"""An activity that is begun anew for ever, and whose end may raise an event."""
LUCK = """\
system Luck
function lucky(int n) : bool = "luck:lucky"
srm robot {
  var n : int
  liveness { robot = Look~ || play~ play = Wait . Kick }
  control play { enter Kick : when [lucky(n)] }
}
"""
"""An agent to which nothing comes: only the ends of activities let it step."""
ORDERS = """\
system Orders
message Order { int first int second }
topic team { state Order }
srm chief { liveness { chief = Give~ } activities { Give writes team.state.Order } }
srm robot {
  liveness { robot = (Wait . (A | B | C))~ }
  control robot {
    enter A : [LINE]
    enter B : [age(team.state.Order) < 1s && team.state.Order.first == team.state.Order.second]
    enter C : else
  }
}
"""
ROUND = """\
system Round
message Ball { double x }
topic eye { state Ball }
srm robot {
  var zone : int = 3
  var next : int = 0
  var last : int = 0
  liveness { robot = (Drive(next, zone) . (Look | Kick))~ }
  activities { Drive(to : int, of : int)  Look }
  control robot {
    enter Look : [eye.state.Ball.x > 3] / next = (next + 1) % 4; last = LAST
    enter Kick : else
    repeat (Drive(next, zone) . (Look | Kick)) : [MORE]
  }
}
"""
"""What only goes to an activity is counted round, and a number is only compared with one constant."""
GIVEN = ROUND.replace("LAST", "next").replace("MORE", "true")
ASKED = ROUND.replace("LAST", "next").replace("MORE", "last < 2")
MAY_FAIL = ROUND.replace("LAST", "10 % next").replace("MORE", "true")
COUNTED = """\
system Counted
srm robot {
  var level : int
  liveness { robot = (Count . (Rest | Work))~ }
  activities { Count writes level }
  control robot { enter Work : [level > 3]  enter Rest : else }
}
"""
YOUNG = ORDERS.replace("LINE", "age(team.state.Order) < 1s && team.state.Order.first > 1")
YOUNG_LAST = YOUNG.replace(
    "age(team.state.Order) < 1s && team.state.Order.first > 1",
    "team.state.Order.first > 1 && age(team.state.Order) < 1s",
)
ANY_AGE = ORDERS.replace("LINE", "team.state.Order.first > 1")

Without = Callable[[pytest.MonkeyPatch], None]


def without_steady(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(Steady, "is_idle", lambda *_: False)


def steady_everywhere(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(steady, "is_steady", lambda *_: True)


def steady_without_inputs(patch: pytest.MonkeyPatch) -> None:
    known = Steady.is_idle

    def is_idle(found: Steady, execution: Execution) -> bool:
        with patch.context() as inner:
            inner.setattr(Coming, "has_more", lambda *_: True)
            return known(found, execution)

    patch.setattr(Steady, "is_idle", is_idle)


def without_like(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(Values, "like", lambda _, message, path, told: ((message, path), {}))


def without_faded(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(coming, "faded_in", lambda _: {})


def without_faint(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(relevant, "faint_in", lambda _: frozenset())


def without_few(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(values, "_few", lambda *_: None)


REDUCTIONS = without_steady, without_like, without_faded, without_faint, without_few


def explored(
    text: str | Path,
    folder: Path,
    *roles: str,
    states: int = 1500,
    seconds: float = 4,
    assumed: Assumed | None = None,
) -> tuple[Graph, tuple[object, ...]]:
    """What was found, and its answers."""
    loaded = loaded_of(Source("it.aseme", text) if isinstance(text, str) else text, folder)
    eyes = Eyes()
    names = tuple((f"a{place}", role) for place, role in enumerate(roles))
    team = Explored(loaded, names, assumed or Assumed(), [eyes])
    graph = search(team, eyes, None, Limits(states, seconds))
    answers = (
        frozenset(graph.places),
        {name: frozenset(labels) for name, labels in graph.visited.items()},
        {name: frozenset(numbers) for name, numbers in graph.taken.items()},
        frozenset(_stuck(team, graph)) if graph.cut is None else None,
        frozenset(graph.places[state] for state, edges in graph.edges.items() if not edges),
    )
    return graph, answers


@pytest.mark.parametrize(
    ("text", "roles", "without"),
    [
        pytest.param(STEADY, ("robot",), without_steady, id="steady"),
        pytest.param(YOUNG, ("chief", "robot"), without_like, id="like"),
        pytest.param(YOUNG, ("chief", "robot"), without_faded, id="faded"),
        pytest.param(YOUNG_LAST, ("chief", "robot"), without_faded, id="faded, the age last"),
        pytest.param(GIVEN, ("robot",), without_faint, id="faint"),
        pytest.param(COUNTED, ("robot",), without_few, id="few"),
    ],
)
def test_each_has_less_to_do_and_the_same_answers(
    text: str, roles: tuple[str, ...], without: Without, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reduced, answers = explored(text, tmp_path / "a", *roles)
    without(monkeypatch)
    full, others = explored(text, tmp_path / "b", *roles)
    assert reduced.cut is full.cut is None
    assert answers == others
    assert reduced.moves < full.moves


@pytest.mark.parametrize(
    ("text", "spoil"),
    [
        pytest.param(SEEN, steady_everywhere, id="a condition asks at the end"),
        pytest.param(LUCK, steady_without_inputs, id="nothing else lets the agent step"),
    ],
)
def test_an_end_that_changes_something_is_a_move(
    text: str, spoil: Without, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, answers = explored(text, tmp_path / "a", "robot")
    spoil(monkeypatch)
    _, spoiled = explored(text, tmp_path / "b", "robot")
    monkeypatch.undo()
    without_steady(monkeypatch)
    _, others = explored(text, tmp_path / "c", "robot")
    assert answers == others != spoiled


def test_what_is_asked_at_any_age_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    reduced, answers = explored(ANY_AGE, tmp_path / "a", "chief", "robot")
    without_faded(monkeypatch)
    full, others = explored(ANY_AGE, tmp_path / "b", "chief", "robot")
    assert (answers, len(reduced.parents)) == (others, len(full.parents))


@pytest.mark.parametrize("text", [ASKED, MAY_FAIL], ids=["a condition asks for it", "it may fail"])
def test_what_decides_something_is_not_faint(
    text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reduced, answers = explored(text, tmp_path / "a", "robot")
    without_faint(monkeypatch)
    full, others = explored(text, tmp_path / "b", "robot")
    assert (answers, len(reduced.parents)) == (others, len(full.parents))


@pytest.mark.parametrize(
    ("text", "spoil"),
    [
        pytest.param(
            YOUNG,
            lambda patch: patch.setattr(Later, "said", lambda *_: ""),
            id="all contents are alike",
        ),
        pytest.param(
            ANY_AGE,
            lambda patch: patch.setattr(
                coming, "faded_in", lambda plan: {"team.state.Order": 0} if plan.name == "robot" else {}
            ),
            id="what is new is forgotten, too",
        ),
    ],
)
def test_one_that_leaves_out_too_much_is_noticed(
    text: str, spoil: Without, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found, answers = explored(text, tmp_path / "a", "chief", "robot")
    spoil(monkeypatch)
    others, spoiled = explored(text, tmp_path / "b", "chief", "robot")
    assert answers != spoiled or len(found.parents) != len(others.parents)


@pytest.mark.parametrize("seed", CHARTS)
def test_random_charts_have_the_same_answers(
    seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = chart_of(Timeless(seed))
    if compile_root(Source("it.aseme", text)).system is None:
        pytest.skip("not a chart")
    reduced, answers = explored(text, tmp_path / "a", "R", states=500)
    for without in REDUCTIONS:
        without(monkeypatch)
    full, others = explored(text, tmp_path / "b", "R", states=2000)
    if full.cut is not None or reduced.cut is not None:
        pytest.skip("too large")
    assert answers == others, text
    if "ROLES_CHARTS" in os.environ:
        print(seed, full.moves, reduced.moves, len(full.parents), len(reduced.parents), flush=True)


@pytest.mark.parametrize(
    ("example", "role"), [("goalie", "goalie"), pytest.param("patrol", "guard", marks=pytest.mark.long)]
)
def test_examples_have_the_same_answers(
    example: str, role: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = next(iter(sorted((EXAMPLES / example).glob("*.aseme"))))
    reduced, answers = explored(root, tmp_path / "a", role)
    for without in REDUCTIONS:
        without(monkeypatch)
    full, others = explored(root, tmp_path / "b", role, states=4000, seconds=120)
    assert reduced.cut is full.cut is None
    assert answers == others
    assert reduced.moves <= full.moves
