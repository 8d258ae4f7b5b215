"""Asking why not, of random states at random times: what is told makes it happen if it is otherwise, and only
all of it does."""

from __future__ import annotations

import os
import random
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.play.asking.answer import Answer, Asking
from aseme_dsl.play.asking.question import NotAsked, goal_of
from aseme_dsl.play.asking.question import Question as Asked
from aseme_dsl.play.asking.ways import Goal
from aseme_dsl.project.testing.asking import Questions, questions
from aseme_dsl.runtime.chart.plan import State
from aseme_dsl.runtime.team.faults import Crash, Faults
from aseme_dsl.runtime.trace.trace_reading import TraceReader
from tests.cli.support import asemec
from tests.faults.changing import version
from tests.oracle import charts
from tests.oracle.choices import Choices
from tests.play.test_replay import recorded
from tests.runtime.playing import MS, SECOND
from tests.support.lanes import kept

EXAMPLES = Path(__file__).parents[2] / "examples"
NAMES = sorted(path.parent.name for path in EXAMPLES.glob("*/pyproject.toml"))
ASKED = int(os.environ.get("ASKED", "2"))
"""So many questions are asked about each run."""
CHARTS = range(int(os.environ["ASKED_CHARTS"])) if "ASKED_CHARTS" in os.environ else (0, 3, 6)
"""Random charts, by their seeds. That of the seed 2 takes ten times as long as these."""


@dataclass(frozen=True)
class Question:
    agent: str
    now: int
    state: State
    asking: Asking


def asked(trace: Questions, agents: list[str], end: int, chance: random.Random) -> Iterator[Question]:
    """Random states in which random agents are not at random times."""
    for _ in range(ASKED):
        agent, now = chance.choice(agents), chance.randrange(end + 1)
        asking = trace.at(agent, now)
        active = asking.search.active(asking.moment)
        states = [
            state
            for state in asking.teller.plan.states
            if state.label not in active and state.type in ("BASIC", "OR", "AND")
        ]
        if states:
            yield Question(agent, now, chance.choice(states), asking)


def check(question: Question) -> Answer:
    """The answer: it happens with all the changes, and with none of them left out."""
    goal = Goal(frozenset([question.state.label]))
    answer = question.asking.whynot(goal)
    search, what = question.asking.search, (question.agent, question.now, question.state)
    if not answer.stages:
        return answer
    assert search.happens(goal, answer.stages), what
    for place, stage in enumerate(answer.stages):
        for change in stage.changes:
            fewer = replace(stage, changes=tuple(item for item in stage.changes if item is not change))
            others = [*answer.stages[:place], fewer, *answer.stages[place + 1 :]]
            assert not search.happens(goal, others), (what, change)
    return answer


def run_of(trace: Path) -> tuple[list[str], int]:
    """The agents of a trace, and its last moment."""
    lines = [line.record for line in TraceReader(trace)]
    return [str(agent["name"]) for agent in lines[0]["agents"]], lines[-1]["time"]  # type: ignore[index]


@pytest.mark.parametrize("name", kept(NAMES, lambda name: name in ("auction", "cell", "patrol")))
def test_what_is_told_is_needed_and_enough_in_examples(name: str, tmp_path: Path) -> None:
    trace = tmp_path / "trace.jsonl.gz"
    length = "2s" if name == "robocup" else "10s"
    folder = tmp_path / "out"
    arguments = ("--for", length, "--seed", 3, "--trace", trace, "-o", folder, "--quiet")
    asemec("run", EXAMPLES / name, *arguments)
    agents, end = run_of(trace)
    chance = random.Random(f"asked {name}")
    with questions(trace) as found:
        answers = [check(question) for question in asked(found, agents, end, chance)]
    assert any(answer.stages for answer in answers)


@pytest.mark.parametrize("seed", CHARTS)
def test_what_is_told_is_needed_and_enough_in_random_charts(seed: int, tmp_path: Path) -> None:
    text = charts.text(Choices(seed))
    recorded(text, tmp_path, until=2 * SECOND)
    agents, end = run_of(tmp_path / "trace.jsonl")
    with questions(tmp_path / "trace.jsonl") as found:
        for question in asked(found, agents, end, random.Random(seed)):
            check(question)


def test_an_agent_that_is_down_has_crashed(tmp_path: Path) -> None:
    text = """
        system Down
        message Note { int n }
        topic t { state Note }
        srm one { liveness { one = Tell~ }  activities { Tell takes 100ms simulated writes t.state.Note } }
        srm two {
          liveness { two = A . B }
          activities { A takes 3s simulated  B takes 1s simulated }
          control two { enter B : [t.state.Note.n > 3] }
        }
        team Both { ann : one  bob : two }
    """
    crashes = (Crash("ann", 500 * MS, SECOND), Crash("bob", SECOND, 500 * MS))
    recorded(text, tmp_path, until=4 * SECOND, faults=Faults(crashes=crashes))
    with questions(tmp_path / "trace.jsonl") as found:
        for agent, what, now, text in (
            ("bob", "B", 1200 * MS, "it has stopped: it crashed at 1 s"),
            ("ann", "Tell", 700 * MS, "it has stopped: it crashed at 0.5 s"),
        ):
            asking = found.at(agent, now)
            answer = asking.whynot(goal_of(asking.teller.plan, what))
            assert [said.text for said in answer.said] == [text]
            assert answer.where == f"has stopped: {text.partition(': ')[2]}"
        asking = found.at("bob", 2 * SECOND)
        assert "A has not ended" in str(asking.whynot(goal_of(asking.teller.plan, "B")))


WALK = """
    system Walk
    message Seen { int n }
    topic eyes { signal Seen from outside }
    srm robot {
      liveness { robot = (FIRST . Walk)+ }
      activities { FIRST takes 20ms  Walk takes 70ms }
      control robot { leave (FIRST . Walk) : [eyes.signal.Seen.n > 900]  repeat (FIRST . Walk) : else }
    }
"""


def test_what_was_done_before_a_swap_is_asked_of_the_model_of_then(tmp_path: Path) -> None:
    def text(first: str) -> str:
        return WALK.replace("FIRST", first)

    def change(team: Any) -> None:
        team.swap(version(text("Look")), at=210 * MS)

    lines = recorded(text("Rest"), tmp_path, change, until=SECOND)
    swapped = next(line for line in lines if line["kind"] == "swap" and line["what"] == "done")
    with questions(tmp_path / "trace.jsonl") as found:
        answer = found.answer(Asked("me", "Rest", 900 * MS, is_why=True))
        assert "at 0.18 s it went to Rest from" in answer.said[0].text, swapped
        assert answer.is_so and answer.now >= 900 * MS
        assert found.answer(Asked("me", "Look", 900 * MS, is_why=True)).is_so
        with pytest.raises(NotAsked, match=r"Rest: .*; until 0.18 s it ran another model that has it"):
            found.answer(Asked("me", "Rest", 900 * MS, is_why=False))
        then = found.answer(Asked("me", "Rest", 150 * MS, is_why=False))
        assert "Walk has not ended" in str(then.said)


TALK = """
    system Talk
    message Note { int n }
    aip talk {
      participant asker  { sends request Note  receives inform Note  process = Ask . Hear }
      participant helper { sends inform Note  receives request Note  process = Help . Tell }
      control asker  {
        enter Hear : / send request Note { n = 1 } to helper
        leave Hear : inform Note m from helper [m.n > 5]
      }
      control helper {
        enter Help : request Note from asker
        enter Tell : / send inform Note { n = 7 } to asker
      }
    }
    srm one { plays talk.asker  liveness { one = asker . Rest }
      activities { Ask takes 100ms  Hear takes 1ms  Rest takes 1s } }
    srm two { plays talk.helper  liveness { two = helper }
      activities { Help takes 500ms  Tell takes 10ms } }
    team Two { ann : one  bob : two }
"""


def test_a_message_on_its_way_and_one_whose_content_does_not_do(tmp_path: Path) -> None:
    slow = Faults(delay=300 * MS, least_delay=300 * MS)
    recorded(TALK, tmp_path, until=2 * SECOND, faults=slow)
    with questions(tmp_path / "trace.jsonl") as found:
        on_its_way = str(found.answer(Asked("bob", "Help", 200 * MS, is_why=False)))
        assert "`request Note` from asker has not come in yet" in on_its_way
        assert "ann sent it at 0.1 s; bob has not received it yet" in on_its_way
        assert found.answer(Asked("ann", "Rest", 2 * SECOND, is_why=True)).is_so
    recorded(TALK.replace("n = 7", "n = 3"), tmp_path, until=2 * SECOND, file="few.jsonl")
    with questions(tmp_path / "few.jsonl") as found:
        few = str(found.answer(Asked("ann", "Rest", SECOND, is_why=False)))
        assert "`m.n > 5` does not hold" in few and "m.n is 3, 0.4 s old, from bob" in few


def test_a_long_way_is_found_and_a_longer_one_is_said_to_be_so(tmp_path: Path) -> None:
    for count, said in ((60, "60. to S60"), (120, "no way of at most 100 steps was found")):
        chain = " . ".join(f"S{place}" for place in range(count + 1))
        takes = " ".join(f"S{place} takes 1s" for place in range(count + 1))
        text = f"system Long  srm r {{ liveness {{ r = {chain} }}  activities {{ {takes} }} }}"
        recorded(text, tmp_path, until=1 * MS, file=f"{count}.jsonl")
        with questions(tmp_path / f"{count}.jsonl") as found:
            assert said in str(found.answer(Asked("me", f"S{count}", 0, is_why=False)))


def is_large(n: int) -> bool:
    """A function of a document."""
    return n > 1


CALLS = """
    system Calls
    function large(int n) : bool = "tests.play.test_asking:is_large"
    srm r {
      var n : int = 0
      liveness { r = (Go . (Left | Right))~ }
      activities { Go takes 100ms  Left takes 100ms  Right takes 100ms }
      control r {
        enter Left  : [large(n)] / n = -5
        enter Right : else / n += 1
      }
    }
"""


def test_why_shows_what_a_function_gave_then(tmp_path: Path) -> None:
    recorded(CALLS, tmp_path, until=1900 * MS)
    with questions(tmp_path / "trace.jsonl") as found:
        answer = str(found.answer(Asked("me", "Left", 1900 * MS, is_why=True)).said)
        assert "`large(n)` held" in answer and "what large gave last is true" in answer
        assert "n is 2" in answer and "at 0.5 s" in answer
        assert not any("probe" in item.text for item in found.at("me", SECOND).teller.plan.transitions)
