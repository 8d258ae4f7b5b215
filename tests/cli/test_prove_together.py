"""`asemec prove`: what comes at one moment, in one step, where it makes a difference."""

from __future__ import annotations

import pytest

HEAD = """\
system Hall
message A { int n }
message B { int n }
topic hall { %s }
"""
LEADER = """\
srm leader {
  liveness { leader = Think . Talk . Rest }
  activities { Think takes 1s  Talk takes 1s  Rest waits }
  control leader { %s }
}
"""
FOLLOWER = """\
srm follower {
  var sum : int = 0
  liveness { follower = Idle~ }
  activities { Idle waits }
  control follower { repeat Idle : %s }
}
team Hall { %s one : follower }
property "it holds" { never one has [%s] }
"""
BOTH = "when [hall.signal.A.n == 1 && hall.signal.B.n == 1] / sum = 2"
SAYS_A = "hall.signal.A.n = 1; write_messages.hall.signal.A"
SAYS_B = "hall.signal.B.n = 1; write_messages.hall.signal.B"
SUMS = "when [hall.state.A.n != sum] / sum = sum + hall.state.A.n"
TALK = """\
system Mail
message A { int n }
message B { int n }
aip talk {
  participant caller { process = Dial . Wait }
  participant hearer {
    var sum : int = 0
    process = Listen . Note
  }
  control caller {
    enter Wait : / send request A { n = 0 } to hearer;
                   send inform A { n = 1 } to hearer; send inform B { n = 2 } to hearer
  }
  control hearer {
    enter Listen : request A from caller
    enter Note   : inform B from caller / sum = 2
    enter Note   : inform A from caller / sum = 1
  }
  outcome "noted" when Note@hearer
}
srm leader   { plays talk.caller  liveness { leader = caller }  activities { Dial takes 1s  Wait waits } }
srm follower { plays talk.hearer  liveness { follower = hearer }  activities { Listen waits  Note waits } }
team Hall { boss : leader  one : follower }
property "it holds" { never one has [sum == 2] }
"""


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(
            HEAD % "signal A  signal B"
            + LEADER % f"enter Talk : / {SAYS_A}; {SAYS_B}"
            + FOLLOWER % (BOTH, "boss : leader", "sum == 2"),
            id="two signals that one step sends",
        ),
        pytest.param(
            HEAD % "signal A  signal B"
            + LEADER % f"enter Talk : / {SAYS_A}"
            + (LEADER % f"enter Talk : / {SAYS_B}").replace("leader", "other")
            + FOLLOWER % (BOTH, "boss : leader  helper : other", "sum == 2"),
            id="signals of two agents",
        ),
        pytest.param(
            HEAD % "signal A from outside  signal B from outside" + FOLLOWER % (BOTH, "", "sum == 2"),
            id="two signals from outside",
        ),
        pytest.param(
            HEAD % "signal A from outside"
            + FOLLOWER % ("go [hall.signal.A.n == 1] / sum = 2", "", "sum == 2"),
            id="an event and a signal",
        ),
        pytest.param(
            HEAD % "signal A  state B"
            + LEADER % f"enter Talk : / {SAYS_A}; {SAYS_B.replace('signal', 'state')}"
            + FOLLOWER % (BOTH.replace("hall.signal.B", "hall.state.B"), "boss : leader", "sum == 2"),
            id="a state behind a signal",
        ),
        pytest.param(
            HEAD % "state A" + LEADER % "enter Talk : / hall.state.A.n = 1; write_messages.hall.state.A"
            "  enter Rest : / hall.state.A.n = 2; write_messages.hall.state.A"
            + FOLLOWER
            % (SUMS, "boss : leader", "sum == 2"),
            id="a state that is replaced before it is seen",
        ),
        pytest.param(
            HEAD % "state A"
            + LEADER % "enter Talk : / hall.state.A.n = 1; write_messages.hall.state.A"
            + FOLLOWER
            % (
                "go [hall.state.A.n == 1 && sum == 0] / sum = 2"
                "  repeat Idle : when [hall.state.A.n == 1 && sum == 0] / sum = 1",
                "boss : leader",
                "sum == 2",
            ),
            id="an event and a state",
        ),
        pytest.param(
            HEAD % "signal A from outside"
            + FOLLOWER.replace("Idle~", "Grasp . Idle")
            .replace("Idle waits", "Grasp takes 1s ends held, slipped  Idle waits")
            .replace("repeat Idle : %s", "enter Idle : %s  enter Idle : / sum = 1")
            % ("when [hall.signal.A.n == 1 && outcome(Grasp) == held] / sum = 2", "", "sum == 2"),
            id="a signal and the end of an activity",
        ),
        pytest.param(TALK, id="agent messages of which a later line awaits the first"),
    ],
)
def test_what_comes_together_may_be_taken_together(prove, text: str) -> None:  # type: ignore[no-untyped-def]
    done = prove(text, "it holds")
    assert done.out.startswith("REFUTED"), done.out


def test_times_of_what_comes_together_are_kept(prove) -> None:  # type: ignore[no-untyped-def]
    """Both signals are on their way for 100 ms at the least."""
    team = (
        HEAD % "signal A  signal B"
        + LEADER % f"enter Talk : / {SAYS_A}; {SAYS_B}"
        + FOLLOWER.partition("property")[0] % (BOTH, "boss : leader")
    )
    assumes = "assume network delay 100ms..300ms  assume Think takes 1s..2s"
    early = f'property "it holds" {{ {assumes}  no one has [sum == 2] before %sms }}\n'
    assert prove(team + early % 1100, "it holds").out.startswith("PROVED")
    assert prove(team + early % 1101, "it holds").out.startswith("REFUTED")


@pytest.mark.parametrize(
    ("formula", "lines"),
    [
        pytest.param("(Dig . Haul) [> Stop", "enter Stop : bump", id="an event that cuts short"),
        pytest.param(
            "(Stop | Haul) . Dig", "enter Stop : [hall.signal.A.n == 1]  enter Haul : else", id="a choice"
        ),
    ],
)
def test_something_may_come_before_the_first_step(prove, formula: str, lines: str) -> None:  # type: ignore[no-untyped-def]
    """Then it is there in that step, and in no later one."""
    text = (
        HEAD % "signal A from outside"
        + f"srm robot {{ liveness {{ robot = {formula} }} control robot {{ {lines} }} }}\n"
        + 'team Hall { one : robot }\nproperty "it holds" { one in Dig before one in Stop }\n'
    )
    assert prove(text, "it holds").out.startswith("REFUTED")


def test_the_newest_message_of_all_senders_is_seen(prove) -> None:  # type: ignore[no-untyped-def]
    """Two agents publish at one moment: what the first one says is never seen."""
    speaks = "enter Talk : / hall.state.A.n = 1; write_messages.hall.state.A"
    other = (LEADER % speaks.replace("n = 1", "n = 2")).replace("leader", "other")
    hears = FOLLOWER.partition("property")[0].replace("repeat Idle : %s", "on Idle : %s")
    text = (
        HEAD % "state A"
        + LEADER % speaks
        + other
        + hears % ("when [hall.state.A.n == 1] / sum = 1", "boss : leader  helper : other")
        + 'property "it holds" { every boss in Talk leads to one has [sum == 1] }\n'
    )
    assert prove(text, "it holds").out.startswith("REFUTED")
