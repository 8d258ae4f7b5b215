"""A `send` without braces: what was prepared, by whom, for how long; and what happens if nothing was."""

from __future__ import annotations

from typing import Any

from aseme_dsl.runtime import Context
from tests.runtime.playing import Played, play
from tests.support.generated import Generated, generate

TEXT = """
system S
message Task { string id }
message Bid { string id  int cost }
aip ask {
  participant asker {
    sends request Task, cancel Task
    receives propose Bid, agree Task
    process = PROCESS
  }
  participant teller { sends propose Bid, agree Task  receives request Task, cancel Task
    process = Consider . Hear }
  control asker {
    CONTROL
  }
  control teller {
    enter Consider : request Task from asker
    enter Hear : / send agree Task to asker
    leave Hear : cancel Task from asker
    leave Hear : after(20s)
  }
}
srm boss { plays ask.asker  liveness { boss = ROLE } }
srm worker { plays ask.teller  liveness { worker = teller~ } }
team T { ann : boss  tim : worker }
"""


def run(process: str, control: str, codes: dict[str, list[str | None]], role: str = "asker . Done") -> Played:
    text = TEXT.replace("PROCESS", process).replace("CONTROL", control).replace("ROLE", role)
    generated = generate(text)
    return play(generated, {name: _code(generated, ids) for name, ids in codes.items()}, until=60_000_000_000)


def _code(generated: Generated, ids: list[str | None]) -> type[Any]:
    """An activity that prepares a task with the next id, if it has one, and takes a second."""
    left = iter(ids)

    class Code:
        def execute(self, context: Context) -> None:
            found = next(left, None)
            if found is not None:
                context.prepare(generated.message("Task", id=found))
            context.wait(1)

    return Code


def said(played: Played, agent: str = "ann") -> list[str]:
    """What was sent; the last `cancel` tells an agent that was asked and has not answered."""
    records = played.of("agent_message", agent=agent)
    return [
        f"{r['performative']} {r['content'].get('id')}"
        for r in records
        if r["performative"] != "not_understood"
    ]


def test_what_is_prepared_too_late_fails_the_state_and_does_not_leak() -> None:
    """P5: the send stands on entering the activity that prepares it."""
    played = run("A . B", "enter A : / send request Task to teller", {"A": ["1"], "B": [None]})
    assert said(played) == []
    assert "activity A of state" in played.of("error")[0]["reason"]
    assert "nothing has prepared its content" in played.of("error")[0]["reason"]
    assert played.order("start") == [], "the activity does not start"


def test_the_failure_is_an_error_like_others() -> None:
    control = "enter A : / send request Task to teller\n    enter B : error"
    played = run("A . B", control, {"A": ["1"], "B": [None]})
    assert said(played) == [] and "start B" in played.order("start")


def test_content_is_used_up_and_then_repeated() -> None:
    control = """enter B : / send request Task to teller
    enter C : / send cancel Task to teller"""
    assert said(run("A . B . C", control, {"A": ["1"], "B": [None], "C": [None]})) == [
        "request 1",
        "cancel 1",
    ]
    assert said(run("A . B . C", control, {"A": ["1"], "B": ["2"], "C": [None]})) == ["request 1", "cancel 2"]


def test_before_the_part_only_for_the_message_that_opens() -> None:
    control = "enter A : / send request Task to teller"
    played = run("A . B", control, {"Plan": ["7"], "A": [None], "B": [None]}, "Plan . asker . Done")
    assert said(played) == ["request 7", "cancel 7"]


def test_each_concurrent_state_has_its_own() -> None:
    control = """leave A : / send request Task to teller
    leave B : / send cancel Task to teller"""
    played = run("A || B", control, {"A": ["1"], "B": ["2"]})
    assert sorted(said(played)) == ["cancel 2", "request 1"]


def test_what_a_cancelled_activity_prepared_ends_with_it() -> None:
    control = """enter B : after(100ms)
    enter C : / send request Task to teller"""
    played = run("A . B . C", control, {"A": ["1"], "B": [None], "C": [None]})
    assert said(played) == []
    control = "enter B : after(100ms) / send request Task to teller"
    assert said(run("A . B", control, {"A": ["1"], "B": [None]})) == ["request 1", "cancel 1"]


def test_a_new_part_does_not_know_the_content_of_the_last() -> None:
    control = "enter B : / send request Task to teller"
    played = run("A . B", control, {"A": ["1"], "B": ["2"], "Pause": []}, "(asker . Pause)~")
    assert said(played) == ["request 1", "cancel 1"], "what B has prepared belongs to the first part"


def test_activities_without_code_prepare_defaults() -> None:
    played = run("A . B", "enter B : / send request Task to teller", {})
    assert said(played) == ["request ", "cancel "]
    assert [r["message"] for r in played.of("default_content")] == ["Task"]


def test_an_answer_says_what_it_answers() -> None:
    played = run(
        "A . B", "enter B : / send request Task to teller", {"A": ["5"], "B": [None], "Consider": [None]}
    )
    assert said(played, "tim") == ["agree 5"]
