"""Files behind an alias: `import "alice.aseme" as alice`, `alice.attacker`."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from aseme_dsl.compiler import Analysis, analyse
from aseme_dsl.source import Source

COMMON = """\
message Ball { bool visible  double distance }
topic vision { state Ball }
"""

TEAM = """\
system Alice
import "common.aseme"
enum Side { LEFT RIGHT }
message Near { int distance  Side side }
topic mates { state Near }
function near(int d) : bool = "code:near"
let sees = vision.state.Ball.visible
aip talk {
  participant asker { sends request Near  process = Ask }
  participant desk { receives request Near  sends refuse Near  process = Serve }
  control asker { enter Ask : / send request Near { distance = 1, side = Side.LEFT } to desk }
  control desk { enter Serve : request Near n from asker [n.side == Side.LEFT] }
}
srm attacker {
  plays talk.asker, talk.desk
  var side : Side = Side.LEFT
  liveness { attacker = (Search | KickBall | asker | desk)+ }
  activities {
    KickBall ends hit, missed takes 1s reads mates.state.Near, vision.state.Ball writes mates.state.Near
    Search takes 2s  Ask takes 1s  Serve takes 1s
  }
  control attacker {
    enter KickBall : [sees && mates.state.Near.side == Side.RIGHT && near(mates.state.Near.distance)]
    enter asker : [side == Side.LEFT]
    enter desk : [side == Side.RIGHT && outcome(KickBall) == hit]
    enter Search : else
    repeat (Search | KickBall | asker | desk) : [!in(KickBall)]
    leave (Search | KickBall | asker | desk) : else
  }
}
team Alice { one : attacker }
"""

BOTH = """\
system Both
import "common.aseme"
import "alice.aseme" as alice
import "bob.aseme" as bob
message Seen { alice.Near near  bob.Side side }
topic all { state Seen  state alice.Near, bob.Near }
srm judge {
  plays alice.talk.desk as counter when busy refuse Near { distance = 0, side = alice.Side.LEFT }
  includes bob.attacker
  var side2 : alice.Side = alice.Side.RIGHT
  let close = alice.near(alice.mates.state.Near.distance) && x.alice.mates.state.Near.side == side2
  liveness { judge = Look . counter . attacker }
  activities { Look takes 1s reads alice.mates.state.Near, all.state.bob.Near writes all.state.Near }
  control judge { enter counter : [close && alice.sees && all.state.bob.Near.side == bob.Side.LEFT] }
}
team Both { x, y : alice.attacker  z : bob.attacker  referee : judge }
"""
FILES = {
    "common.aseme": COMMON,
    "alice.aseme": TEAM,
    "bob.aseme": TEAM.replace("Alice", "Bob").replace("Search takes 2s", "Search takes 3s"),
}


def analysed(text: str, files: Mapping[str, str] = FILES) -> Analysis:
    return analyse(Source("both.aseme", text), sources=dict(files))


def errors(text: str) -> list[tuple[str, str, str | None]]:
    found = [item for item in analysed(text).diagnostics if item.severity.value == "error"]
    return [(item.code, item.span.text if item.span else "", item.hint) for item in found]


def test_files_with_equal_names_stand_beside_each_other() -> None:
    analysis = analysed(BOTH)
    assert [str(item) for item in analysis.diagnostics if item.severity.value == "error"] == []
    system = analysis.system
    assert system is not None and system.name == "Both"
    assert [chart.name for chart in system.iacs] == ["alice_attacker", "bob_attacker", "judge"]
    assert {agent.name: agent.role for agent in system.teams[0].agents} == {
        "x": "alice_attacker",
        "y": "alice_attacker",
        "z": "bob_attacker",
        "referee": "judge",
    }
    assert len(system.teams) == 1
    names = {item.name for item in system.messages} | {item.name for item in system.topics}
    # What both files import is one: they can talk to each other.
    assert names == {"Ball", "vision", "alice_Near", "bob_Near", "alice_mates", "bob_mates", "Seen", "all"}
    activities = {item.name for item in system.activities}
    assert {"alice_KickBall", "bob_KickBall", "alice_Serve", "Look"} <= activities


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("y : alice", "y : alce", [("E228", "alce", "did you mean `alice`?")]),
        ('"bob.aseme" as bob', '"bob.aseme" as alice', [("E228", "alice", "rename one of them")]),
        ("as alice", "as judge", [("E228", "judge", "rename the alias")]),
        ("bob.Side side", "bob.Sid side", [("E228", "Sid", "did you mean `Side`?")]),
        ("alice.Near near", "Near near", [("E228", "Near", "write `alice.Near` or `bob.Near`")]),
        (
            "z : bob.attacker",
            "z : attacker",
            [("E228", "attacker", "write `alice.attacker` or `bob.attacker`")],
        ),
        ("&& alice.sees", "&& sees", [("E228", "sees", "write `alice.sees` or `bob.sees`")]),
        ("reads alice.mates", "reads mates", [("E228", "mates", "write `alice.mates` or `bob.mates`")]),
        ("plays alice.talk", "plays talk", [("E228", "talk", "write `alice.talk` or `bob.talk`")]),
    ],
)
def test_what_is_wrong_with_an_alias(old: str, new: str, told: list[tuple[str, str, str]]) -> None:
    found = errors(BOTH.replace(old, new, 1))
    assert [item for item in told if item not in found] == [], found
    assert found[0][0] == "E228"


@pytest.mark.parametrize(
    ("file", "old", "new", "told"),
    [
        ("both", "all.state.bob.Near.side ==", "all.state.bob.Near.sid ==", "`bob.Near` has no member `sid`"),
        ("both", "enter counter", "enter attackr", "did you mean `attacker`?"),
        (
            "both",
            "mates.state.Near.side == side2",
            "mates.state.Nea.side == side2",
            "did you mean `alice.Near`?",
        ),
        ("both", "", "", "read one agent's: `x.alice.mates.state.alice.Near`; "),
        ("both", "", "", "`state alice.Near from "),
        ("both", "", "", "it (`alice.Search`, `alice.Ask`"),
        ("alice", "&& mates.state.Near.side", "&& mates.state.Nea.side", "did you mean `Near`?"),
        ("alice", "&& mates.state.Near.side", "&& mats.state.Near.side", "did you mean `mates`?"),
        ("alice", "state Near }", "state Nea }", "did you mean `Near`?"),
        ("alice", "enter KickBall", "enter KickBal", "did you mean `KickBall`?"),
    ],
)
def test_what_is_told_says_names_as_its_file_writes_them(file: str, old: str, new: str, told: str) -> None:
    texts = {**FILES, "both.aseme": BOTH}
    assert old in texts[f"{file}.aseme"]
    texts[f"{file}.aseme"] = texts[f"{file}.aseme"].replace(old, new, 1)
    found = analysed(texts["both.aseme"], texts).diagnostics
    said = [f"{item.message}\n{item.hint}\n{item.fix}" for item in found]
    assert any(told in item for item in said), said
    assert not any("alice_" in item or "bob_" in item for item in said), said


def test_a_fix_behind_an_alias_compiles_as_it_is_written() -> None:
    text = BOTH.replace("x.alice.mates.state.Near", "x.alice.mates.state.alice.Near")
    assert errors(text) == []


@pytest.mark.parametrize("first", ["a", "b"])
def test_included_roles_of_equal_names_do_not_share_local_names(first: str) -> None:
    """`speed` is a variable in the `car` of `b.aseme`; in a role with the other, it is the `let`."""
    car = "abstract srm car { VAR liveness { car = Go . Rest } activities { Go takes 1s  Rest takes 1s } }\n"
    files = {
        "a.aseme": car.replace("VAR", ""),
        "b.aseme": car.replace("VAR", "var speed : int = 1"),
        "c.aseme": (
            'import "a.aseme" as a\nimport "b.aseme" as b\nlet speed = 9\n'
            "srm slow { includes a.car  liveness { slow = car . Stop }  activities { Stop takes 1s }\n"
            "control slow { enter Stop : [speed > 1] } }\n"
            "srm fast { includes b.car  liveness { fast = car . Stop }  activities { Stop takes 1s }\n"
            "control fast { enter Stop : [speed > 1] / speed = 2 } }\n"
        ),
    }
    if first == "b":
        order = '"a.aseme" as a\nimport "b.aseme" as b', '"b.aseme" as b\nimport "a.aseme" as a'
        files["c.aseme"] = files["c.aseme"].replace(*order)
    system = analysed('system S\nimport "c.aseme" as c\nteam T { x : c.fast  y : c.slow }\n', files).system
    assert system is not None
    assert [item.name for item in system.iac("c_fast").variables] == ["speed"]
    assert [item.name for item in system.iac("c_slow").variables] == []


def test_the_name_of_a_participant_that_its_role_has_is_told_as_it_is_written() -> None:
    text = """system P
aip talk { participant desk { process = Serve } }
srm desk {
  plays talk.desk
  liveness { desk = Think . desk }
  activities { Serve takes 1s  Think takes 1s }
  control desk { enter desc : after(1s) }
}
"""
    [item] = [item for item in analyse(Source("p.aseme", text)).diagnostics if item.severity.value == "error"]
    assert (item.code, item.hint) == ("E400", "did you mean `desk`?")


def test_an_alias_of_a_file_that_imports_the_root_is_a_circle() -> None:
    files = {**FILES, "alice.aseme": TEAM + 'import "both.aseme" as all\n'}
    assert "E005" in {item.code for item in analysed(BOTH, files).diagnostics}


def test_an_alias_in_a_file_behind_an_alias() -> None:
    files = {"a.aseme": 'import "b.aseme" as b\nmessage A { b.B b }\n', "b.aseme": "message B { int n }\n"}
    text = 'system S\nimport "a.aseme" as a\ntopic t { state a.A }\nsrm r { liveness { r = Go } }\n'
    system = analysed(text, files).system
    assert system is not None
    assert [item.name for item in system.messages] == ["a_b_B", "a_A"]


def test_a_role_has_the_name_of_its_participant() -> None:
    text = """\
system P
message Want { int n }
aip talk {
  participant asker { sends request Want  process = Ask }
  participant desk { receives request Want  process = Serve }
  control asker { enter Ask : / send request Want { n = 1 } to desk }
  control desk { enter Serve : request Want from asker }
}
srm asker { plays talk.asker  liveness { asker = asker }  activities { Ask takes 1s } }
srm desk {
  plays talk.desk
  liveness { desk = Think . desk~ }
  activities { Serve takes 1s  Think takes 1s }
  control desk { enter desk~ : }
}
team T { a : asker  d : desk }
"""
    analysis = analysed(text)
    assert analysis.diagnostics == ()
    assert analysis.system is not None
    desk = next(chart for chart in analysis.system.iacs if chart.name == "desk")
    assert [state.name for state in desk.states if state.name.startswith(("desk", "talk"))] == [
        "desk",
        "talk_desk~",
        "talk_desk",
    ]


def test_a_role_that_calls_its_participant_as_charts_do_is_told_what_to_write() -> None:
    text = """\
system P
message Want { int n }
aip talk {
  participant asker { sends request Want  process = Ask }
  participant desk { receives request Want  process = Serve }
  control asker { enter Ask : / send request Want { n = 1 } to desk }
  control desk { enter Serve : request Want from asker }
}
srm asker { plays talk.asker  liveness { asker = asker }  activities { Ask takes 1s } }
srm desk { plays talk.desk  liveness { desk = talk_desk~ }  activities { Serve takes 1s } }
team T { a : asker  d : desk }
"""
    [item] = [item for item in analysed(text).diagnostics if item.code.startswith("E")]
    assert (item.code, item.span.text) == ("E306", "desk")
    assert "`desk = desk`" in (item.hint or "")
    assert [(edit.span.text, edit.text) for edit in item.edits] == [("talk_desk", "desk")]
    assert analysed(text.replace("talk_desk", "desk")).diagnostics == ()
    without = analysed(text.replace("desk = talk_desk~", "desk = Serve~")).diagnostics
    assert [item.edits for item in without if item.code == "E306"] == [()]
