"""`asemec prove`: which waits nothing ends, and what never comes: small programs, each with one reason."""

from __future__ import annotations

import pytest

pytestmark = pytest.mark.long

HEAD = """\
system Hall
message Go { int n }
message Ball { bool near  int x }
topic team { signal Go }
topic eye { state Ball }
"""
GIVER = "srm b { liveness { b = Idle } activities { Idle writes team.signal.Go } }\n"
"""It may send, or not."""
SENDER = "srm b { liveness { b = Send~ } activities { Send writes team.signal.Go } }\n"
TEAM = "team T { one : a  two : b }\n"
GO = "when [team.signal.Go.n > 0]"
NEAR = "when [eye.state.Ball.near]"
RARE = "when [eye.state.Ball.x * 7 == 3500]"
"""What is true for none of the numbers that are tried."""
TALK = """\
aip talk {
  participant asker   { process = Ask . Hear }
  participant replier { process = Reply . Close }
  control asker   { enter Hear : / send request Go { n = 1 } to replier  leave Hear : inform Go from replier }
  control replier { enter Reply : request Go from asker / send inform Go { n = 1 } to asker }
}
"""


def robot(formula: str, *lines: str, more: str = "") -> str:
    """A robot of the role `a`."""
    return f"srm a {{ {more} liveness {{ a = {formula} }} control a {{ {'  '.join(lines)} }} }}\n"


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        pytest.param(robot("A . B", f"enter B : {GO}") + GIVER, "REFUTED", id="nothing comes"),
        pytest.param(
            robot("A+", f"repeat A : {GO}") + SENDER, "PROVED", id="a wait that ends where it began"
        ),
        pytest.param(
            robot("Q~ || (A . B)", f"enter B : {GO}") + GIVER, "REFUTED", id="beside one that moves"
        ),
        pytest.param(
            robot("(A . B) || Q~", f"enter B : {GO}") + GIVER, "REFUTED", id="before one that moves"
        ),
        pytest.param(
            robot("(A || B) . C", f"enter C : {GO}") + GIVER, "REFUTED", id="behind parts that have ended"
        ),
        pytest.param(
            robot("(A . B) . C", f"enter C : {GO}") + GIVER, "REFUTED", id="behind a part that has ended"
        ),
        pytest.param(robot("A || Q~", f"enter A : {GO}") + GIVER, "REFUTED", id="before a part begins"),
        pytest.param(robot("A || Q~") + GIVER, "PROVED", id="one has ended beside the other"),
        pytest.param(
            robot("A . B", f"enter B : {GO}", more="activities { A waits }") + GIVER, "PROVED", id="it waits"
        ),
        pytest.param(robot("A . B", f"enter B : {NEAR}") + GIVER, "PROVED", id="an input"),
        pytest.param(robot("A . B", f"enter B : {RARE}") + GIVER, "UNDECIDED", id="a rare input"),
        pytest.param(robot("A . B", "enter B : seen") + GIVER, "PROVED", id="an event"),
        pytest.param(
            robot(
                "(A . B) || (C . (D | E))",
                "enter B : seen",
                "enter D : [index == 2] / raise seen",
                "enter E : else",
            )
            + GIVER,
            "REFUTED",
            id="an event of its own",
        ),
        pytest.param(
            TALK
            + robot("(A . B) || replier~", f"enter B : {RARE}", more="plays talk.replier")
            + "srm b { plays talk.asker  liveness { b = asker } }\n",
            "UNDECIDED",
            id="an input beside a conversation that may begin",
        ),
    ],
)
def test_a_wait_that_nothing_ends(prove, text: str, verdict: str) -> None:  # type: ignore[no-untyped-def]
    done = prove(HEAD + text + TEAM, "deadlock", "--json")
    found = next(item for item in done.json["results"] if item["of"] == "team")
    assert found["verdict"] == verdict, found


def test_the_nearest_wait_is_shown(prove) -> None:  # type: ignore[no-untyped-def]
    far = robot("A . X . Y . Z . B", f"enter B : {GO}")
    near = (
        far.replace("srm a", "srm c")
        .replace("a =", "c =")
        .replace("control a", "control c")
        .replace("X . Y . Z . ", "")
    )
    for text, team in ((far + near, "one : a  three : c"), (near + far, "three : c  one : a")):
        done = prove(HEAD + text + GIVER + f"team T {{ {team}  two : b }}\n", "deadlock", "--json")
        (found,) = done.json["results"]
        assert found["reason"].startswith("three waits "), found


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        pytest.param(robot("A . B", "enter B : go"), "REFUTED", id="an event need not come"),
        pytest.param(robot("A . B"), "PROVED", id="an activity ends"),
        pytest.param(
            robot("A . (X | B)~", "enter B : [index == 2]", "enter X : else"), "REFUTED", id="a circle"
        ),
        pytest.param(robot("(A . X~) || (C . B)"), "PROVED", id="a circle that is not fair"),
        pytest.param(robot("(A . (X . Y)~) || (C . B)"), "PROVED", id="a longer one that is not fair"),
    ],
)
def test_what_is_awaited(prove, text: str, verdict: str) -> None:  # type: ignore[no-untyped-def]
    asked = 'property "it comes" { every one in A leads to one in B }\n'
    (found,) = prove(HEAD + text + "team T { one : a }\n" + asked, "it comes", "--json").json["results"]
    assert found["verdict"] == verdict, found
