"""jade_like: the tree of behaviours and the statechart say the same, for every chart that there is."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import BackendOptions, backend_names, find_backend
from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.compiler import analyse
from aseme_dsl.runtime.agent.behaviours import (
    Behaviour,
    CyclicBehaviour,
    FSMBehaviour,
    JadeLikeAgent,
    OneShotBehaviour,
    ParallelBehaviour,
    SequentialBehaviour,
    TickerBehaviour,
    WakerBehaviour,
)
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.conversation.directory import played
from tests.conftest import Snapshot
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.oracle.examples import forget
from tests.support.generated import Generated, generate, imported, system_of

ROOT = Path(__file__).parents[2]
FILES = sorted(
    path
    for path in [*(ROOT / "tests/acceptance").glob("*.aseme"), *ROOT.glob("examples/*/*.aseme")]
    if "\nsystem " in path.read_text("utf-8")
)
RANDOM = 40


def agent_of(made: Generated, role: str) -> JadeLikeAgent:
    """The agent of a role, of which nothing runs."""
    agents: dict[str, Any] = made.package.AGENTS
    made.charts[role]("me")
    shell: Any = SimpleNamespace(plan=made.plan(role), name="me", chart=made.chart(role))
    agent = agents[role](shell)
    assert isinstance(agent, JadeLikeAgent)
    return agent


def tree(agent: JadeLikeAgent) -> list[str]:
    """The behaviours as lines."""
    lines: list[str] = []
    depth: dict[int, int] = {}
    for item in agent.behaviours:
        depth[id(item)] = depth[id(item.parent)] + 1 if item.parent is not None else 0
        lines.append(f"{'  ' * depth[id(item)]}{item.name}: {kind(item).__name__}")
    return lines


def kind(item: Behaviour) -> type[Behaviour]:
    """The class of the runtime that a behaviour is of."""
    return next(base for base in type(item).__mro__ if base.__module__ == Behaviour.__module__)


def check(agent: JadeLikeAgent) -> None:
    """Everything that holds between a tree and its chart."""
    plan = agent.plan
    found = [item for item in agent.behaviours if not isinstance(item, WakerBehaviour)]
    states = [label for item in found for label in item.states]
    points = ("START", "END", "CONDITION")
    assert states == [state.label for state in plan.states if state.type not in points]

    ways = Counter(
        (w.source, w.target, w.text, w.stays) for item in agent.behaviours for w in item.transitions
    )
    assert ways == Counter((t.source, t.target, t.text, t.kind != "external") for t in plan.transitions)

    afters = [event for t in plan.transitions for event in t.events if event[0] == "after"]
    wakers = [item for item in agent.behaviours if isinstance(item, WakerBehaviour)]
    assert Counter(item.timeout for item in wakers) == Counter(event[1] for event in afters)
    assert all(plan.by_label[label].type != "CONDITION" for item in wakers for label in item.waits_in)

    assert agent.services == played("me", plan).services
    names = [item.name for item in agent.behaviours]
    assert len(set(names)) == len(names)
    for item in found:
        assert isinstance(item, wanted(plan, item)), (item, plan.by_label[item.states[-1]])
        around = plan.by_label[item.label].parent
        assert (item.parent.states[-1] if item.parent is not None else None) == around
        branch = next((b for b in plan.branches if b.label in item.states), None)
        said = (branch.protocol, branch.participant) if branch is not None else ("", "")
        assert (item.protocol, item.participant) == said


def wanted(plan: Plan, item: Behaviour) -> type[Behaviour]:
    """The kind of behaviour that a state is, said in another way than the backend says it."""
    state = plan.by_label[item.states[-1]]
    if state.type == "BASIC":
        activity = next(info for info in plan.activities if info.name == state.activity)
        return OneShotBehaviour if activity.every is None else TickerBehaviour
    if state.type == "AND":
        return ParallelBehaviour
    children = plan.children(state.label)
    ways = [
        t
        for t in plan.transitions
        if t.kind == "external" and t.source in {child.label for child in children}
    ]
    steps = [child.label for child in children if child.type != "CONDITION"]
    pairs = {(way.source, way.target) for way in ways}
    if any(way.first for way in ways) or len(steps) != len(children):
        return FSMBehaviour
    if [child.type for child in children[:1]] != ["START"] or len(children) < 2:
        return FSMBehaviour
    if (
        len(steps) == 2
        and children[1].type != "END"
        and pairs == {(steps[0], steps[1]), (steps[1], steps[1])}
    ):
        paces = {way.every for way in ways if way.source == way.target}
        return CyclicBehaviour if paces == {None} or len(paces) > 1 else TickerBehaviour
    ends = children[-1].type == "END" and len(children) > 2
    in_a_row = set(pairwise(steps))
    return SequentialBehaviour if ends and pairs == in_a_row else FSMBehaviour


def check_system(system: System) -> None:
    made = imported(system, BACKEND)
    try:
        for role in made.charts:
            check(agent_of(made, role))
    finally:
        forget(made)


def test_jade_like_is_found_by_its_name() -> None:
    assert "jade_like" in backend_names()
    assert find_backend("jade_like") is BACKEND


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_tree_of_a_real_system(path: Path) -> None:
    system = analyse(path).system
    assert system is not None
    check_system(system)


@pytest.mark.parametrize("seed", range(RANDOM))
def test_the_tree_of_a_random_chart(seed: int) -> None:
    check_system(system_of(text(Choices(seed))))


GIVEN = """
system Given

statechart lamp {
  var n : int = 0

  state 0   OR    lamp
  state 0.1 START
  state 0.2 CONDITION
  state 0.3 CONDITION
  state 0.4 BASIC On
  state 0.5 AND   Both
  state 0.5.1 OR left
  state 0.5.1.1 START
  state 0.5.1.2 BASIC On
  state 0.5.2 OR right
  state 0.5.2.1 START
  state 0.5.2.2 BASIC Off
  state 0.5.2.3 END
  state 0.6 BASIC class
  state 0.7 END

  0.1 -> 0.2 :
  0.2 -> 0.3 : [n < 3]
  0.2 -> 0.4 : else
  0.3 -> 0.5 : after(2s)
  0.3 -> 0.7 : after(5s) or stop
  0.4 -> 0.2 : / n = n + 1
  0.4 -> 0.6 : after(1s)
  0.5 -> 0.4 : after(1s)
  0.5.1.1 -> 0.5.1.2 :
  0.5.2.1 -> 0.5.2.2 :
  0.5.2.2 -> 0.5.2.3 :
  0.6 -> 0.7 :
}
"""


def test_a_chart_given_state_by_state() -> None:
    agent = agent_of(generate(GIVEN, backend=BACKEND), "lamp")
    check(agent)
    assert tree(agent) == [
        "Lamp: FSMBehaviour",
        "  LampAfter2s: WakerBehaviour",
        "  LampAfter5s: WakerBehaviour",
        "  OnAfter1s: WakerBehaviour",
        "  BothAfter1s: WakerBehaviour",
        "  On: OneShotBehaviour",
        "  Both: ParallelBehaviour",
        "    Left: OneShotBehaviour",
        "    Right: OneShotBehaviour",
        "  Class: OneShotBehaviour",
    ]


@pytest.mark.parametrize("role", ["dispatcher", "robot"])
def test_the_agents_of_contract_net(role: str, snapshot: Snapshot) -> None:
    """For people to read: what somebody who knows JADE sees first."""
    system = analyse(ROOT / "tests/acceptance/contract_net.aseme").system
    assert system is not None
    texts = {item.path: item.text for item in BACKEND.generate(system, BackendOptions())}
    snapshot(texts[f"Warehouse/{role}/agent.py"], f"{role}.agent.py.txt")
    snapshot(texts[f"Warehouse/{role}/behaviours.py"], f"{role}.behaviours.py.txt")


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What is generated from the acceptance files, the classes of the user among it."""
    folder = tmp_path_factory.mktemp("written")
    files = (path for path in FILES if path.parent.name == "acceptance")
    systems = [system for path in files if (system := analyse(path).system) is not None]
    for system in systems:
        for artefact in BACKEND.generate(system, BackendOptions()):
            if not artefact.kept or artefact.path.endswith("_agent.py"):
                path = folder / "jade_like" / artefact.path
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(artefact.text, encoding="utf-8")
    return folder


@pytest.mark.parametrize(
    "command",
    [("ruff", "check", "--isolated", "--no-cache", "."), ("mypy", "--strict", "-p", "jade_like")],
    ids=lambda command: command[0],
)
def test_the_usual_checkers_find_nothing_in_generated_code(written: Path, command: tuple[str, ...]) -> None:
    done = subprocess.run([sys.executable, "-m", *command], cwd=written, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
