"""A message that may have come, or not: it stands for both only where nothing tells the two apart.

Each case is explored with and without what lets it stand: the same is reached, and taken, and waits for ever.
A few random charts are, too, in every run of the tests; many with `ABSENT_CHARTS=200`.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.playing.operate import generate_version, loaded_for
from aseme_dsl.proofs.explore.coming import Coming
from aseme_dsl.proofs.explore.deciding import later
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.search import Eyes, Graph, Limits, search
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.loading import Loaded
from aseme_dsl.source import Source
from tests.oracle.charts import text as chart_of
from tests.proofs.test_explored_charts import Timeless
from tests.proofs.test_reductions import _stuck

CHARTS = range(int(os.environ.get("ABSENT_CHARTS", "0"))) or (6, 8, 11, 22)
STATES = 500
"""Roles with more states are not compared."""
EXAMPLES = Path(__file__).parents[2] / "examples"
ROLE = """\
system Watch
message Note {{ int x bool on string s }}
topic t {{ state Note }}
function seen(Note note) : bool = "nowhere:seen"
srm watcher {{
  var n : int 0..3 = 0
  liveness {{ watcher = Idle . (A | (B . C)) . Rest }}
  control watcher {{
{lines}
  }}
}}
"""

SAME = {
    "only what is so is asked for": ["enter A : [t.state.Note.on]", "enter (B . C) : else"],
    "a value between two others": ["enter A : [t.state.Note.x < 3]", "enter (B . C) : [t.state.Note.x > 5]"],
    "only what is not so is asked for": [
        "enter A : [!(t.state.Note.on || t.state.Note.x == 3)]",
        "enter (B . C) : else",
    ],
    "the contrary is asked for later": [
        "enter A : [t.state.Note.on]",
        "enter (B . C) : [t.state.Note.x == 1 && t.state.Note.on]",
        "enter C : when [!t.state.Note.on]",
    ],
    "an amount": ["enter A : [abs(t.state.Note.x) < 3]", "enter (B . C) : else"],
    "a function": ["enter A : [seen(t.state.Note) && t.state.Note.on]", "enter (B . C) : else"],
    "a text": ['enter A : [t.state.Note.s == "a"]', 'enter (B . C) : [t.state.Note.s == "b"]'],
}
OTHER = {
    "one of two has to hold": ["enter A : [t.state.Note.on]", "enter (B . C) : [!t.state.Note.on]"],
    "equal or not": ["enter A : [t.state.Note.x == 3]", "enter (B . C) : [t.state.Note.x != 3]"],
    "no value is between": ["enter A : [t.state.Note.x < 3]", "enter (B . C) : [t.state.Note.x >= 3]"],
    "whether there is one": ["enter A : [has(t.state.Note)]", "enter (B . C) : else"],
    "whether there is none": ["enter A : [!has(t.state.Note)]", "enter (B . C) : [t.state.Note.on]"],
    "a function or its contrary": ["enter A : [seen(t.state.Note)]", "enter (B . C) : [!seen(t.state.Note)]"],
    "it is computed with": ["enter A : [t.state.Note.x + 1 < 3]", "enter (B . C) : else"],
    "compared with a variable": ["enter A : [t.state.Note.x == n]", "enter (B . C) : else"],
    "it is kept": ["enter A : [t.state.Note.on]", "enter (B . C) : else / n = t.state.Note.x"],
    "its age": ["enter A : [age(t.state.Note) < 1s]", "enter (B . C) : [age(t.state.Note) >= 1s]"],
    "the contrary is asked for behind": [
        "enter A : [t.state.Note.on]",
        "enter (B . C) : else",
        "enter C : [!t.state.Note.on]",
    ],
}


@dataclass(frozen=True, slots=True)
class Seen:
    """What was reached of one agent."""

    states: int
    places: frozenset[object]
    visited: frozenset[tuple[str, frozenset[str]]]
    taken: frozenset[object]
    stuck: frozenset[tuple[str, str]]
    ends: frozenset[object]

    @property
    def answers(self) -> tuple[object, ...]:
        return self.places, self.visited, self.taken, self.stuck, self.ends


def loaded_of(root: Path | Source, folder: Path) -> Loaded:
    compiled = compile_root(root)
    assert compiled.system is not None, compiled.diagnostics
    package, _ = generate_version(compiled.system, folder, choose(compiled.configuration))
    return loaded_for(package, Path())


def graph_of(loaded: Loaded, role: str, states: int = STATES) -> tuple[Explored, Graph]:
    eyes = Eyes()
    team = Explored(loaded, (("me", role),), Assumed(), [eyes])
    return team, search(team, eyes, None, Limits(states, 4.0))


def seen_of(loaded: Loaded, role: str, states: int = STATES) -> Seen | None:
    """What is reached; None if there are too many states."""
    team, graph = graph_of(loaded, role, states)
    if graph.cut is not None:
        return None
    return Seen(
        len(graph.parents),
        frozenset(graph.places),
        frozenset((name, frozenset(labels)) for name, labels in graph.visited.items()),
        frozenset(edge.taken for edges in graph.edges.values() for edge in edges),
        frozenset(_stuck(team, graph)),
        frozenset(graph.places[state] for state, edges in graph.edges.items() if not edges),
    )


def nothing_stands(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(Coming, "_standing", lambda *_: iter(()))


def _role(lines: Sequence[str]) -> Loaded:
    text = ROLE.format(lines="\n".join(f"    {line}" for line in lines))
    with TemporaryDirectory(prefix="absence-") as folder:
        return loaded_of(Source("watch.aseme", text), Path(folder))


@pytest.mark.parametrize("lines", SAME.values(), ids=SAME)
def test_what_nothing_tells_apart_is_explored_once(
    lines: Sequence[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded = _role(lines)
    team, _ = graph_of(loaded, "watcher")
    assert team.coming.standing == {"me": {"t.state.Note"}}
    reduced = seen_of(loaded, "watcher")
    nothing_stands(monkeypatch)
    full = seen_of(loaded, "watcher")
    assert full is not None and reduced is not None
    assert full.answers == reduced.answers
    assert full.states >= reduced.states
    if len(lines) == 2:
        assert full.states > reduced.states


@pytest.mark.parametrize("lines", OTHER.values(), ids=OTHER)
def test_a_state_in_which_nothing_has_come_is_not_lost(
    lines: Sequence[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded = _role(lines)
    reduced = seen_of(loaded, "watcher")
    nothing_stands(monkeypatch)
    assert seen_of(loaded, "watcher") == reduced


@pytest.mark.parametrize("name", ["one of two has to hold", "no value is between", "whether there is one"])
def test_one_that_stands_wrongly_is_noticed(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    loaded = _role(OTHER[name])
    before = seen_of(loaded, "watcher")
    monkeypatch.setattr(later, "tells_absence", lambda *_: False)
    after = seen_of(loaded, "watcher")
    assert before is not None and after is not None
    assert before.answers != after.answers


@pytest.mark.parametrize("seed", CHARTS)
def test_random_charts_do_the_same(seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = chart_of(Timeless(seed))
    if compile_root(Source("it.aseme", text)).system is None:
        pytest.skip("not a chart")
    loaded = loaded_of(Source("it.aseme", text), tmp_path)
    reduced = seen_of(loaded, "R")
    nothing_stands(monkeypatch)
    full = seen_of(loaded, "R", 4 * STATES)
    if full is None or reduced is None:
        pytest.skip("too large")
    assert full.answers == reduced.answers, text
    if "ABSENT_CHARTS" in os.environ:
        print(seed, full.states, reduced.states, flush=True)


@pytest.mark.parametrize(
    ("example", "role"),
    [
        pytest.param("goalie", "goalie", marks=pytest.mark.long),
        ("home", "porter"),
        ("warehouse", "porter"),
    ],
)
def test_examples_do_the_same(
    example: str, role: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    loaded = loaded_of(EXAMPLES / example / f"{example}.aseme", tmp_path)
    reduced = seen_of(loaded, role)
    nothing_stands(monkeypatch)
    full = seen_of(loaded, role)
    assert full is not None and reduced is not None
    assert full.answers == reduced.answers
