"""How many agents take part as a participant: `[n..m]` is said of one conversation."""

from __future__ import annotations

import pytest

from aseme_dsl.runtime import Context
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import generate

TEXT = """
system S
message Task { int n }
aip ask {
  participant asker {
    sends request Task, query_ref Task by Name  receives inform Task
    process = Ask . Wait . Name
  }
  participant teller SIZE {
    sends inform Task  receives request Task, query_ref Task  process = Answer
  }
  control asker {
    enter Ask : / send request Task { .. } to teller
    enter Wait : after(1s)
  }
  control teller {
    enter Answer : request Task from asker / send inform Task to asker
  }
}
srm boss {
  plays ask.asker  liveness { boss = asker }  activities { Ask takes 50ms  Wait takes 1s  Name takes 1s }
}
srm worker { plays ask.teller  liveness { worker = teller~ }  activities { Answer takes 1ms } }
team T { ann : boss  tim, tam, tom : worker }
"""


def ask(size: str) -> Played:
    generated = generate(TEXT.replace("SIZE", size))

    class Name:
        def execute(self, context: Context) -> None:
            context.send("query_ref", generated.message("Task"), "tom")

    return play(generated, {"Name": Name}, until=10 * SECOND)


def asked(run: Played) -> list[list[str]]:
    return [r["to"] for r in run.of("agent_message", agent="ann")]


def faults(run: Played) -> list[str]:
    return [r["reason"] for r in run.of("fault") if "code" not in r]


FULL = "query_ref Task is not sent: {} takes part as teller already"


@pytest.mark.parametrize(
    ("size", "receivers", "said"),
    [
        ("[1..*]", [["tim", "tam", "tom"], ["tom"]], []),
        ("[3]", [["tim", "tam", "tom"], ["tom"]], []),
        ("[1..2]", [["tim", "tam"]], [FULL.format("tim, tam")]),
        ("[2]", [["tim", "tam"]], [FULL.format("tim, tam")]),
        ("", [["tim"]], [FULL.format("tim")]),
        (
            "[4..*]",
            [["tom"]],
            ["request Task is not sent: ask takes 4 or more teller, and there is tim, tam, tom"],
        ),
    ],
)
def test_so_many_are_invited(size: str, receivers: list[list[str]], said: list[str]) -> None:
    run = ask(size)
    assert asked(run) == receivers
    assert faults(run) == said
