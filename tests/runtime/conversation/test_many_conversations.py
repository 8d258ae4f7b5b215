"""Very many conversations at once: none is lost, none takes what belongs to another."""

from __future__ import annotations

import threading
from collections import Counter
from typing import ClassVar

import pytest

from aseme_dsl.backends import jade_like, monas
from aseme_dsl.runtime import Context
from tests.runtime.playing import SECOND, Played, make
from tests.support.generated import Generated, generate
from tests.support.waiting import LONG

AGENTS, EACH = 100, 10

TEXT = """
system Crowd
message Question { int n  int asker }
message Answer   { int n  int square  int by }
message Thanks   { int n  int square }
aip ask {
  participant asker {
    var n : int = 0
    sends    request Question by Ask, confirm Thanks
    receives inform Answer
    process  = Ask . Wait . Compare
  }
  participant helper {
    var n : int = 0
    sends    inform Answer by Think
    receives request Question, confirm Thanks
    process  = Think . Rest . Part
  }
  control asker {
    enter Compare : inform Answer a from helper
                    / send confirm Thanks { n = a.n, square = a.square } to helper
  }
  control helper {
    enter Think : request Question from asker
    enter Part  : confirm Thanks from asker
  }
}
srm peer {
  plays ask.asker, ask.helper
  liveness { peer = asker[EACH] || helper[EACH] }
  activities {
    Ask writes n  Think writes n takes 1s  Compare takes 1ms  Part takes 1ms
    Wait takes 60min  Rest takes 60min
  }
}
"""


@pytest.fixture(scope="module", params=[monas, jade_like], ids=["monas", "jade_like"])
def crowd(request: pytest.FixtureRequest) -> Generated:
    return generate(TEXT.replace("EACH", str(EACH)), backend=request.param.BACKEND)


def number(agent: str) -> int:
    return int(agent.removeprefix("a"))


def talk(crowd: Generated, clock: str = "virtual") -> tuple[Played, Counter[str], list[str]]:
    """The run, what was found right, and what was found wrong."""
    right: Counter[str] = Counter()
    wrong: list[str] = []
    counting = threading.Lock()

    class Ask:
        """The k-th asker of an agent asks another: each agent is asked ten times, by ten others."""

        asked: ClassVar[Counter[str]] = Counter()

        def execute(self, context: Context) -> None:
            with counting:
                k = self.asked[context.agent]
                self.asked[context.agent] += 1
            me = number(context.agent)
            n = me * EACH + k
            context.set_variable("n", n)
            to = f"a{(me + 1 + 7 * k) % AGENTS}"
            context.send("request", crowd.message("Question", n=n, asker=me), to)

    class Think:
        def execute(self, context: Context) -> None:
            mail = context.last_received("request", "Question")
            assert mail is not None
            n = mail.content.n
            if mail.sender != f"a{n // EACH}" or mail.content.asker != n // EACH:
                wrong.append(f"{context.agent} was asked {n} by {mail.sender}")
            context.set_variable("n", n)
            answer = crowd.message("Answer", n=n, square=n * n, by=number(context.agent))
            context.send("inform", answer, "asker")

    class Compare:
        def execute(self, context: Context) -> None:
            mail = context.last_received("inform", "Answer")
            n = context.get_variable("n")
            assert mail is not None
            to = (number(context.agent) + 1 + 7 * (n % EACH)) % AGENTS
            if (mail.content.n, mail.content.square, mail.content.by) != (n, n * n, to):
                wrong.append(f"{context.agent} asked {n} and was told {mail.content} by {mail.sender}")
            with counting:
                right["answered"] += 1

    class Part:
        def execute(self, context: Context) -> None:
            mail = context.last_received("confirm", "Thanks")
            assert mail is not None
            if mail.content.n != context.get_variable("n"):
                wrong.append(
                    f"{context.agent} answered {context.get_variable('n')}: thanks for {mail.content.n}"
                )
            with counting:
                right["thanked"] += 1

    team, records = make(
        crowd,
        {"Ask": Ask, "Think": Think, "Compare": Compare, "Part": Part},
        agents=[(f"a{n}", "peer") for n in range(AGENTS)],
        until=round(LONG) * SECOND,
        clock=clock,
    )
    return Played(team, team.run(), records), right, wrong


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_a_thousand_conversations_among_a_hundred_agents(crowd: Generated, clock: str) -> None:
    run, right, wrong = talk(crowd, clock)
    total = AGENTS * EACH
    assert wrong == []
    assert right == {"answered": total, "thanked": total}
    assert (run.result.reason, run.result.failed) == ("finished", False), run.result
    assert run.of("unexpected") == []
    what = Counter((r["what"], r["participant"]) for r in run.of("conversation"))
    assert what == {
        ("open", "asker"): total,
        ("join", "helper"): total,
        ("leave", "asker"): total,
        ("leave", "helper"): total,
    }
    if clock == "virtual":  # there all are open at once
        opened = max(r["time"] for r in run.of("conversation") if r["what"] == "open")
        assert opened < min(r["time"] for r in run.of("conversation") if r["what"] == "leave")
    conversations = run.team.conversations
    assert conversations._members.conversations == {}
    assert len(run.of("agent_message")) == 3 * total
